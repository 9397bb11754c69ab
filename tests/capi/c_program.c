/* SPDX-License-Identifier: BSD-3-Clause */
/* The interface as a C99 program sees it: no C++ anywhere, every result through a pointer, every function
 * called. */
#include <hfrac/hfrac.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

static void expect(int32_t status, int32_t wanted, const hfrac_sim* sim, const char* what) {
  if (status != wanted) {
    char text[1024];
    hfrac_last_error(sim, text, (int32_t)sizeof text, NULL);
    fprintf(stderr, "%s: status %d instead of %d: %s\n", what, (int)status, (int)wanted, text);
    ++failures;
  }
}

static void good(int32_t status, const hfrac_sim* sim, const char* what) {
  expect(status, HFRAC_OK, sim, what);
}

static void check(int holds, const char* what) {
  if (!holds) {
    fprintf(stderr, "not so: %s\n", what);
    ++failures;
  }
}

/* base.h */
static void library(void) {
  char text[1024];
  int32_t major = 0, minor = 0, patch = 0, abi = -1, needed = 0, devices = -1;
  good(hfrac_version(&major, &minor, &patch), NULL, "version");
  check(major == HFRAC_VERSION_MAJOR && minor == HFRAC_VERSION_MINOR && patch == HFRAC_VERSION_PATCH,
        "the library is the header's");
  good(hfrac_abi_version(&abi), NULL, "abi_version");
  check(abi == HFRAC_ABI_VERSION, "so is its ABI");
  good(hfrac_build_info(text, (int32_t)sizeof text, NULL), NULL, "build_info");
  printf("%s\n", text);
  good(hfrac_devices(&devices, text, (int32_t)sizeof text, NULL), NULL, "devices");
  check(devices >= 0 && text[0] != '\0', "devices, or why there are none");
  good(hfrac_status_text(HFRAC_ERR_MODEL, text, (int32_t)sizeof text, NULL), NULL, "status_text");
  good(hfrac_last_error(NULL, NULL, 0, &needed), NULL, "last_error");
}

/* def.h: every option of the table, read by its key */
static void list_options(const hfrac_sim_def* def) {
  int32_t count = 0, i;
  good(hfrac_option_count(&count), NULL, "option_count");
  for (i = 0; i < count; ++i) {
    hfrac_option_info info;
    double value = 0.0;
    memset(&info, 0, sizeof info);
    info.struct_size = (int32_t)sizeof info;
    good(hfrac_option_at(i, &info), NULL, "option_at");
    good(hfrac_sim_def_get_f64(def, info.key, &value), NULL, info.key);
    printf("%s = %g %s\n", info.key, value, info.unit);
  }
}

