// SPDX-License-Identifier: BSD-3-Clause
// The table: function, whether it changes the simulation, which arguments may be NULL, good arguments in `g`.
#include "every_call.hpp"

namespace testing_capi {
namespace {

int32_t stop_at_once(void*, double, const char*) {
  return 1;
}
int32_t ignore_step(void*, hfrac_sim*, int64_t, double) {
  return 0;
}
int32_t ignore_message(void*, int32_t, const char*) {
  return 0;
}

using Optional = std::set<std::size_t>;
constexpr bool reads = false, changes = true;

#define ROW(function, changing, may_be_null, ...)      \
  make_row(#function, function, changing, may_be_null, \
           []([[maybe_unused]] Ground& g) { return std::make_tuple(__VA_ARGS__); })

std::vector<Row> without_a_simulation() {
  return {
      ROW(hfrac_version, reads, Optional(), &g.number, &g.other, &g.third),
      ROW(hfrac_abi_version, reads, Optional(), &g.number),
      ROW(hfrac_build_info, reads, Optional({2}), +g.text, 4096, &g.number),
      ROW(hfrac_devices, reads, Optional({3}), &g.other, +g.text, 4096, &g.number),
      ROW(hfrac_status_text, reads, Optional({3}), -1, +g.text, 4096, &g.number),
      ROW(hfrac_sim_def_init, reads, Optional(), g.empty_def(), static_cast<int32_t>(sizeof(hfrac_sim_def))),
      ROW(hfrac_sim_def_free, reads, Optional({0}), g.empty_def()),
      ROW(hfrac_sim_def_copy, reads, Optional(), &g.def, g.empty_def()),
      ROW(hfrac_sim_def_load, reads, Optional(), &g.def, g.case_file.c_str()),
      ROW(hfrac_sim_def_add_traces, reads, Optional(), g.empty_def(), g.trace_file.c_str()),
      ROW(hfrac_sim_def_write, reads, Optional({3}), &g.def, +g.text, 4096, &g.number),
      ROW(hfrac_sim_def_check, reads, Optional(), &g.def),
      ROW(hfrac_sim_def_check_file, reads, Optional(), &g.def, g.case_file.c_str()),
      ROW(hfrac_pack, reads, Optional(), &g.def, g.grdecl_file.c_str()),
      ROW(hfrac_sim_def_disc_radii, reads, Optional(), &g.def, &g.real, g.reals.data()),
      ROW(hfrac_sim_def_set_f64, reads, Optional(), &g.def, "stress.sigma_Hmax", 30e6),
      ROW(hfrac_sim_def_set_i64, reads, Optional(), &g.def, "model.seed", int64_t{1}),
      ROW(hfrac_sim_def_set_str, reads, Optional(), &g.def, "title", "a title"),
      ROW(hfrac_sim_def_get_f64, reads, Optional(), &g.def, "stress.sigma_Hmax", &g.real),
      ROW(hfrac_sim_def_get_i64, reads, Optional(), &g.def, "model.seed", &g.big),
      ROW(hfrac_sim_def_get_str, reads, Optional({4}), &g.def, "stress.sigma_Hmax", +g.text, 4096, &g.number),
      ROW(hfrac_option_count, reads, Optional(), &g.number),
      ROW(hfrac_option_at, reads, Optional(), 0, g.sized<hfrac_option_info>()),
      ROW(hfrac_well_option_count, reads, Optional(), &g.number),
      ROW(hfrac_well_option_at, reads, Optional(), 0, g.sized<hfrac_option_info>()),
      ROW(hfrac_field_find, reads, Optional(), "disc.radius", &g.number),
      ROW(hfrac_joint_option_count, reads, Optional(), &g.number),
      ROW(hfrac_joint_option_at, reads, Optional(), 0, g.sized<hfrac_option_info>()),
      ROW(hfrac_schedule_option_count, reads, Optional(), &g.number),
      ROW(hfrac_schedule_option_at, reads, Optional(), 0, g.sized<hfrac_option_info>()),
      ROW(hfrac_find_events, reads, Optional({3, 5}), g.cracks.data(),
          static_cast<int32_t>(sizeof(hfrac_crack)), int64_t{8},
          static_cast<const hfrac_catalogue_options*>(nullptr), static_cast<int32_t>(sizeof(hfrac_event)),
          g.several<hfrac_event>(), int64_t{8}, &g.big),
      ROW(hfrac_find_event_of_cracks, reads, Optional({3, 4}), g.cracks.data(),
          static_cast<int32_t>(sizeof(hfrac_crack)), int64_t{8},
          static_cast<const hfrac_catalogue_options*>(nullptr), g.several<int64_t>(), int64_t{8}, &g.big),
      ROW(hfrac_find_slip_events, reads, Optional({3, 5}), g.slips.data(),
          static_cast<int32_t>(sizeof(hfrac_slip)), int64_t{8},
          static_cast<const hfrac_catalogue_options*>(nullptr), static_cast<int32_t>(sizeof(hfrac_event)),
          g.several<hfrac_event>(), int64_t{8}, &g.big),
      ROW(hfrac_find_magnitude_law, reads, Optional(), g.reals.data(), int64_t{8}, -2.0,
          g.sized<hfrac_magnitude_law>()),
      ROW(hfrac_read_record, reads, Optional({2}), g.record_file.c_str(), 1.0, g.reals.data(), int64_t{8},
          &g.big),
      ROW(hfrac_lab_spec_init, reads, Optional(), &g.spec, static_cast<int32_t>(sizeof(hfrac_lab_spec))),
      ROW(hfrac_lab_run, reads, Optional({2, 3}), &g.def, &g.spec, static_cast<hfrac_progress_fn>(nullptr),
          static_cast<void*>(nullptr), &g.lab_made),
      ROW(hfrac_lab_destroy, reads, Optional({0}), &g.lab_made),
      ROW(hfrac_lab_get_report, reads, Optional(), g.lab, g.sized<hfrac_lab_report>()),
      ROW(hfrac_lab_copy_f64, reads, Optional({2}), g.lab, int32_t{HFRAC_LAB_DISCS}, g.reals.data(),
          static_cast<int64_t>(g.reals.size()), &g.big),
      ROW(hfrac_targets_init, reads, Optional(), &g.targets, static_cast<int32_t>(sizeof(hfrac_targets))),
      ROW(hfrac_calibrate, reads, Optional({2, 3}), &g.def, &g.targets,
          static_cast<hfrac_progress_fn>(nullptr), static_cast<void*>(nullptr), g.sized<hfrac_calibration>()),
      ROW(hfrac_sim_create, reads, Optional(), &g.def, &g.made),
      ROW(hfrac_exchange_init, reads, Optional(), &g.exchange, static_cast<int32_t>(sizeof(hfrac_exchange))),
      ROW(hfrac_linear_solver_init, reads, Optional(), &g.linear_solver,
          static_cast<int32_t>(sizeof(hfrac_linear_solver))),
      ROW(hfrac_sim_create_on, reads, Optional(), &g.def, &g.exchange, &g.made),
      ROW(hfrac_get_traffic, reads, Optional(), g.sim, g.sized<hfrac_traffic>()),
      ROW(hfrac_sim_destroy, reads, Optional({0}), &g.made),
  };
}

std::vector<Row> reading() {
  return {
      ROW(hfrac_last_error, reads, Optional({0, 3}), g.sim, +g.text, 4096, &g.number),
      ROW(hfrac_sim_definition, reads, Optional(), g.sim, g.empty_def()),
      ROW(hfrac_sim_get_state, reads, Optional(), g.sim, g.sized<hfrac_sim_state>()),
      ROW(hfrac_sim_get_setup, reads, Optional(), g.sim, g.sized<hfrac_setup_report>()),
      ROW(hfrac_get_balance, reads, Optional(), g.sim, g.sized<hfrac_balance>()),
      ROW(hfrac_sim_get_solver, reads, Optional(), g.sim, g.sized<hfrac_solver_report>()),
      ROW(hfrac_get_step_limits, reads, Optional(), g.sim, g.sized<hfrac_step_limits>()),
      ROW(hfrac_wall_count, reads, Optional(), g.sim, &g.number),
      ROW(hfrac_wall_get, reads, Optional(), g.sim, 0, g.sized<hfrac_wall_state>()),
      ROW(hfrac_state_hash, reads, Optional(), g.sim, &g.big),
      ROW(hfrac_well_count, reads, Optional(), g.sim, &g.number),
      ROW(hfrac_well_get, reads, Optional(), g.sim, 0, g.sized<hfrac_well_state>()),
      ROW(hfrac_field_info, reads, Optional(), g.sim, int32_t{HFRAC_DISC_RADIUS},
          g.sized<hfrac_field_desc>()),
      ROW(hfrac_field_copy_f64, reads, Optional({2}), g.sim, int32_t{HFRAC_DISC_RADIUS}, g.reals.data(),
          static_cast<int64_t>(g.reals.size()), &g.big),
      ROW(hfrac_field_copy_i32, reads, Optional({2}), g.sim, int32_t{HFRAC_BOND_STATE}, g.numbers.data(),
          static_cast<int64_t>(g.numbers.size()), &g.big),
      ROW(hfrac_field_view, reads, Optional({4}), g.sim, int32_t{HFRAC_DISC_RADIUS}, &g.data, &g.big,
          &g.next),
      ROW(hfrac_epoch, reads, Optional(), g.sim, &g.big),
      ROW(hfrac_cracks_since, reads, Optional({3, 6}), g.sim, int64_t{0},
          static_cast<int32_t>(sizeof(hfrac_crack)), g.several<hfrac_crack>(), int64_t{8}, &g.big, &g.next),
      ROW(hfrac_slips_since, reads, Optional({3, 6}), g.sim, int64_t{0},
          static_cast<int32_t>(sizeof(hfrac_slip)), g.several<hfrac_slip>(), int64_t{8}, &g.big, &g.next),
      ROW(hfrac_fractures, reads, Optional({2}), g.sim, static_cast<int32_t>(sizeof(hfrac_fracture)),
          g.several<hfrac_fracture>(), int64_t{8}, &g.big),
      ROW(hfrac_fracture_line, reads, Optional({3}), g.sim, int64_t{0},
          static_cast<int32_t>(sizeof(hfrac_fracture_point)), g.several<hfrac_fracture_point>(), int64_t{8},
          &g.big),
      ROW(hfrac_get_heat, reads, Optional(), g.sim, g.sized<hfrac_heat>()),
      ROW(hfrac_get_cell_temperature, reads, Optional({1}), g.sim, g.reals.data(), int64_t{4}, &g.big),
      ROW(hfrac_well_get_temperature, reads, Optional(), g.sim, 0, &g.real),
      ROW(hfrac_state_size, reads, Optional(), g.sim, &g.big),
      ROW(hfrac_state_save, reads, Optional({3}), g.sim, static_cast<void*>(g.bytes.data()),
          static_cast<int64_t>(g.bytes.size()), &g.big),
      ROW(hfrac_state_save_file, reads, Optional(), g.sim, g.state_file.c_str()),
      ROW(hfrac_grid_cells, reads, Optional({3}), g.sim, int32_t{HFRAC_UPSCALE_ODA},
          static_cast<int32_t>(sizeof(hfrac_cell)), g.several<hfrac_cell>(), int64_t{4}, &g.big),
      ROW(hfrac_write_grdecl, reads, Optional(), g.sim, g.grdecl_file.c_str(), int32_t{HFRAC_UPSCALE_ODA},
          int32_t{HFRAC_GRDECL_PERM}, int64_t{1}, 0.0, 0.0),
  };
}

std::vector<Row> changing() {
  return {
      ROW(hfrac_step, changes, Optional(), g.sim, int64_t{1}),
      ROW(hfrac_advance, changes, Optional(), g.sim, 1e6, &g.real, &g.number),
      ROW(hfrac_advance_to, changes, Optional(), g.sim, 1e6, &g.real, &g.number),
      ROW(hfrac_set_stop, changes, Optional(), g.sim, 0.42, int64_t{0}),
      ROW(hfrac_set_progress, changes, Optional({1, 2}), g.sim, stop_at_once, static_cast<void*>(nullptr),
          0.0),
      ROW(hfrac_set_on_step, changes, Optional({1, 2}), g.sim, ignore_step, static_cast<void*>(nullptr)),
      ROW(hfrac_set_log, changes, Optional({1, 2}), g.sim, ignore_message, static_cast<void*>(nullptr),
          int32_t{HFRAC_LOG_DETAIL}),
      ROW(hfrac_well_add, changes, Optional(), g.sim, 75.0, 60.0, &g.number),
      ROW(hfrac_well_set_pressure, changes, Optional(), g.sim, 0, 30e6),
      ROW(hfrac_well_set_ramp, changes, Optional(), g.sim, 0, 30e6, 1e6),
      ROW(hfrac_well_set_rate, changes, Optional(), g.sim, 0, 1e-6),
      ROW(hfrac_well_set_schedule, changes, Optional(), g.sim, 0, 1, g.reals.data(), g.numbers.data(),
          g.reals.data() + 8),
      ROW(hfrac_well_set_fluid, changes, Optional(), g.sim, 0, 0),
      ROW(hfrac_well_set_temperature, changes, Optional(), g.sim, 0, 300.0),
      ROW(hfrac_set_temperature, changes, Optional(), g.sim, 550.0),
      ROW(hfrac_set_disc_temperature, changes, Optional(), g.sim, g.kelvins.data(), g.discs),
      ROW(hfrac_set_cell_temperature, changes, Optional(), g.sim, g.kelvins.data(), int64_t{4}),
      ROW(hfrac_hold_disc_temperature, changes, Optional(), g.sim, g.numbers.data(), g.discs),
      ROW(hfrac_set_far_field, changes, Optional(), g.sim, 30e6, 30e6),
      ROW(hfrac_set_formation_pressure, changes, Optional(), g.sim, 25e6),
      ROW(hfrac_state_restore, changes, Optional(), g.sim, static_cast<const void*>(g.image.data()),
          static_cast<int64_t>(g.image.size())),
      ROW(hfrac_state_load_file, changes, Optional(), g.sim, g.state_file.c_str()),
      ROW(hfrac_step_prepare, changes, Optional(), g.sim),
      ROW(hfrac_step_do, changes, Optional(), g.sim, 1.0),
      ROW(hfrac_step_more, changes, Optional(), g.sim, 1.0),
      ROW(hfrac_step_finalize, changes, Optional(), g.sim),
      ROW(hfrac_step_reject, changes, Optional(), g.sim),
      ROW(hfrac_set_grid, changes, Optional(), g.sim, &g.grid),
      ROW(hfrac_set_boundary_pressure, changes, Optional(), g.sim, g.reals.data(), int64_t{4}),
      ROW(hfrac_set_cell_pressure, changes, Optional({3}), g.sim, g.reals.data(), int64_t{4},
          g.reals.data() + 8, int64_t{4}),
      ROW(hfrac_set_cell_stress, changes, Optional(), g.sim, g.reals.data(), int64_t{12}),
  };
}

}  // namespace

std::vector<Row> every_call() {
  std::vector<Row> rows = without_a_simulation();
  for (auto* more : {&reading, &changing})
    for (auto& row : more()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace testing_capi
