// SPDX-License-Identifier: BSD-3-Clause
// State images that nobody saved: as they come, and real ones with changed bytes under a checksum that is right again, so that
// what lies behind it is reached. Refused and nothing changed, or restored; then a step ends with a status, and going back
// to the real image gives the real state.
//
// Input: first byte 0: the rest is an image. Otherwise it chooses the simulation (from 240 on the one with a temperature and a
// schedule), and the rest are changes of five bytes each: place (3), kind and size (1), value (1).
#include <hfrac/hfrac.h>
#include <hfrac/definition.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "../sealed_image.hpp"

namespace {

const char* cell = "";  // of the grid of edits below, while it is tried

void demand(bool good) {
  if (good) return;
  std::fprintf(stderr, "a demand of image_fuzz.cpp was not met%s\n", cell);
  std::abort();
}

struct Model {
  hfrac_sim* sim = nullptr;
  std::vector<std::uint8_t> image;
  int64_t hash = 0;
};

int64_t hash_of(hfrac_sim* sim) {
  int64_t hash = 0;
  demand(hfrac_state_hash(sim, &hash) == HFRAC_OK);
  return hash;
}

Model build(int64_t kind) {
  hfrac::Definition def;
  def.packing_disc_count = 60;
  def.packing_residual = 1e-2;
  def.stress_convention = 1;
  def.boundary_kind = kind == 1 ? 0 : 1;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = kind == 1 ? 1e6 : 0.0;
  def.stepping_max_cycles = 60;
  def.stepping_flow_step = 1e-2;
  def.solver_kind = kind == 2 ? 1 : 0;
  hfrac_sim_def_set_i64(&def, "well_count", 1);
  def.wells[0].x = def.wells[0].y = 50.0;
  def.wells[0].radius = 20.0;
  def.wells[0].pressure = 80e6;
  if (kind == 3) {
    def.thermal_mode = 2;
    hfrac_sim_def_set_i64(&def, "schedule_count", 1);
    def.schedule[0] = {0, 0.05, 1e-3, HFRAC_WELL_RATE, 0};
  }
  Model model;
  demand(hfrac_sim_create(&def, &model.sim) == HFRAC_OK);
  hfrac_step(model.sim, 2);
  int64_t size = 0;
  demand(hfrac_state_size(model.sim, &size) == HFRAC_OK);
  model.image.resize(static_cast<std::size_t>(size));
  demand(hfrac_state_save(model.sim, model.image.data(), size, &size) == HFRAC_OK);
  model.hash = hash_of(model.sim);
  return model;
}

void change(std::vector<std::uint8_t>& image, const std::uint8_t* edit) {
  const std::size_t place = (edit[0] | (edit[1] << 8U) | (edit[2] << 16U)) % image.size();
  const std::size_t room = image.size() - place;
  const std::uint8_t value = edit[4];
  const auto put = [&](auto number) {
    std::memcpy(image.data() + place, &number, std::min(room, sizeof number));
  };
  switch (edit[3] % 6) {
    case 0:
      image[place] = value;
      break;
    case 1:
      put(static_cast<std::int32_t>(static_cast<std::int8_t>(value)));
      break;
    case 2:
      put(static_cast<std::int64_t>(static_cast<std::int8_t>(value)) << (value & 56U));
      break;
    case 3:
      put(std::array{std::nan(""), std::numeric_limits<double>::infinity(), 1e300, -1e300, 0.0}[value % 5]);
      break;
    case 4:
      put(std::ldexp(1.0, value - 128));
      break;
    default:
      image.resize(std::max(testing_trust::image_head, image.size() - value));
  }
}

// Built once and destroyed at exit, so that nothing of them counts as lost.
struct Models {
  std::array<Model, 4> all = {build(0), build(1), build(2), build(3)};
  ~Models() {
    for (auto& model : all) hfrac_sim_destroy(&model.sim);
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Models built;
  const auto& models = built.all;
  if (size < 1) return 0;
  const Model& model = models[data[0] >= 240 ? 3 : data[0] % 3];
  std::vector<std::uint8_t> image;
  if (data[0] == 0) {
    image.assign(data + 1, data + size);
  } else {
    image = model.image;
    for (std::size_t k = 1; k + 5 <= size && k < 200; k += 5) change(image, data + k);
    testing_trust::seal(image);
  }
  const int32_t status = hfrac_state_restore(model.sim, image.data(), static_cast<int64_t>(image.size()));
  if (status < 0) {
    demand(status == HFRAC_ERR_ARGUMENT);
    demand(hash_of(model.sim) == model.hash);
    return 0;
  }
  hfrac_step(model.sim, 1);
  int64_t count = 0;
  hfrac_fractures(model.sim, sizeof(hfrac_fracture), nullptr, 0, &count);
  hfrac_balance balance{};
  balance.struct_size = sizeof balance;
  hfrac_get_balance(model.sim, &balance);
  demand(hfrac_state_restore(model.sim, model.image.data(), static_cast<int64_t>(model.image.size())) ==
         HFRAC_OK);
  demand(hash_of(model.sim) == model.hash);
  return 0;
}

// Before any file: single edits of the images of three models, from their head to their end.
extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** /*arguments*/) {
  constexpr std::array<std::array<std::uint8_t, 5>, 12> edits{{{0x28, 0x00, 0x00, 2, 0xff},
                                                               {0x30, 0x00, 0x00, 3, 0},
                                                               {0x30, 0x00, 0x00, 3, 1},
                                                               {0x30, 0x00, 0x00, 3, 2},
                                                               {0x2c, 0x01, 0x00, 4, 0xc8},
                                                               {0x88, 0x13, 0x00, 1, 0xc8},
                                                               {0x28, 0x23, 0x00, 2, 9},
                                                               {0x00, 0x00, 0x00, 0, 1},
                                                               {0x08, 0x00, 0x00, 0, 3},
                                                               {0x0c, 0x00, 0x00, 0, 9},
                                                               {0x20, 0x4e, 0x00, 5, 0x11},
                                                               {0x70, 0x11, 0x01, 3, 0}}};
  for (std::size_t k = 0; k < edits.size(); ++k) {
    for (std::uint8_t model = 1; model <= 3; ++model) {
      std::array<char, 64> name{};
      std::snprintf(name.data(), name.size(), ": edit %d of model %d", static_cast<int>(k), model % 3);
      cell = name.data();
      std::array<std::uint8_t, 6> input{model};
      std::copy(edits[k].begin(), edits[k].end(), input.begin() + 1);
      LLVMFuzzerTestOneInput(input.data(), input.size());
    }
  }
  cell = "";
  return 0;
}