static void define(hfrac_sim_def* def, hfrac_well_def* well) {
  char text[8192];
  hfrac_option_info info;
  int64_t integer = 0;
  int32_t needed = 0, count = 0;
  double fine = 0.0, coarsest = 0.0;
  good(hfrac_sim_def_init(def, (int32_t)sizeof *def), NULL, "def_init");
  list_options(def);
  def->stress_sigma_Hmax = 0.0;
  def->packing_residual = 1e-3;
  good(hfrac_sim_def_set_f64(def, "stress.sigma_hmin", 0.0), NULL, "set_f64");
  good(hfrac_sim_def_set_i64(def, "packing.disc_count", 500), NULL, "set_i64");
  good(hfrac_sim_def_set_str(def, "stress.convention", "effective"), NULL, "set_str");
  good(hfrac_sim_def_set_str(def, "boundary.kind", "walls"), NULL, "set_str");
  good(hfrac_sim_def_set_str(def, "title", "from C"), NULL, "set_str");
  memset(well, 0, sizeof *well);
  well->x = well->y = 50.0;
  well->radius = 10.0;
  well->pressure = 60e6;
  well->control = HFRAC_WELL_PRESSURE;
  def->wells = well;
  def->well_count = 1;
  def->well_size = sizeof *well;
  good(hfrac_sim_def_check(def), NULL, "def_check");
  good(hfrac_sim_def_disc_radii(def, &fine, &coarsest), NULL, "def_disc_radii");
  check(fine > 0.0 && fine == coarsest, "a uniform packing has one mean radius");
  good(hfrac_sim_def_get_i64(def, "packing.disc_count", &integer), NULL, "get_i64");
  good(hfrac_sim_def_get_str(def, "boundary.kind", text, (int32_t)sizeof text, NULL), NULL, "get_str");
  check(integer == 500 && strcmp(text, "walls") == 0, "options are read in their own types");
  good(hfrac_well_option_count(&count), NULL, "well_option_count");
  memset(&info, 0, sizeof info);
  info.struct_size = (int32_t)sizeof info;
  good(hfrac_well_option_at(6, &info), NULL, "well_option_at");
  check(info.type == 2 && strcmp(info.key, "control") == 0, "a well's values are listed");
  good(hfrac_joint_option_count(&count), NULL, "joint_option_count");
  good(hfrac_joint_option_at(0, &info), NULL, "joint_option_at");
  check(count == 21 && strcmp(info.key, "x1") == 0, "a joint's values are listed");
  good(hfrac_schedule_option_count(&count), NULL, "schedule_option_count");
  good(hfrac_schedule_option_at(1, &info), NULL, "schedule_option_at");
  check(count == 5 && strcmp(info.key, "time") == 0, "an entry's values are listed");
  good(hfrac_sim_def_write(def, text, (int32_t)sizeof text, &needed), NULL, "def_write");
  check(needed == (int32_t)strlen(text) + 1, "the text has the size it says");

  well->radius = -1.0;
  expect(hfrac_sim_def_check(def), HFRAC_ERR_ARGUMENT, NULL, "negative radius");
  expect(hfrac_sim_def_check_file(def, "case.toml"), HFRAC_ERR_CASE_FILE, NULL, "negative radius in a file");
  well->radius = 10.0;
  expect(hfrac_sim_def_load(def, "/nonexistent/case.toml"), HFRAC_ERR_CASE_FILE, NULL, "missing file");
  expect(hfrac_sim_def_add_traces(def, "/nonexistent/traces.csv"), HFRAC_ERR_CASE_FILE, NULL, "no traces");
}

/* sim.h */
static int32_t on_progress(void* user, double fraction, const char* what) {
  ++*(int*)user;
  check(fraction >= 0.0 && fraction <= 1.0 && what != NULL, "progress makes sense");
  return 0;
}

static int32_t on_message(void* user, int32_t level, const char* message) {
  ++*(int*)user;
  check(level >= HFRAC_LOG_ERROR && level <= HFRAC_LOG_DETAIL && message[0] != 0, "messages make sense");
  return 0;
}

static int32_t on_step(void* user, hfrac_sim* sim, int64_t step, double time) {
  ++*(int*)user;
  check(sim != NULL && time > 0.0, "steps make sense");
  return step == 3; /* stop */
}

