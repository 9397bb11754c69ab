// SPDX-License-Identifier: BSD-3-Clause
// bmi_hfrac.h and the C++ face of the BMI in one file. What stands for bmi.hxx here defines the same constants and the same class name
// as the one that CSDMS publishes.
#include <bmi_hfrac.h>

#include <cstdio>
#include <cstring>

namespace bmi {
const int BMI_SUCCESS = 0;
const int BMI_FAILURE = 1;
const int MAX_COMPONENT_NAME = 2048;
const int MAX_VAR_NAME = 2048;
const int MAX_UNITS_NAME = 2048;
const int MAX_TYPE_NAME = 2048;
class Bmi {
 public:
  virtual ~Bmi() = default;
  virtual void Update() = 0;
};
}  // namespace bmi

static_assert(BMI_SUCCESS == bmi::BMI_SUCCESS && BMI_FAILURE == bmi::BMI_FAILURE);
static_assert(BMI_MAX_VAR_NAME == bmi::MAX_VAR_NAME);

int main() {
  Bmi model{};
  if (register_bmi_hfrac(&model) != &model) return 1;
  // Before initialize there is a text already for what cannot work.
  char text[256] = "";
  double time = 0.0;
  if (model.get_current_time(&model, &time) != BMI_FAILURE) return 2;
  if (bmi_hfrac_last_error(&model, text, sizeof text) != BMI_SUCCESS || std::strlen(text) == 0) return 3;
  if (model.initialize(&model, "/nowhere/case.toml") != BMI_FAILURE) return 4;
  if (bmi_hfrac_last_error(&model, text, sizeof text) != BMI_SUCCESS ||
      std::strstr(text, "/nowhere/case.toml") == nullptr)
    return 5;
  std::printf("%s\n", text);
  return 0;
}
