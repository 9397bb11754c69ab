// SPDX-License-Identifier: BSD-3-Clause
// The C interface seen from C++: statuses become exceptions, arrays become vectors, structs come with their
// size.
#pragma once

#include <hfrac/hfrac.h>
#include <hfrac/definition.hpp>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace hfrac::run {

/** A call of the engine that failed; the text is the engine's own. */
class EngineError : public std::runtime_error {
 public:
  EngineError(int32_t status, const std::string& text) : std::runtime_error(text), status_(status) {}
  int32_t status() const { return status_; }

 private:
  int32_t status_;
};

struct DestroySimulation {
  void operator()(hfrac_sim* sim) const { hfrac_sim_destroy(&sim); }
};
using Simulation = std::unique_ptr<hfrac_sim, DestroySimulation>;

/** The whole of a text that the C interface hands out piecewise; `call` takes (buffer, capacity, needed). */
template <class Call>
std::string whole_text(Call call) {
  int32_t needed = 0;
  call(nullptr, 0, &needed);
  if (needed <= 1) return {};
  std::string text(static_cast<size_t>(needed), '\0');
  call(text.data(), needed, &needed);
  text.resize(text.find('\0'));
  return text;
}

/** Throws EngineError if `status` is an error; notes such as HFRAC_NOT_AT_REST pass. `sim` may be NULL. */
void require(int32_t status, const hfrac_sim* sim);

/** Words for a failed status: the last error of `sim`, or the meaning of the status where there is none. */
std::string error_text(int32_t status, const hfrac_sim* sim);

/** A struct of the interface with all members 0 and its size filled in. */
template <class Struct>
Struct sized() {
  Struct value{};
  value.struct_size = static_cast<int32_t>(sizeof(Struct));
  return value;
}

std::vector<double> doubles(hfrac_sim* sim, int32_t field);
std::vector<int32_t> integers(hfrac_sim* sim, int32_t field);

Definition definition_of(const hfrac_sim* sim);
hfrac_sim_state state_of(const hfrac_sim* sim);
hfrac_setup_report setup_of(const hfrac_sim* sim);
hfrac_balance balance_of(const hfrac_sim* sim);
hfrac_solver_report solver_of(const hfrac_sim* sim);
int64_t state_hash_of(const hfrac_sim* sim);
/** The state as bytes that hfrac_state_restore takes. */
std::string state_image(const hfrac_sim* sim);
std::vector<hfrac_well_state> wells_of(const hfrac_sim* sim);

/** The whole crack log; find the fractures first, so that each crack knows its own. */
std::vector<hfrac_crack> cracks_of(hfrac_sim* sim);
/** The whole log of what smooth joints slipped. */
std::vector<hfrac_slip> slips_of(hfrac_sim* sim);
std::vector<hfrac_fracture> fractures_of(hfrac_sim* sim);
/** A fracture, by its index there, from tip to tip. */
std::vector<hfrac_fracture_point> line_of(hfrac_sim* sim, int64_t fracture);

std::string version_of_library();
std::string build_of_library();
/** The cards that run.device = "gpu" can use, a line each; with none, why. */
std::string devices_of_library(int32_t& count);
std::string case_text(const hfrac_sim_def& definition);

}  // namespace hfrac::run