static void run(hfrac_sim* sim) {
  hfrac_sim_def def, copy;
  hfrac_sim_state state;
  hfrac_setup_report setup;
  hfrac_balance balance;
  hfrac_solver_report solver;
  int64_t before = 0, after = 0, epoch = 0, later = 0;
  int32_t reason = -1;
  hfrac_step_limits limits;
  int calls = 0, messages = 0, steps = 0;
  double reached = 0.0;

  good(hfrac_sim_def_init(&def, (int32_t)sizeof def), NULL, "def_init");
  good(hfrac_sim_definition(sim, &def), sim, "definition");
  check(def.packing_disc_count == 500 && strcmp(def.title, "from C") == 0, "the definition comes back");
  check(def.well_count == 1 && def.wells[0].pressure == 60e6, "with its well");
  good(hfrac_sim_def_init(&copy, (int32_t)sizeof copy), NULL, "def_init");
  good(hfrac_sim_def_copy(&def, &copy), NULL, "def_copy");
  good(hfrac_sim_def_free(&def), NULL, "def_free");
  check(def.well_count == 0 && def.wells == NULL, "its list is gone");
  check(copy.well_count == 1 && copy.wells[0].pressure == 60e6, "the copy has its own");
  good(hfrac_sim_def_free(&copy), NULL, "def_free");
  setup.struct_size = (int32_t)sizeof setup;
  good(hfrac_sim_get_setup(sim, &setup), sim, "get_setup");
  check(setup.packed_discs == 500 && setup.mean_radius > 0.0, "the set-up is reported");

  good(hfrac_set_progress(sim, on_progress, &calls, 0.0), sim, "set_progress");
  good(hfrac_state_hash(sim, &before), sim, "state_hash");
  good(hfrac_epoch(sim, &epoch), sim, "epoch");
  good(hfrac_set_on_step(sim, on_step, &steps), sim, "set_on_step");
  good(hfrac_set_log(sim, on_message, &messages, HFRAC_LOG_DETAIL), sim, "set_log");
  good(hfrac_step(sim, 1), sim, "step");
  expect(hfrac_advance(sim, 10.0, &reached, &reason), HFRAC_STOPPED, sim, "advance");
  check(reached == 3.0 && reason == HFRAC_REASON_CALLBACK, "stopped after the third step");
  expect(hfrac_advance_to(sim, 2.0, &reached, &reason), HFRAC_ERR_ARGUMENT, sim, "advance_to");
  good(hfrac_set_stop(sim, 1.0, 0), sim, "set_stop");
  good(hfrac_set_progress(sim, NULL, NULL, 0.0), sim, "set_progress");
  check(messages >= 3 && steps == 3, "callbacks were called");
  good(hfrac_set_on_step(sim, NULL, NULL), sim, "set_on_step");
  good(hfrac_set_log(sim, NULL, NULL, 0), sim, "set_log");
  good(hfrac_state_hash(sim, &after), sim, "state_hash");
  good(hfrac_epoch(sim, &later), sim, "epoch");
  check(before != after && epoch < later && calls > 3, "steps were taken");
  expect(hfrac_step(sim, -1), HFRAC_ERR_ARGUMENT, sim, "negative count");

  state.struct_size = (int32_t)sizeof state;
  good(hfrac_sim_get_state(sim, &state), sim, "get_state");
  check(state.time == 3.0 && state.step == 3 && state.crack_count > 0, "the state is reported");
  limits.struct_size = (int32_t)sizeof limits;
  good(hfrac_get_step_limits(sim, &limits), sim, "get_step_limits");
  check(limits.binding == HFRAC_LIMIT_NONE && limits.flow_step == 1.0, "nothing limits an implicit step");
  balance.struct_size = (int32_t)sizeof balance;
  good(hfrac_get_balance(sim, &balance), sim, "get_balance");
  check(balance.injected_volume > 0.0 && fabs(balance.fluid_error) < 1e-6 * balance.injected_volume,
        "the fluid balance closes");
  solver.struct_size = (int32_t)sizeof solver;
  good(hfrac_sim_get_solver(sim, &solver), sim, "get_solver");
  check(solver.kind == 0 && solver.newton_iterations == 0, "the explicit solver has no iterations");
}

