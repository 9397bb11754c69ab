// SPDX-License-Identifier: BSD-3-Clause
// Whether a kept model fits a case: all that its making depended on, value by value. What may differ stands here by name; whatever is not
// named has to be the same, so that an option that comes later is on the safe side.
#include <algorithm>
#include <array>
#include <string_view>

#include "core/error.hpp"
#include "options/choices.hpp"
#include "options/number_text.hpp"
#include "step/packed_model.hpp"

namespace hfrac {
namespace {

// Used after the model came to rest, or not by the model at all.
constexpr std::array<std::string_view, 3> free_sections = {"run", "output", "stop"};
constexpr std::array<std::string_view, 30> free_options = {"packing.reuse",
                                                           "stepping.mode",
                                                           "stepping.flow_step",
                                                           "stepping.steps",
                                                           "stepping.end_time",
                                                           "fluid.viscosity",
                                                           "fluid.consistency",
                                                           "fluid.power_index",
                                                           "fluid.second_viscosity",
                                                           "fluid.second_density",
                                                           "flow.permeability",
                                                           "flow.zero_stress_aperture",
                                                           "flow.half_aperture_force",
                                                           "flow.gap_factor",
                                                           "flow.bonded_gap_factor",
                                                           "flow.aperture_limit",
                                                           "flow.solver",
                                                           "solver.pressure_change",
                                                           "solver.strength_overshoot",
                                                           "solver.smallest_step",
                                                           "solver.factor",
                                                           "thermal.fluid_temperature",
                                                           "thermal.conductivity",
                                                           "thermal.specific_heat",
                                                           "thermal.fluid_specific_heat",
                                                           "thermal.fluid_density",
                                                           "thermal.film_coefficient",
                                                           "thermal.outer",
                                                           "fracture.perforation_length",
                                                           "fracture.perforation_azimuth"};
constexpr std::array<std::string_view, 7> free_of_wells = {
    "control", "pressure", "ramp_per_step", "rate", "fluid", "perforation_length", "perforation_azimuth"};

template <class Names>
bool among(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string_view section_of(std::string_view key) {
  return key.substr(0, key.find('.'));
}

std::string text_of(const ValueInfo& info, double value) {
  const std::string unit = info.unit;
  if (info.type == ValueType::real) return number_text(value) + (unit == "1" ? "" : " " + unit);
  const auto index = static_cast<std::int64_t>(value);
  if (info.type == ValueType::choice && index >= 0 && index < choice_count(info.choices))
    return "\"" + std::string(choice_word(info.choices, index)) + "\"";
  return number_text(index);
}

class Fit {
 public:
  Fit(const PackedModel& model, const CaseDefinition& definition)
      : model_(model),
        case_(definition),
        discs_alone_(PackingReuse{definition.options.packing_reuse} == PackingReuse::discs) {}

  void require() const {
    for (const auto& info : option_table()) {
      const double here = get_value(case_.options, info), there = made_with(info);
      if (here != there && !may_differ(info.key, there)) refuse(info.key, info, here, there);
    }
    // Fine discs lie along lines through the wells; else wells are cut into the packing.
    const bool graded = case_.options.packing_coarsening > 1.0;
    if (!discs_alone_ || graded)
      require_items("well", model_.wells, case_.wells, well_option_table(), [&](std::string_view name) {
        return discs_alone_ ? name != "x" && name != "y" : among(free_of_wells, name);
      });
    if (!discs_alone_)
      require_items("joint", model_.joints, case_.joints, joint_table(),
                    [](std::string_view /*name*/) { return false; });
  }

 private:
  [[nodiscard]] double made_with(const OptionInfo& info) const {
    const auto found = std::find_if(model_.options.begin(), model_.options.end(),
                                    [&](const auto& option) { return option.key == info.key; });
    return found == model_.options.end() ? info.initial : found->value;
  }

  // An option whose value here is not `there`, the model's.
  [[nodiscard]] bool may_differ(std::string_view key, double there) const {
    const Options& o = case_.options;
    const auto section = section_of(key);
    if (key == "stop.extent_fraction")  // says how long the line of fine discs is
      return o.packing_coarsening == 1.0 || o.packing_fine_half_length > 0.0;
    if (discs_alone_) return key == "packing.reuse" || (section != "packing" && section != "model");
    // What has seeped into the rock before the treatment.
    if (key == "fluid.viscosity" || key == "flow.permeability")
      return InitialState{o.initial_state} == InitialState::uniform;
    // Of facets it is judged at tips, from their first step on.
    if (key == "bond.fracture_toughness")
      return FractureLaw{o.fracture_law} == FractureLaw::facet && o.bond_fracture_toughness > 0.0 &&
             there > 0.0;
    return among(free_sections, section) || among(free_options, key);
  }

  template <class Item, class Table, class Free>
  void require_items(const std::string& list, const std::vector<std::vector<double>>& there,
                     const std::vector<Item>& here, const Table& table, const Free& free) const {
    if (here.size() != there.size())
      refuse(list + "_count", std::to_string(here.size()), std::to_string(there.size()));
    for (std::size_t k = 0; k < here.size(); ++k) {
      for (std::size_t v = 0; v < table.size(); ++v) {
        const double value = get_value(here[k], table[v]),
                     made = v < there[k].size() ? there[k][v] : table[v].initial;
        if (value == made || free(table[v].key)) continue;
        refuse(list + "[" + std::to_string(k) + "]." + table[v].key, table[v], value, made);
      }
    }
  }

  void refuse(const std::string& key, const ValueInfo& info, double here, double there) const {
    refuse(key, text_of(info, here), text_of(info, there));
  }
  [[noreturn]] void refuse(const std::string& key, const std::string& here, const std::string& there) const {
    const auto section = section_of(key);
    const bool of_discs = section == "packing" || section == "model";
    throw Error(
        ErrorKind::model,
        key + " = " + here + ", but the model of packing.file was made with " + there +
            ": give that value, or make the file anew with hfrac pack" +
            (discs_alone_ || of_discs ? "" : ", or take its discs alone with packing.reuse = \"discs\"") +
            ".");
  }

  const PackedModel& model_;
  const CaseDefinition& case_;
  bool discs_alone_;
};

}  // namespace

void require_fit(const PackedModel& model, const CaseDefinition& definition) {
  Fit(model, definition).require();
}

}  // namespace hfrac
