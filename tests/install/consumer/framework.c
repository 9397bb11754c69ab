/* SPDX-License-Identifier: BSD-3-Clause */
/* What a framework of the Basic Model Interface does with an installed model. */
#include <bmi_hfrac.h>
#include <stdio.h>

int main(int argc, char** argv) {
  Bmi model;
  double end = 0.0, length = 0.0;
  if (argc < 2 || register_bmi_hfrac(&model) == NULL || model.initialize(&model, argv[1]) != BMI_SUCCESS)
    return 1;
  model.get_end_time(&model, &end);
  if (model.update_until(&model, end) != BMI_SUCCESS) return 1;
  if (model.get_value(&model, "rock_fracture__length", &length) != BMI_SUCCESS) return 1;
  printf("fracture of %.1f m\n", length);
  return model.finalize(&model);
}