static void drive_well(hfrac_sim* sim) {
  hfrac_well_state well;
  int32_t count = 0, added = 0;
  double injected;
  const double times[2] = {0.0, 6.5}, values[2] = {0.0, 2e6};
  const int32_t controls[2] = {HFRAC_WELL_RATE, HFRAC_WELL_PRESSURE};
  good(hfrac_well_count(sim, &count), sim, "well_count");
  check(count == 1, "there is one well");
  well.struct_size = (int32_t)sizeof well;
  good(hfrac_well_get(sim, 0, &well), sim, "well_get");
  check(well.pressure == 60e6 && well.control == HFRAC_WELL_PRESSURE, "it is held");
  injected = well.injected_volume;
  good(hfrac_well_set_rate(sim, 0, 1e-3), sim, "well_set_rate");
  good(hfrac_step(sim, 2), sim, "step");
  good(hfrac_well_get(sim, 0, &well), sim, "well_get");
  check(fabs(well.injected_volume - injected - 2e-3) < 1e-9, "it takes its rate");
  good(hfrac_well_set_ramp(sim, 0, 1e6, 100e6), sim, "well_set_ramp");
  good(hfrac_step(sim, 1), sim, "step");
  good(hfrac_well_get(sim, 0, &well), sim, "well_get");
  check(well.pressure == 1e6 && well.control == HFRAC_WELL_RAMP, "it is ramped");
  good(hfrac_well_set_schedule(sim, 0, 2, times, controls, values), sim, "well_set_schedule");
  good(hfrac_step(sim, 2), sim, "step");
  good(hfrac_well_get(sim, 0, &well), sim, "well_get");
  check(well.pressure == 2e6 && well.control == HFRAC_WELL_PRESSURE, "it follows its schedule");
  good(hfrac_well_set_fluid(sim, 0, HFRAC_WELL_FLUID_FIRST), sim, "well_set_fluid");
  expect(hfrac_well_set_fluid(sim, 0, HFRAC_WELL_FLUID_SECOND), HFRAC_ERR_ARGUMENT, sim, "no second fluid");
  check(well.fluid == HFRAC_WELL_FLUID_FIRST, "it pumps the only fluid");
  good(hfrac_well_set_pressure(sim, 0, 60e6), sim, "well_set_pressure");
  expect(hfrac_well_get(sim, 1, &well), HFRAC_ERR_ARGUMENT, sim, "no second well");
  good(hfrac_well_add(sim, 75.0, 60.0, &added), sim, "well_add");
  good(hfrac_well_set_pressure(sim, added, 1e6), sim, "well_set_pressure");
  good(hfrac_step(sim, 1), sim, "step");
  good(hfrac_well_get(sim, 1, &well), sim, "well_get");
  check(added == 1 && well.pressure == 1e6, "there is a second well");
}

/* field.h: every field of the list, copied and viewed */
static void look(hfrac_sim* sim, int32_t field, const char* name) {
  hfrac_field_desc desc;
  int64_t count = 0, there = 0, epoch = 0;
  int32_t found = -1;
  const void* data = NULL;
  void* copy;
  size_t size;
  good(hfrac_field_find(name, &found), NULL, "field_find");
  check(found == field, name);
  desc.struct_size = (int32_t)sizeof desc;
  good(hfrac_field_info(sim, field, &desc), sim, "field_info");
  check(strcmp(desc.name, name) == 0, name);
  count = desc.count * desc.components;
  size = (size_t)count * (desc.dtype == 0 ? sizeof(double) : sizeof(int32_t));
  copy = malloc(size);
  if (desc.dtype == 0) {
    good(hfrac_field_copy_f64(sim, field, (double*)copy, count, &there), sim, "field_copy_f64");
  } else {
    good(hfrac_field_copy_i32(sim, field, (int32_t*)copy, count, &there), sim, "field_copy_i32");
  }
  check(there == count, name);
  good(hfrac_field_view(sim, field, &data, &there, &epoch), sim, "field_view");
  check(there == count && epoch == desc.epoch && memcmp(copy, data, size) == 0, name);
  free(copy);
}

#define LOOK(name, value, key, unit, location, dtype, components, help) look(sim, name, key);
static void fields(hfrac_sim* sim) {
  HFRAC_FIELD_LIST(LOOK)
}

