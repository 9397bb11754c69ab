// SPDX-License-Identifier: BSD-3-Clause
#include "build/build_model.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "build/fallen_discs.hpp"
#include "build/wellbores.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/workers.hpp"
#include "geom/faces.hpp"
#include "model/joint_pores.hpp"
#include "solid/joints.hpp"
#include "solid/softening.hpp"
#include "solid/toughness.hpp"

namespace hfrac {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Packing take_given(std::span<const double> discs) {
  Packing packing;
  const std::size_t n = discs.size() / 3;
  for (std::size_t i = 0; i < n; ++i) {
    packing.x.push_back(discs[3 * i]);
    packing.y.push_back(discs[3 * i + 1]);
    packing.radius.push_back(discs[3 * i + 2]);
  }
  return packing;
}

std::vector<std::int32_t> faces_of_wells(const CaseDefinition& definition, const ContactGraph& graph,
                                         const Faces& faces) {
  std::vector<std::int32_t> found;
  for (std::size_t w = 0; w < definition.wells.size(); ++w) {
    const auto& well = definition.wells[w];
    found.push_back(face_around(graph, faces, {well.x, well.y}));
    if (found.back() < 0) {
      throw Error(ErrorKind::model, "well[" + std::to_string(w) + "] at (" + std::to_string(well.x) + ", " +
                                        std::to_string(well.y) +
                                        ") m is not surrounded by rock; move it inward or make it smaller");
    }
  }
  return found;
}

}  // namespace

Packing take_discs(const CaseDefinition& definition, std::span<const double> given_discs,
                   const Progress& progress, SetupReport& report, const Packing* made, const Ranks& ranks) {
  const Options& o = definition.options;
  const auto start = std::chrono::steady_clock::now();
  bool stop = false;
  Packing packing;
  if (made != nullptr) {
    packing = *made;
  } else if (given_discs.empty()) {
    PackingOptions asked = packing_options(o);
    asked.sizes = grading_of(definition);
    Workers workers(static_cast<int>(o.run_workers));
    packing = pack_discs(
        asked, [&](double done) { return stop = progress && progress(0.5 * done, "packing the discs"); },
        &workers, ranks);
    if (stop) throw Stopped{};
  } else {
    packing = take_given(given_discs);
  }
  report.packing_residual = packing.residual;
  report.packed = static_cast<std::int64_t>(packing.x.size());
  report.fine_discs = report.packed;
  if (packing.sizes.graded()) {
    report.fine_discs = 0;
    for (std::size_t i = 0; i < packing.x.size(); ++i)
      report.fine_discs += packing.sizes.is_fine({packing.x[i], packing.y[i]}) ? 1 : 0;
  }
  double solid = 0.0;
  for (const double r : packing.radius) solid += std::numbers::pi * r * r;
  report.porosity = 1.0 - solid / (o.model_width * o.model_height);
  report.packing_seconds = seconds_since(start);
  return packing;
}

Model build_model(const CaseDefinition& definition, Packing packing,
                  std::span<const std::int64_t> given_bonds, SetupReport& report) {
  const Options& o = definition.options;
  Model model;
  Assembly& assembly = model.assembly;
  std::vector<Hole> holes;
  for (const auto& well : definition.wells) holes.push_back({{well.x, well.y}, well.radius});
  Faces faces;
  std::vector<std::int32_t> well_domains;
  report.joints = static_cast<std::int64_t>(definition.joints.size());
  for (std::int64_t fallen = 0;;) {
    ContactGraph graph = build_contact_graph(packing.x, packing.y, packing.radius, holes,
                                             o.bond_gap_tolerance, given_bonds, packing.sizes);
    if (definition.joints.empty()) packing = {};
    report.removed_in_wells = graph.removed_in_wells - fallen;
    report.removed_floaters = graph.removed_floaters + fallen;
    report.removed_crossings = graph.removed_crossings;
    report.unbonded = std::count(graph.bonded.begin(), graph.bonded.end(), 0);
    Hash bonded;
    bonded.add_all(graph.bonded);
    report.bonded = bonded.value();
    faces = build_faces(graph);
    well_domains = faces_of_wells(definition, graph, faces);
    assembly = build_assembly(std::move(graph), o);
    if (o.bond_fracture_toughness > 0.0 && FractureLaw{o.fracture_law} != FractureLaw::facet)
      apply_fracture_toughness(assembly, o);
    report.joints_left_out = apply_joints(assembly, definition.joints, o, model.cracks);
    // What falls is cut as by a hole of its own, so that a host's list of bonds still counts the discs that it gave.
    const auto loose = fallen_discs(assembly, definition.joints, faces, well_domains);
    if (loose.empty()) break;
    for (const auto i : loose) holes.push_back({{assembly.x[i], assembly.y[i]}, 0.5 * assembly.radius[i]});
    fallen += static_cast<std::int64_t>(loose.size());
    model.cracks.clear();
  }
  packing = {};
  if (o.bond_fracture_energy > 0.0) begin_softening(assembly, o);
  report.coarsest_radius = assembly.coarsest_radius();
  report.coordination =
      2.0 * static_cast<double>(assembly.bond_count()) / static_cast<double>(assembly.disc_count());
  for (std::size_t w = 0; w < definition.wells.size(); ++w) {
    const auto& given = definition.wells[w];
    Well well;
    well.place = {{given.x, given.y},
                  std::sqrt(faces.polygon_area[well_domains[w]] / std::numbers::pi),
                  well_domains[w]};
    well.drive.control = given.control;
    well.drive.target_pressure = given.pressure;
    well.drive.ramp_per_step = given.ramp_per_step;
    well.drive.set_rate = given.rate;
    well.drive.fluid = WellFluid{given.fluid};
    for (const auto& entry : definition.schedule) {
      if (entry.well == static_cast<std::int64_t>(w)) well.schedule.push_back(entry);
    }
    model.wells.push_back(well);
  }
  begin_wellbores(model, definition);
  model.network = build_network(std::move(faces), assembly, well_domains, o);
  begin_joint_pores(model.network, assembly, o);
  for (auto& wellbore : model.wellbores)
    wellbore.start_pressure = wellbore.pressure = model.network.reference_pressure;
  begin_holes(model, definition);
  model.well_count = model.wells.size();
  model.far_field = {o.stress_sigma_Hmax, o.stress_sigma_hmin, o.fluid_formation_pressure, false};
  return model;
}

}  // namespace hfrac