/* crack.h */
static void cracks(hfrac_sim* sim) {
  hfrac_crack page[2];
  hfrac_fracture largest;
  hfrac_fracture_point end;
  int64_t cursor = 0, count = 0, next = 0, all = 0;
  good(hfrac_cracks_since(sim, 0, (int32_t)sizeof page[0], NULL, 0, &all, NULL), sim, "cracks_since");
  do {
    good(hfrac_cracks_since(sim, cursor, (int32_t)sizeof page[0], page, 2, &count, &next), sim,
         "cracks_since");
    check(count == 0 || page[0].id == cursor, "cracks are numbered");
    cursor = next;
  } while (count > 0 && failures == 0);
  check(cursor == all && all > 0, "all cracks were seen");
  good(hfrac_fractures(sim, (int32_t)sizeof largest, &largest, 1, &count), sim, "fractures");
  check(count > 0 && largest.length > 0.0 && largest.well == 0, "there is a fracture at the well");
  good(hfrac_fracture_line(sim, 0, (int32_t)sizeof end, &end, 1, &count), sim, "fracture_line");
  check(count > 0 && end.length > 0.0 && end.tip == 1, "its line begins at a tip");
}

/* catalogue.h */
static void catalogue(hfrac_sim* sim) {
  hfrac_crack first[2];
  hfrac_event event;
  hfrac_magnitude_law law;
  int64_t count = 0, events = 0, event_of[2] = {-1, -1};
  good(hfrac_cracks_since(sim, 0, (int32_t)sizeof first[0], first, 2, &count, NULL), sim, "cracks_since");
  good(hfrac_find_events(first, (int32_t)sizeof first[0], count, NULL, (int32_t)sizeof event, &event, 1,
                         &events),
       NULL, "find_events");
  check(events > 0 && event.moment > 0.0 && event.first_crack == 0, "the first crack is an event");
  good(hfrac_find_event_of_cracks(first, (int32_t)sizeof first[0], count, NULL, event_of, 2, &count), NULL,
       "find_event_of_cracks");
  check(event_of[0] == 0, "cracks know their event");
  law.struct_size = (int32_t)sizeof law;
  good(hfrac_find_magnitude_law(&event.magnitude, 1, event.magnitude, &law), NULL, "find_magnitude_law");
  check(law.count == 1 && law.b == 0.0, "one magnitude has no slope");
}

/* record.h */
static void records(void) {
  double rows[6] = {0};
  int64_t count = -1;
  FILE* file = fopen("c_program_record.csv", "w");
  check(file != NULL, "a record can be written");
  if (file == NULL) return;
  fputs("time_min,rate_L_s,pressure_bar\n0,5,100\n2,0,90\n", file);
  fclose(file);
  good(hfrac_read_record("c_program_record.csv", 50.0, rows, 2, &count), NULL, "read_record");
  check(count == 2 && rows[0] == 0.0 && rows[3] == 120.0, "rows have times");
  check(rows[1] > 0.99e-4 && rows[1] < 1.01e-4 && rows[4] == 0.0 && rows[5] == 90e5, "in SI units");
  expect(hfrac_read_record("/nonexistent/record.csv", 1.0, NULL, 0, &count), HFRAC_ERR_CASE_FILE, NULL,
         "no record");
  remove("c_program_record.csv");
}

/* slip.h */
static void slips(hfrac_sim* sim) {
  hfrac_slip slip;
  hfrac_event event;
  int64_t count = -1, next = -1;
  good(hfrac_slips_since(sim, 0, (int32_t)sizeof slip, &slip, 1, &count, &next), sim, "slips_since");
  check(count == 0 && next == 0, "nothing slips without smooth joints");
  memset(&slip, 0, sizeof slip);
  slip.step = 1;
  slip.normal[0] = slip.length = slip.slip = slip.distance = 1.0;
  slip.shear_modulus = 3e10;
  good(hfrac_find_slip_events(&slip, (int32_t)sizeof slip, 1, NULL, (int32_t)sizeof event, &event, 1, &count),
       NULL, "find_slip_events");
  check(count == 1 && event.kind == HFRAC_EVENT_SLIP && fabs(event.moment / 3e10 - 1.0) < 1e-12,
        "a slip is an event");
}

static void pack_and_begin(void) {
  hfrac_sim_def def;
  hfrac_sim* sim = NULL;
  memset(&def, 0, sizeof def);
  good(hfrac_sim_def_init(&def, (int32_t)sizeof def), NULL, "def_init");
  def.packing_disc_count = 200;
  def.packing_residual = 1e-3;
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  good(hfrac_pack(&def, "c_program.model"), NULL, "pack");
  strcpy(def.packing_file, "c_program.model");
  good(hfrac_sim_create(&def, &sim), NULL, "sim_create from a packed model");
  good(hfrac_sim_destroy(&sim), NULL, "sim_destroy");
  def.stress_sigma_Hmax = 34e6;
  expect(hfrac_sim_create(&def, &sim), HFRAC_ERR_MODEL, NULL, "a model under another stress");
  remove("c_program.model");
}

/* state.h */
static void go_back(hfrac_sim* sim) {
  int64_t size = 0, written = 0, before = 0, after = 0;
  void* image;
  good(hfrac_state_hash(sim, &before), sim, "state_hash");
  good(hfrac_state_size(sim, &size), sim, "state_size");
  image = malloc((size_t)size);
  good(hfrac_state_save(sim, image, size, &written), sim, "state_save");
  check(written == size, "the image has the size it says");
  good(hfrac_step(sim, 1), sim, "step");
  good(hfrac_state_restore(sim, image, size), sim, "state_restore");
  good(hfrac_state_hash(sim, &after), sim, "state_hash");
  check(before == after, "the image is restored");
  free(image);

  good(hfrac_step_prepare(sim), sim, "step_prepare");
  good(hfrac_step_do(sim, 1.0), sim, "step_do");
  good(hfrac_step_more(sim, 0.5), sim, "step_more");
  good(hfrac_step_reject(sim), sim, "step_reject");
  good(hfrac_state_hash(sim, &after), sim, "state_hash");
  check(before == after, "the step is undone");
  good(hfrac_step_prepare(sim), sim, "step_prepare");
  good(hfrac_step_do(sim, 0.5), sim, "step_do");
  good(hfrac_step_finalize(sim), sim, "step_finalize");
  good(hfrac_state_hash(sim, &after), sim, "state_hash");
  check(before != after, "the step is kept");
  expect(hfrac_set_far_field(sim, 1e6, 1e6), HFRAC_ERR_ARGUMENT, sim, "walls that are fixed");
  good(hfrac_set_formation_pressure(sim, 26e6), sim, "set_formation_pressure");

  good(hfrac_state_save_file(sim, "c_program.state"), sim, "state_save_file");
  good(hfrac_state_hash(sim, &before), sim, "state_hash");
  good(hfrac_step(sim, 1), sim, "step");
  good(hfrac_state_load_file(sim, "c_program.state"), sim, "state_load_file");
  good(hfrac_state_hash(sim, &after), sim, "state_hash");
  check(before == after, "the file is loaded");
  remove("c_program.state");
  expect(hfrac_state_load_file(sim, "c_program.state"), HFRAC_ERR_FILE, sim, "a file that is gone");
}

static void walls(hfrac_sim* sim) {
  hfrac_wall_state wall;
  int32_t count = 0;
  good(hfrac_wall_count(sim, &count), sim, "wall_count");
  check(count == 4, "there are four walls");
  wall.struct_size = (int32_t)sizeof wall;
  good(hfrac_wall_get(sim, 1, &wall), sim, "wall_get");
  check(wall.normal[0] == -1.0 && wall.moves == 0, "the right one looks left and is fixed");
}

/* grid.h */
static void exchange(hfrac_sim* sim) {
  const char* path = "c_program.grdecl";
  hfrac_grid grid;
  hfrac_cell cells[4];
  hfrac_balance balance;
  double pressure[4] = {0.0, 0.0, 1e5, 1e5}, stress[12] = {0.0}, added[4];
  double cracks = 0.0;
  int64_t count = 0;
  int c;
  memset(&grid, 0, sizeof grid);
  grid.struct_size = (int32_t)sizeof grid;
  grid.nx = grid.ny = 2;
  grid.dx = grid.dy = 50.0;
  good(hfrac_set_grid(sim, &grid), sim, "set_grid");
  good(hfrac_grid_cells(sim, HFRAC_UPSCALE_FLOW, (int32_t)sizeof cells[0], cells, 4, &count), sim,
       "grid_cells");
  check(count == 4, "four cells");
  for (c = 0; c < 4; ++c) {
    cracks += cells[c].crack_length;
    check(cells[c].area == 2500.0 && cells[c].coverage > 0.5 && cells[c].matrix_permeability > 0.0,
          "cells are filled");
  }
  check(cracks > 0.0, "the cells have cracks");
  good(hfrac_set_cell_pressure(sim, pressure, 4, added, 4), sim, "set_cell_pressure");
  balance.struct_size = (int32_t)sizeof balance;
  good(hfrac_get_balance(sim, &balance), sim, "get_balance");
  check(fabs(balance.host_volume - (added[0] + added[1] + added[2] + added[3])) < 1e-12,
        "the host's fluid is accounted for");
  good(hfrac_set_boundary_pressure(sim, pressure, 4), sim, "set_boundary_pressure");
  expect(hfrac_set_cell_stress(sim, stress, 12), HFRAC_ERR_ARGUMENT, sim, "stress on walls");
  good(hfrac_write_grdecl(sim, path, HFRAC_UPSCALE_ODA, HFRAC_GRDECL_PERM, 1, 0.0, 0.0), sim, "write_grdecl");
  check(remove(path) == 0, "the file is there");
}

/* lab.h */
static void rock_tests(void) {
  hfrac_sim_def def;
  hfrac_lab_spec spec;
  hfrac_lab_report report;
  hfrac_targets targets;
  hfrac_calibration found;
  hfrac_lab* lab = NULL;
  int64_t count = 0;
  good(hfrac_sim_def_init(&def, (int32_t)sizeof def), NULL, "def_init");
  good(hfrac_lab_spec_init(&spec, (int32_t)sizeof spec), NULL, "lab_spec_init");
  spec.disc_count = 500;
  good(hfrac_lab_run(&def, &spec, NULL, NULL, &lab), NULL, "lab_run");
  memset(&report, 0, sizeof report);
  report.struct_size = (int32_t)sizeof report;
  good(hfrac_lab_get_report(lab, &report), NULL, "lab_get_report");
  check(report.modulus > 10e9 && report.modulus < 18e9 && report.value == report.modulus,
        "rock has a modulus");
  good(hfrac_lab_copy_f64(lab, HFRAC_LAB_DISCS, NULL, 0, &count), NULL, "lab_copy_f64");
  check(count == 5 * report.disc_count, "five values a disc");
  good(hfrac_lab_destroy(&lab), NULL, "lab_destroy");
  check(lab == NULL, "the test is gone");
  good(hfrac_targets_init(&targets, (int32_t)sizeof targets), NULL, "targets_init");
  targets.modulus = 20e9;
  targets.disc_count = 500;
  targets.packings = 1;
  memset(&found, 0, sizeof found);
  found.struct_size = (int32_t)sizeof found;
  good(hfrac_calibrate(&def, &targets, NULL, NULL, &found), NULL, "calibrate");
  check(def.bond_normal_stiffness > 5.152e9 && found.test_count == 2, "stiffer rock takes stiffer bonds");
}

/* heat.h */
static void warm(hfrac_sim_def* def) {
  hfrac_sim* sim = NULL;
  hfrac_heat heat;
  hfrac_grid grid;
  double cells[2] = {550.0, 560.0}, kelvin = 0.0;
  double* discs;
  int32_t* held;
  int64_t count = 0, number;
  def->thermal_mode = 2;
  good(hfrac_sim_create(def, &sim), NULL, "create with a temperature");
  if (sim == NULL) return;
  good(hfrac_field_copy_f64(sim, HFRAC_DISC_TEMPERATURE, NULL, 0, &count), sim, "count of discs");
  discs = malloc((size_t)count * sizeof *discs);
  held = calloc((size_t)count, sizeof *held);
  good(hfrac_field_copy_f64(sim, HFRAC_DISC_TEMPERATURE, discs, count, &count), sim, "disc.temperature");
  discs[0] += 10.0;
  held[0] = 1;
  good(hfrac_set_temperature(sim, 540.0), sim, "set_temperature");
  good(hfrac_set_disc_temperature(sim, discs, count), sim, "set_disc_temperature");
  good(hfrac_hold_disc_temperature(sim, held, count), sim, "hold_disc_temperature");
  memset(&grid, 0, sizeof grid);
  grid.struct_size = (int32_t)sizeof grid;
  grid.nx = 2;
  grid.ny = 1;
  grid.dx = 50.0;
  grid.dy = 100.0;
  good(hfrac_set_grid(sim, &grid), sim, "set_grid");
  good(hfrac_set_cell_temperature(sim, cells, 2), sim, "set_cell_temperature");
  good(hfrac_well_set_temperature(sim, 0, 300.0), sim, "well_set_temperature");
  expect(hfrac_step(sim, 1) >= 0 ? HFRAC_OK : HFRAC_ERR_INTERNAL, HFRAC_OK, sim, "step");
  good(hfrac_well_get_temperature(sim, 0, &kelvin), sim, "well_get_temperature");
  check(kelvin == 300.0, "the well is as cold as told");
  good(hfrac_get_cell_temperature(sim, cells, 2, &number), sim, "get_cell_temperature");
  check(number == 2 && cells[0] < cells[1], "cells keep their order");
  memset(&heat, 0, sizeof heat);
  heat.struct_size = (int32_t)sizeof heat;
  good(hfrac_get_heat(sim, &heat), sim, "get_heat");
  check(heat.mode == 2 && heat.wells < 0.0 && fabs(heat.error) < 1e-6 * fabs(heat.host),
        "the heat balance closes");
  free(discs);
  free(held);
  good(hfrac_sim_destroy(&sim), NULL, "destroy");
}

/* One rank needs no functions. */
static void one_rank(const hfrac_sim_def* def) {
  hfrac_exchange exchange;
  hfrac_linear_solver solver;
  hfrac_traffic traffic;
  hfrac_sim* sim = NULL;
  good(hfrac_linear_solver_init(&solver, (int32_t)sizeof solver), NULL, "linear_solver_init");
  check(solver.prepare == NULL && solver.reason == NULL, "no solver");
  good(hfrac_exchange_init(&exchange, (int32_t)sizeof exchange), NULL, "exchange_init");
  check(exchange.size == 1 && exchange.start == NULL, "one rank");
  good(hfrac_sim_create_on(def, &exchange, &sim), NULL, "create_on");
  memset(&traffic, 0, sizeof traffic);
  traffic.struct_size = (int32_t)sizeof traffic;
  good(hfrac_get_traffic(sim, &traffic), sim, "get_traffic");
  check(traffic.messages == 0 && traffic.bytes == 0, "that says nothing");
  good(hfrac_sim_destroy(&sim), NULL, "destroy");
}

int main(void) {
  hfrac_sim_def def;
  hfrac_well_def well;
  hfrac_sim* sim = NULL;
  library();
  define(&def, &well);
  good(hfrac_sim_create(&def, &sim), NULL, "create");
  if (sim != NULL) {
    run(sim);
    drive_well(sim);
    fields(sim);
    cracks(sim);
    catalogue(sim);
    slips(sim);
    records();
    go_back(sim);
    pack_and_begin();
    exchange(sim);
    walls(sim);
  }
  good(hfrac_sim_destroy(&sim), NULL, "destroy");
  check(sim == NULL, "the simulation is gone");
  one_rank(&def);
  warm(&def);
  rock_tests();
  return failures == 0 ? 0 : 1;
}
