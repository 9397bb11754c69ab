! SPDX-License-Identifier: BSD-3-Clause
! Module hfrac from outside: every procedure at least once, right use and wrong, with floating-point traps armed.
!   fortran_test CASE
module fortran_test_progress
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t
  use hfrac, only: HFRAC_LOG_ERROR
  implicit none
  integer :: calls = 0
  integer :: steps = 0, messages = 0
  logical :: stop_at_once = .false.
contains
  function count_steps(step, time) result(stop_now)
    integer(c_int64_t), intent(in) :: step
    real(c_double), intent(in) :: time
    logical :: stop_now
    steps = steps + 1
    stop_now = step == 3 .or. time < 0.0_c_double
  end function count_steps

  subroutine count_messages(level, message)
    integer(c_int32_t), intent(in) :: level
    character(*), intent(in) :: message
    if (level >= HFRAC_LOG_ERROR .and. len_trim(message) > 0) messages = messages + 1
  end subroutine count_messages

  function count_calls(fraction, what) result(stop_now)
    real(c_double), intent(in) :: fraction
    character(*), intent(in) :: what
    logical :: stop_now
    calls = calls + 1
    stop_now = stop_at_once .or. fraction < 0.0_c_double .or. len(what) == 0
  end function count_calls
end module fortran_test_progress

program fortran_test
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: error_unit, int64, real64
  use fortran_test_progress
  use hfrac
  implicit none
  integer :: failures = 0
  character(1000) :: case_file

  call get_command_argument(1, case_file)
  call library()
  call options()
  call definition()
  call building()
  call running()
  call wells()
  call wellbores()
  call fields()
  call cracks_and_fractures()
  call progress()
  call going_back()
  call exchange()
  call warm()
  call wrong_use()
  call own_discs()
  call two_at_once()
  call rock_tests()
  if (failures > 0) error stop 1
  print '(a)', 'all good'

contains

  ! The laboratory, by the low-level interface.
  subroutine rock_tests()
    use hfrac_c, only: hfrac_sim_def, hfrac_sim_def_init, hfrac_lab_spec, hfrac_lab_spec_init, hfrac_lab_report, &
      hfrac_lab_run, hfrac_lab_get_report, hfrac_lab_copy_f64, hfrac_lab_destroy, hfrac_targets, hfrac_targets_init, &
      hfrac_calibration, hfrac_calibrate, HFRAC_LAB_CRACKS
    type(hfrac_sim_def) :: def
    type(hfrac_lab_spec) :: spec
    type(hfrac_lab_report) :: report
    type(hfrac_targets) :: targets
    type(hfrac_calibration) :: found
    type(c_ptr) :: lab
    integer(c_int64_t) :: count
    lab = c_null_ptr
    call expect(hfrac_sim_def_init(def, int(c_sizeof(def), c_int32_t)) == 0, 'defaults of a definition')
    call expect(hfrac_lab_spec_init(spec, int(c_sizeof(spec), c_int32_t)) == 0, 'defaults of a test')
    spec%disc_count = 500
    call expect(hfrac_lab_run(def, spec, c_null_funptr, c_null_ptr, lab) == 0, 'a rock test')
    call expect(hfrac_lab_get_report(lab, report) == 0, 'its report')
    call expect(report%modulus > 10e9_c_double .and. report%modulus < 18e9_c_double, 'rock has a modulus')
    call expect(hfrac_lab_copy_f64(lab, HFRAC_LAB_CRACKS, c_null_ptr, 0_c_int64_t, count) == 0, 'its cracks')
    call expect(count == 0, 'nothing breaks in an elastic test')
    call expect(hfrac_lab_destroy(lab) == 0, 'the end of a test')
    call expect(hfrac_targets_init(targets, int(c_sizeof(targets), c_int32_t)) == 0, 'defaults of targets')
    targets%modulus = 20e9_c_double
    targets%disc_count = 500
    targets%packings = 1
    call expect(hfrac_calibrate(def, targets, c_null_funptr, c_null_ptr, found) == 0, 'a calibration')
    call expect(found%test_count == 2, 'of two tests')
  end subroutine rock_tests

  subroutine expect(condition, what)
    logical, intent(in) :: condition
    character(*), intent(in) :: what
    if (condition) return
    write (error_unit, '(2a)') 'failed: ', what
    failures = failures + 1
  end subroutine expect

  subroutine library()
    integer(c_int32_t) :: major, minor, patch, abi, needed
    character(kind=c_char), target :: buffer(200)
    call expect(hfrac_version(major, minor, patch) == HFRAC_OK, 'version')
    call expect(major == HFRAC_VERSION_MAJOR .and. minor == HFRAC_VERSION_MINOR, 'version of the module')
    call expect(hfrac_abi_version(abi) == HFRAC_OK .and. abi == HFRAC_ABI_NUMBER, 'ABI number')
    call expect(index(hfrac_info(), 'hfrac') == 1, 'build info')
    call expect(hfrac_status_text(HFRAC_ERR_MODEL, c_loc(buffer), 200, needed) == HFRAC_OK, 'status text')
    call expect(needed > 10 .and. buffer(needed) == c_null_char, 'size of the status text')
  end subroutine library

  subroutine options()
    type(hfrac_option_info) :: info
    integer(c_int32_t) :: count
    call expect(hfrac_option_count(count) == HFRAC_OK .and. count > 30, 'number of options')
    call expect(hfrac_option_at(0, info) == HFRAC_OK, 'an option')
    call expect(c_associated(info%key) .and. info%default_value == 100.0_real64, 'the first option')
    call expect(hfrac_well_option_count(count) == HFRAC_OK .and. count >= 7, 'number of values of a well')
    call expect(hfrac_well_option_at(6, info) == HFRAC_OK .and. info%type == 2, 'how a well is driven')
    call expect(hfrac_joint_option_count(count) == HFRAC_OK .and. count >= 8, 'number of values of a joint')
    call expect(hfrac_joint_option_at(7, info) == HFRAC_OK .and. info%type == 2, 'a value of a joint')
    call expect(hfrac_schedule_option_count(count) == HFRAC_OK .and. count >= 4, 'number of values of an entry')
    call expect(hfrac_schedule_option_at(1, info) == HFRAC_OK .and. info%type == 0, 'a value of an entry')
  end subroutine options

  subroutine definition()
    type(hfrac_definition) :: def
    integer :: stat
    character(200) :: message
    real(real64) :: fine, coarsest
    call expect(def%get('model.width') == 100.0_real64, 'a default')
    call def%set('model.width', 80.0_real64)
    call def%set('packing.disc_count', 400)
    call def%set('packing.disc_count', 401_int64)
    call def%set('boundary.kind', 'walls   ')
    call def%set('title', 'from Fortran   ')
    call expect(def%values%model_width == 80.0_real64 .and. def%values%packing_disc_count == 401, 'values by key')
    call expect(def%get('boundary.kind') == 1.0_real64, 'a choice by its word')
    call expect(index(def%case_text(), 'title = "from Fortran"') == 1, 'definition as text')

    call expect(def%get_integer('packing.disc_count') == 401, 'an integer')
    call def%disc_radii(fine, coarsest)
    call expect(fine > 0.0_real64 .and. fine == coarsest, 'one mean radius')
    call expect(def%get_integer('boundary.kind') == 1, 'the index of a choice')
    call expect(def%get_text('boundary.kind') == 'walls', 'the word of a choice')
    call expect(def%get_text('title') == 'from Fortran', 'the title')
    call expect(def%get_integer('model.width', stat) == 0, 'no integer')
    call expect(stat == HFRAC_ERR_ARGUMENT, 'why it is none')
    call expect(def%get_text('no.such', stat) == '', 'no text')
    call expect(stat == HFRAC_ERR_UNKNOWN_KEY, 'why there is none')
    message = 'untouched'
    call def%set('packing.disc_count', 500, stat, message)
    call expect(stat == 0 .and. message == 'untouched', 'stat and errmsg of success')
    call def%set('packing.disk_count', 1, stat, message)
    call expect(stat == HFRAC_ERR_UNKNOWN_KEY, 'unknown key')
    call expect(index(message, 'packing.disc_count') > 0, 'nearest key: '//message)
    call def%set('fluid.viscosity', -1.0_real64, stat, message)
    call expect(stat == HFRAC_ERR_ARGUMENT, 'out of range')
    call def%load('/nonexistent/case.toml', stat, message)
    call expect(stat == HFRAC_ERR_CASE_FILE .and. index(message, 'case.toml') > 0, 'missing file')
    call def%add_traces('/nonexistent/traces.csv', stat, message)
    call expect(stat == HFRAC_ERR_CASE_FILE .and. index(message, 'traces.csv') > 0, 'missing traces')
    call def%set('well[0].radius', 1000.0_real64)
    call def%check(stat, message, path='case.toml')
    call def%check(stat, message)
    call expect(stat < 0 .and. len_trim(message) > 0, 'a well larger than the model')
    call expect(def%get('no.such', stat) == 0.0_real64 .and. stat == HFRAC_ERR_UNKNOWN_KEY, 'get of an unknown key')
    call long_lists()
  end subroutine definition

  subroutine long_lists()
    type(hfrac_definition) :: def, other, torn
    type(hfrac_simulation) :: apart
    integer :: stat
    character(400) :: message
    type(hfrac_well_def) :: wells(12)
    type(hfrac_joint_def) :: joints(100)
    type(hfrac_schedule_def) :: entries(200)
    integer :: k
    wells%radius = 4.0_real64
    wells%pressure = 30e6_real64
    do k = 1, 12
      wells(k)%x = 8.0_real64*k
      wells(k)%y = 50.0_real64
    end do
    call def%set_wells(wells)
    do k = 1, 100
      joints(k) = hfrac_joint_def(10.0_real64, 0.9_real64*k, 90.0_real64, 0.9_real64*k, 1.0_real64, 0.5_real64, -1.0_real64, &
        0_int64)
    end do
    call def%set_joints(joints)
    do k = 1, 200
      entries(k) = hfrac_schedule_def(mod(k, 12) + 0_int64, real(k, real64), 31e6_real64, 0_int64)
    end do
    call def%set_schedule(entries)
    call expect(def%get_integer('well_count') == 12, 'twelve wells')
    call expect(def%get('well[11].x') == 96.0_real64, 'twelve wells')
    call expect(def%get_integer('joint_count') == 100, 'a hundred joints')
    call expect(def%get('joint[99].y1') == 0.9_real64*100, 'a hundred joints')
    call expect(def%get_integer('schedule_count') == 200, 'a schedule')
    call expect(def%get('schedule[199].time') == 200.0_real64, 'a schedule')
    call def%set('joint[100].y1', 5.0_real64)
    call expect(def%get_integer('joint_count') == 101, 'one joint more, by its key')
    call def%copy_to(other)
    call def%set_wells(wells(1:0))
    call expect(def%get_integer('well_count') == 0, 'a copy is on its own')
    call expect(other%get_integer('well_count') == 12, 'a copy is on its own')
    call def%free()
    call expect(def%get_integer('joint_count') == 0, 'freed')
    call torn%set('packing.disc_count', 60)
    call torn%set('well[0].radius', 22.0_real64)
    call torn%set('well[0].pressure', 30e6_real64)
    call apart%create(torn)
    call apart%step(1, stat, message)
    call expect(stat == HFRAC_ERR_COLLAPSED, 'rock that falls apart')
    call expect(index(message, 'the rock fell apart in step 1') == 1, message)
    call apart%destroy()
    call torn%free()
    call expect(other%get('joint[99].shear_factor') == 0.5_real64, 'freed')
    call other%free()
  end subroutine long_lists

  subroutine building()
    type(hfrac_definition) :: def, found
    type(hfrac_simulation) :: sim
    type(hfrac_setup_report) :: made
    integer :: stat
    character(200) :: message
    call expect(.not. sim%exists(), 'no simulation at first')
    call def%load(case_file)
    def%progress => count_calls
    def%log => count_messages
    call sim%create(def, stat, message)
    call expect(messages > 2, 'the building was told')
    call expect(stat == 0 .and. sim%exists(), 'create')
    made = sim%setup()
    call expect(made%packed_discs == 500 .and. made%mean_radius > 0.0_real64, 'setup report')
    call sim%definition(found)
    call expect(found%values%packing_disc_count == 500, 'definition of a simulation')
    call def%set('packing.disc_count', 5000)
    call def%set('packing.residual', 1e-9_real64)
    calls = 0
    stop_at_once = .true.
    call sim%create(def, stat)
    stop_at_once = .false.
    call expect(stat == HFRAC_STOPPED .and. calls > 0 .and. .not. sim%exists(), 'building stopped')
    call sim%create('/nonexistent/case.toml', stat, message)
    call expect(stat == HFRAC_ERR_CASE_FILE .and. .not. sim%exists(), 'create from a missing file')
    call sim%destroy()
    call sim%destroy(stat)
    call expect(stat == 0, 'destroy twice')
  end subroutine building

  subroutine running()
    type(hfrac_simulation) :: sim
    type(hfrac_sim_state) :: state
    type(hfrac_balance) :: balance
    type(hfrac_solver_report) :: solver
    type(hfrac_step_limits) :: limits
    type(hfrac_wall_state), allocatable :: sides(:)
    real(real64) :: reached
    integer(c_int32_t) :: reason
    integer(int64) :: before
    integer :: stat
    call sim%create(case_file)
    before = sim%state_hash()
    call expect(sim%state_hash() == before, 'hash of an unchanged state')
    call sim%step(2)
    call sim%step(1_int64, stat)
    call sim%step()
    state = sim%state()
    call expect(state%step == 4 .and. stat >= 0, 'four steps')
    call expect(sim%state_hash() /= before, 'hash of a changed state')
    call sim%advance(0.06_real64, reached, reason)
    call expect(abs(reached - 0.06_real64) < 1e-9_real64 .and. reason == HFRAC_REASON_TARGET, 'advance')
    call sim%advance(0.065_real64, reached, reason, stat, exact=.true.)
    call expect(reached == 0.065_real64 .and. stat >= 0, 'advance to a time exactly')
    call sim%set_stop(1.0_real64, 0_int64)
    limits = sim%step_limits()
    call expect(limits%binding == HFRAC_LIMIT_NONE .and. limits%mechanical_step > 0.0_real64, 'limits of a step')
    call sim%walls(sides)
    call expect(size(sides) == 4, 'four walls')
    call expect(all(sides(1)%normal == [1.0_real64, 0.0_real64]) .and. sides(2)%position > 90.0_real64, 'where they are')
    balance = sim%balance()
    solver = sim%solver()
    call expect(solver%kind == 0 .and. solver%newton_iterations == 0, 'explicit solver')
    call expect(balance%injected_volume > 0.0_real64 .and. balance%fracture > 0.0_real64, 'balance')
    call sim%step(-1, stat)
    call expect(stat == HFRAC_ERR_ARGUMENT, 'negative count')
  end subroutine running

  subroutine wells()
    type(hfrac_simulation) :: sim
    type(hfrac_well_state), allocatable :: list(:)
    integer :: stat
    character(200) :: message
    call sim%create(case_file)
    call sim%wells(list)
    call expect(size(list) == 1, 'one well')
    call expect(list(1)%x == 50.0_real64 .and. list(1)%control == HFRAC_WELL_PRESSURE, 'the well')
    call sim%set_well_ramp(0, 10e6_real64, 1e6_real64)
    call sim%step(3)
    call sim%wells(list)
    call expect(abs(list(1)%pressure - 3e6_real64) < 1.0_real64, 'three steps of the ramp')
    call sim%set_well_pressure(0, 5e6_real64)
    call sim%step()
    call sim%wells(list)
    call expect(abs(list(1)%pressure - 5e6_real64) < 1.0_real64, 'held pressure')
    call sim%set_well_rate(0, 1e-4_real64)
    call sim%step()
    call sim%wells(list)
    call expect(list(1)%control == HFRAC_WELL_RATE .and. list(1)%rate > 0.0_real64, 'rate')
    call sim%set_well_schedule(0, [0.0525_real64, 0.0575_real64], [HFRAC_WELL_RATE, HFRAC_WELL_PRESSURE], &
                               [0.0_real64, 4e6_real64])
    call sim%step(3)
    call sim%wells(list)
    call expect(list(1)%control == HFRAC_WELL_PRESSURE .and. list(1)%pressure == 4e6_real64, 'the schedule is followed')
    call sim%set_well_schedule(0, [0.1_real64, 0.2_real64], [HFRAC_WELL_RATE], [0.0_real64], stat, message)
    call expect(stat == HFRAC_ERR_ARGUMENT .and. index(message, 'one size') > 0, 'a schedule with a hole: '//message)
    call sim%set_well_rate(3, 1.0_real64, stat, message)
    call expect(stat == HFRAC_ERR_ARGUMENT .and. index(message, 'well 3') == 1, 'no such well: '//message)
  end subroutine wells

  ! Two clusters of one wellbore: the drop is 8 rho Q^2 / (pi^2 n^2 D^4 C_d^2) + k sqrt(Q), and the wellhead is rho g depth lower.
  subroutine wellbores()
    type(hfrac_definition) :: def
    type(hfrac_simulation) :: sim
    type(hfrac_well_def) :: clusters(2)
    type(hfrac_well_state), allocatable :: list(:)
    real(real64), parameter :: pi = acos(-1.0_real64)
    real(real64) :: drop
    call def%set('packing.disc_count', 600)
    call def%set('fluid.formation_pressure', 25e6_real64)
    call def%set('flow.permeability', 1e-11_real64)
    call def%set('stepping.mode', 'coupled')
    call def%set('stepping.flow_step', 1.0_real64)
    call def%set('solver.kind', 'quasi-static')
    clusters%x = [30.0_real64, 70.0_real64]
    clusters%y = 50.0_real64
    clusters%radius = 8.0_real64
    clusters%wellbore = 5
    clusters%storage = 1e-12_real64
    clusters%height = 20.0_real64
    clusters%perforation_count = [8.0_real64, 4.0_real64]
    clusters%perforation_diameter = 0.01_real64
    clusters%discharge_coefficient = 0.8_real64
    clusters(1)%near_well_friction = 1e6_real64
    clusters%depth = 1500.0_real64
    clusters%fluid_density = 1050.0_real64
    clusters(1)%rate = 3e-3_real64
    clusters(1)%control = HFRAC_WELL_RATE
    call def%set_wells(clusters)
    call sim%create(def)
    call sim%step(4)
    call sim%wells(list)
    drop = 8*1050*(20*list(1)%rate)**2/(pi**2*8**2*0.01_real64**4*0.8_real64**2) + 1e6_real64*sqrt(20*list(1)%rate)
    call expect(abs(list(1)%wellbore_pressure - list(1)%pressure - drop) < 0.01_real64*drop, 'drop of the first cluster')
    drop = 8*1050*(20*list(2)%rate)**2/(pi**2*4**2*0.01_real64**4*0.8_real64**2)
    call expect(abs(list(2)%wellbore_pressure - list(2)%pressure - drop) < 0.01_real64*drop, 'drop of the second cluster')
    call expect(abs(sum(list%rate) - 3e-3_real64) < 1e-7_real64 .and. all(abs(list%wellbore_rate - 3e-3_real64) < 1e-12_real64), &
                'the clusters share the rate')
    call expect(all(abs(list%wellbore_pressure - list%wellhead_pressure - 1050*9.80665_real64*1500) < 1.0_real64), 'head')
  end subroutine wellbores

  subroutine fields()
    type(hfrac_simulation) :: sim
    type(hfrac_sim_state) :: state
    real(real64), allocatable :: position(:, :), radius(:)
    real(real64), pointer :: borrowed(:, :), no_double(:, :)
    integer(c_int32_t), allocatable :: discs(:, :), kind(:)
    integer(c_int32_t), pointer :: borrowed_kind(:, :)
    integer(int64) :: epoch
    integer :: stat
    character(200) :: message
    call sim%create(case_file)
    state = sim%state()
    call sim%get('disc.position', position)
    call expect(all(shape(position) == [2, int(state%disc_count)]), 'shape of positions')
    call sim%get('disc.radius', radius)
    call expect(size(radius) == state%disc_count .and. minval(radius) > 0.0_real64, 'radii')
    call sim%get('bond.discs', discs)
    call expect(all(shape(discs) == [2, int(state%bond_count)]), 'shape of the bonds'' discs')
    call expect(minval(discs) >= 0 .and. maxval(discs) < state%disc_count, 'discs count from 0')
    call sim%get('domain.kind', kind)
    call expect(kind(1) == 2 .and. count(kind == 1) == 1, 'outside and well')
    call sim%view('disc.position', borrowed)
    call expect(all(borrowed == position), 'a view is what a copy is')
    call sim%view('domain.kind', borrowed_kind)
    call expect(all(borrowed_kind(1, :) == kind), 'a view of integers')
    epoch = sim%epoch()
    call sim%step()
    call expect(sim%epoch() > epoch, 'epoch')

    call sim%get('disc.position', radius, stat, message)
    call expect(stat == HFRAC_ERR_ARGUMENT .and. size(radius) == 0 .and. index(message, 'rank 2') > 0, 'wrong rank')
    call sim%get('disc.position', discs, stat)
    call expect(stat == HFRAC_ERR_ARGUMENT, 'wrong type')
    call sim%view('domain.kind', no_double, stat)
    call expect(stat == HFRAC_ERR_ARGUMENT .and. .not. associated(no_double), 'view of the wrong type')
    call sim%get('disc.colour', radius, stat, message)
    call expect(stat == HFRAC_ERR_UNKNOWN_KEY .and. len_trim(message) > 0, 'no such field')
    call sim%get('joint.slip', radius)
    call expect(size(radius) == 0, 'no contacts of joints')
    call fields_of_a_joint()
  end subroutine fields

  subroutine fields_of_a_joint()
    type(hfrac_definition) :: def
    type(hfrac_simulation) :: sim
    real(real64), allocatable :: first(:, :), last(:, :), slip(:)
    integer(c_int32_t), allocatable :: bond(:), state(:), broken(:)
    call def%load(case_file)
    call def%set('joint[0].x1', 20.0_real64)
    call def%set('joint[0].y1', 70.0_real64)
    call def%set('joint[0].x2', 80.0_real64)
    call def%set('joint[0].y2', 75.0_real64)
    call def%set('joint[0].state', 'smooth-broken')
    call sim%create(def)
    call sim%get('joint.begin', first)
    call sim%get('joint.end', last)
    call sim%get('joint.slip', slip)
    call sim%get('joint.bond', bond)
    call sim%get('joint.state', state)
    call sim%get('bond.state', broken)
    call expect(size(slip) > 5 .and. all(shape(first) == [2, size(slip)]), 'contacts of a joint')
    call expect(all(broken(bond + 1) == 2) .and. all(state >= 1 .and. state <= 3), 'they are broken')
    call expect(maxval(abs((last(2, :) - first(2, :))*60 - (last(1, :) - first(1, :))*5)) < 1e-9_real64, 'along the joint')
  end subroutine fields_of_a_joint

  subroutine cracks_and_fractures()
    type(hfrac_simulation) :: sim
    type(hfrac_sim_state) :: state
    type(hfrac_crack), allocatable :: all_cracks(:), later(:)
    type(hfrac_fracture), allocatable :: fractures(:)
    type(hfrac_fracture_point), allocatable :: line(:)
    integer(int64) :: before, cursor
    integer :: stat
    call sim%create(case_file)
    call sim%cracks(all_cracks, next=before)
    call sim%step(5)
    call sim%cracks(later, since=before, next=cursor)
    call sim%cracks(all_cracks)
    state = sim%state()
    call expect(size(all_cracks) == state%crack_count .and. cursor == state%crack_count, 'all cracks')
    call expect(size(later) > 0 .and. later(size(later))%id == state%crack_count - 1, 'cracks since a cursor')
    call expect(all(all_cracks%mode >= HFRAC_CRACK_TENSION .and. all_cracks%mode <= HFRAC_CRACK_SHEAR), 'modes')
    call sim%fractures(fractures)
    call sim%fracture_line(0_c_int64_t, line)
    call expect(size(line) > 0 .and. all(line(2:)%distance > line(:size(line) - 1)%distance), 'line of a fracture')
    call expect(sum(fractures%crack_count) <= state%crack_count .and. fractures(1)%length > 0.0_real64, 'fractures')
    block
      use, intrinsic :: iso_c_binding, only: c_loc, c_sizeof
      type(hfrac_catalogue_options) :: rule
      type(hfrac_event), target :: event
      type(hfrac_magnitude_law) :: law
      integer(c_int64_t), target :: event_of
      integer(c_int64_t) :: found
      integer(c_int32_t) :: crack_size
      crack_size = int(storage_size(all_cracks(1)) / 8, c_int32_t)
      stat = hfrac_find_events(all_cracks(1), crack_size, 1_c_int64_t, rule, int(c_sizeof(event), c_int32_t), &
        c_loc(event), 1_c_int64_t, found)
      call expect(stat == HFRAC_OK .and. found == 1 .and. event%moment > 0.0_real64, 'one crack is an event')
      stat = hfrac_find_event_of_cracks(all_cracks(1), crack_size, 1_c_int64_t, rule, c_loc(event_of), 1_c_int64_t, found)
      call expect(stat == HFRAC_OK .and. event_of == 0, 'its event')
      block
        type(hfrac_slip), allocatable :: slips(:)
        type(hfrac_slip) :: slip
        call sim%slips(slips)
        call expect(size(slips) == 0, 'nothing slips without smooth joints')
        slip = hfrac_slip()
        slip%step = 1
        slip%normal(1) = 1.0_real64
        slip%length = 2.0_real64
        slip%slip = 0.5_real64
        slip%shear_modulus = 3e10_real64
        stat = hfrac_find_slip_events(slip, int(c_sizeof(slip), c_int32_t), 1_c_int64_t, rule, &
          int(c_sizeof(event), c_int32_t), c_loc(event), 1_c_int64_t, found)
        call expect(stat == HFRAC_OK .and. found == 1 .and. event%kind == HFRAC_EVENT_SLIP .and. &
          abs(event%moment / 3e10_real64 - 1.0_real64) < 1e-12_real64, 'a slip is an event of its moment')
      end block
      stat = hfrac_find_magnitude_law([0.0_real64, 1.0_real64], 2_c_int64_t, 0.0_real64, law)
      call expect(stat == HFRAC_OK .and. law%count == 2 .and. law%b > 0.0_real64, 'magnitudes have a law')
    end block
    block
      integer(c_int64_t) :: rows
      stat = hfrac_read_record('/nonexistent/record.csv'//c_null_char, 1.0_real64, c_null_ptr, 0_c_int64_t, rows)
      call expect(stat == HFRAC_ERR_CASE_FILE, 'missing record')
    end block
    call sim%cracks(later, since=1000000_int64, stat=stat)
    call expect(stat == HFRAC_ERR_ARGUMENT .and. size(later) == 0, 'cursor past the end')
  end subroutine cracks_and_fractures

  subroutine progress()
    type(hfrac_simulation) :: sim
    type(hfrac_sim_state) :: state
    integer :: stat
    call sim%create(case_file)
    calls = 0
    call sim%on_progress(count_calls, 0.0_real64)
    call sim%step(3)
    call expect(calls > 3, 'progress is called')
    stop_at_once = .true.
    call sim%step(3, stat)
    stop_at_once = .false.
    state = sim%state()
    call expect(stat == HFRAC_STOPPED .and. state%step == 3, 'stopped at the last whole step')
    call sim%on_progress()
    calls = 0
    call sim%step(1)
    call expect(calls == 0, 'progress removed')

    steps = 0
    messages = 0
    call sim%create(case_file)
    call sim%on_step(count_steps)
    call sim%on_log(count_messages, HFRAC_LOG_DETAIL)
    call sim%step(5, stat)
    state = sim%state()
    call expect(stat == HFRAC_STOPPED .and. steps == 3 .and. state%step == 3, 'stopped after the third step')
    call expect(messages >= 3, 'steps were told')
    call sim%on_step()
    call sim%on_log()
    messages = 0
    call sim%step()
    call expect(steps == 3 .and. messages == 0, 'nobody listens any more')
    call sim%on_log(count_messages, 9, stat)
    call expect(stat == HFRAC_ERR_ARGUMENT, 'no such level')
  end subroutine progress

  subroutine going_back()
    type(hfrac_definition) :: def
    type(hfrac_simulation) :: sim, straight
    integer(c_int8_t), allocatable :: image(:)
    type(hfrac_sim_state) :: state
    integer(int64) :: start, once
    integer :: stat, unit
    character(200) :: message
    call def%load(case_file)
    call def%set('boundary.kind', 'stress')
    call def%set('stress.sigma_Hmax', 10e6_real64)
    call def%set('stress.sigma_hmin', 10e6_real64)
    call def%set('stepping.force_ratio', 1e-2_real64)
    call sim%create(def)
    call sim%step(2)
    call sim%save(image)
    start = sim%state_hash()
    call sim%step(2)
    once = sim%state_hash()
    call sim%restore(image)
    call expect(sim%state_hash() == start, 'restored')
    call sim%step(2)
    call expect(sim%state_hash() == once, 'the same way again')
    image(size(image)/2) = not(image(size(image)/2))
    call sim%restore(image, stat, message)
    call expect(stat < 0 .and. len_trim(message) > 0, 'a damaged image')
    call expect(sim%state_hash() == once, 'a damaged image changes nothing')

    call sim%save(image)
    call sim%prepare_step()
    call sim%do_step(5e-3_real64)
    call sim%more_step(5e-3_real64)
    call sim%step(1, stat)
    call expect(stat == HFRAC_ERR_ARGUMENT, 'no other step while one is open')
    call sim%reject_step()
    call expect(sim%state_hash() == once, 'rejected')
    call sim%prepare_step()
    call sim%do_step(1e-2_real64)
    call sim%do_step(5e-3_real64)
    call sim%finalize_step()
    state = sim%state()
    call expect(abs(state%time - 0.045_real64) < 1e-9_real64, 'kept')
    call sim%finalize_step(stat)
    call expect(stat == HFRAC_ERR_ARGUMENT, 'no open step')

    call sim%save_file('fortran_test.state')
    once = sim%state_hash()
    call sim%step()
    call sim%load_file('fortran_test.state')
    call expect(sim%state_hash() == once, 'a state from a file')
    call sim%load_file('/nonexistent/state', stat, message)
    call expect(stat == HFRAC_ERR_FILE .and. index(message, '/nonexistent/state') > 0, 'no such file')
    open (newunit=unit, file='fortran_test.state', status='old')
    close (unit, status='delete')

    call straight%create(def)
    call straight%set_formation_pressure(26e6_real64)
    state = straight%state()
    call expect(state%formation_pressure == 26e6_real64, 'another formation pressure')
    call straight%set_formation_pressure(-1.0_real64, stat)
    call expect(stat == HFRAC_ERR_ARGUMENT, 'no pressure below zero')
    call straight%set_far_field(12e6_real64, 9e6_real64)
    call straight%step(2)
    call expect(straight%state_hash() /= start, 'another far field')
    call straight%set_far_field(10e6_real64, 20e6_real64, stat)
    call expect(stat == HFRAC_ERR_ARGUMENT, 'sigma_hmin above sigma_Hmax')
  end subroutine going_back

  subroutine warm()
    type(hfrac_definition) :: def
    type(hfrac_simulation) :: sim
    type(hfrac_heat) :: balance
    real(real64), allocatable :: discs(:), cells(:, :)
    logical, allocatable :: held(:)
    integer :: stat
    call def%load(case_file)
    call sim%create(def)
    call sim%set_temperature(600.0_real64, stat)
    call expect(stat == HFRAC_ERR_ARGUMENT, 'no temperature unless asked for')
    call def%set('thermal.mode', 'transport')
    call sim%create(def)
    call sim%set_temperature(600.0_real64)
    call sim%get('disc.temperature', discs)
    call expect(all(discs == 600.0_real64), 'one temperature for all')
    discs(1) = 610.0_real64
    allocate (held(size(discs)), source=.false.)
    held(1) = .true.
    call sim%set_disc_temperature(discs)
    call sim%hold_disc_temperature(held)
    call sim%set_grid(2, 1, [0.0_real64, 0.0_real64], [50.0_real64, 100.0_real64])
    call sim%set_cell_temperature(reshape([590.0_real64, 600.0_real64], [2, 1]))
    call sim%set_well_temperature(0, 300.0_real64)
    call sim%step(1)
    call expect(sim%well_temperature(0) == 300.0_real64, 'the well is as cold as told')
    call sim%cell_temperature(cells)
    call expect(all(shape(cells) == [2, 1]) .and. cells(1, 1) < cells(2, 1), 'cells keep their order')
    balance = sim%heat()
    call expect(balance%wells < 0.0_real64 .and. abs(balance%error) < 1e-6_real64*abs(balance%host), 'the heat balance closes')
  end subroutine warm

  subroutine exchange()
    type(hfrac_definition) :: def
    type(hfrac_simulation) :: sim
    type(hfrac_cell), allocatable :: by_size(:, :), by_corners(:, :)
    type(hfrac_balance) :: balance
    real(real64), allocatable :: added(:, :), pressure(:, :)
    real(real64) :: corners(2, 4, 3, 2), stress(3, 3, 2)
    integer :: i, j, stat, unit
    character(200) :: message
    call def%load(case_file)
    call def%set('boundary.kind', 'stress')
    call def%set('stress.sigma_Hmax', 10e6_real64)
    call def%set('stress.sigma_hmin', 10e6_real64)
    call def%set('stepping.force_ratio', 1e-2_real64)
    call sim%create(def)
    call sim%step(2)
    call sim%cells(by_size, stat=stat, errmsg=message)
    call expect(stat == HFRAC_ERR_ARGUMENT .and. index(message, 'grid') > 0, 'cells without a grid')
    call sim%set_grid(3, 2, [0.0_real64, 0.0_real64], [40.0_real64, 50.0_real64])
    call sim%cells(by_size)
    do j = 1, 2
      do i = 1, 3
        corners(:, 1, i, j) = [40.0_real64*(i - 1), 50.0_real64*(j - 1)]
        corners(:, 2, i, j) = [40.0_real64*i, 50.0_real64*(j - 1)]
        corners(:, 3, i, j) = [40.0_real64*i, 50.0_real64*j]
        corners(:, 4, i, j) = [40.0_real64*(i - 1), 50.0_real64*j]
      end do
    end do
    call sim%set_grid(corners)
    call sim%cells(by_corners, HFRAC_UPSCALE_ODA)
    call expect(all(shape(by_size) == [3, 2]) .and. all(shape(by_corners) == [3, 2]), 'cells have the shape of the grid')
    call expect(all(abs(by_size%coverage - by_corners%coverage) < 1e-9_real64), 'the same cells either way')
    call expect(by_size(1, 1)%coverage > 0.8_real64 .and. by_size(3, 1)%coverage < 0.6_real64, 'i runs along x')
    call expect(sum(by_size%crack_length) > 0.0_real64, 'the cells have cracks')

    allocate (pressure(3, 2), source=1e5_real64)
    call sim%set_cell_pressure(pressure)
    pressure(:, 2) = 2e5_real64
    balance = sim%balance()
    call sim%set_cell_pressure(pressure, added)
    call expect(all(shape(added) == [3, 2]) .and. all(added(:, 2) > 0.0_real64), 'the upper row gives fluid')
    call expect(abs(balance%host_volume + sum(added) - host_volume(sim)) < 1e-12_real64, 'its sum is accounted for')
    call sim%set_boundary_pressure(pressure)
    call sim%set_boundary_pressure(stat=stat)
    call expect(stat == 0, 'boundary pressure taken back')
    call sim%set_boundary_pressure(pressure)
    stress = 0.0_real64
    stress(1, :, :) = 1e6_real64
    call sim%set_cell_stress(stress)
    call sim%step(1, stat)
    call expect(stat >= 0, 'a step with the host''s values')
    balance = sim%balance()
    call expect(abs(balance%fluid_error) < 1e-9_real64*balance%injected_volume, 'the fluid is all there')
    call sim%set_cell_pressure(pressure(:, 1:1), stat=stat)
    call expect(stat == HFRAC_ERR_ARGUMENT, 'an array of the wrong size')
    call sim%write_grdecl('fortran_test.grdecl', kind=HFRAC_GRDECL_MULT, layers=2, porosity=0.1_real64)
    open (newunit=unit, file='fortran_test.grdecl', status='old', action='read', iostat=stat)
    call expect(stat == 0, 'the include file is there')
    if (stat == 0) close (unit, status='delete')
    call sim%write_grdecl('/nonexistent/fortran_test.grdecl', stat=stat)
    call expect(stat == HFRAC_ERR_FILE, 'no such folder')
  end subroutine exchange

  real(real64) function host_volume(sim)
    type(hfrac_simulation), intent(in) :: sim
    type(hfrac_balance) :: balance
    balance = sim%balance()
    host_volume = balance%host_volume
  end function host_volume

  subroutine wrong_use()
    type(hfrac_simulation) :: sim, empty
    type(hfrac_sim_state) :: state
    real(real64), allocatable :: radius(:)
    integer :: stat
    character(200) :: message
    call sim%step(1, stat, message)
    call expect(stat == HFRAC_ERR_ARGUMENT .or. stat == HFRAC_ERR_BAD_HANDLE, 'step of nothing')
    call expect(len_trim(message) > 0, 'text for nothing')
    state = sim%state(stat)
    call expect(stat < 0, 'state of nothing')
    call sim%get('disc.radius', radius, stat)
    call expect(stat < 0 .and. size(radius) == 0, 'field of nothing')
    sim = empty
    call expect(.not. sim%exists() .and. .not. c_associated(sim%c_handle()), 'assignment of nothing')
  end subroutine wrong_use

  subroutine own_discs()
    type(hfrac_definition) :: def
    type(hfrac_simulation) :: sim, again, jointed
    real(real64), allocatable :: position(:, :), radius(:), there(:, :)
    integer(c_int32_t), allocatable :: pairs(:, :), states(:)
    integer :: stat
    character(200) :: message
    call def%load(case_file)
    call def%set('stepping.force_ratio', 1e-2_real64)
    call sim%create(def)
    call sim%get('disc.position', position)
    call sim%get('disc.radius', radius)
    allocate (def%discs(3, size(radius)))
    def%discs(1:2, :) = position
    def%discs(3, :) = radius
    call again%create(def, stat, message)
    call expect(stat == 0, 'own discs: '//message)
    if (stat /= 0) return
    call again%get('disc.position', there)
    call expect(size(there, 2) == size(radius), 'as many discs as given')
    call again%get('bond.discs', pairs)
    def%bonds = int(pairs(:, 1:size(pairs, 2):2), int64)  ! every second bond is left out
    call jointed%create(def, stat, message)
    call expect(stat == 0, 'own bonds: '//message)
    call jointed%get('bond.state', states)
    call expect(count(states == 3) == size(pairs, 2)/2 .and. any(states == 0), 'bonds left out are contacts')
    def%bonds(2, 1) = def%bonds(1, 1)
    call jointed%create(def, stat, message)
    call expect(stat == HFRAC_ERR_MODEL .and. index(message, 'to itself') > 0, 'a bond of one disc')
    deallocate (def%bonds)
    allocate (def%bonds(3, 1), source=0_int64)
    call jointed%create(def, stat, message)
    call expect(stat == HFRAC_ERR_ARGUMENT .and. index(message, '(2, m)') > 0, 'bonds of the wrong shape')
    deallocate (def%bonds, def%discs)
    allocate (def%discs(2, 5), source=0.0_real64)
    call again%create(def, stat, message)
    call expect(stat == HFRAC_ERR_ARGUMENT .and. index(message, '(3, n)') > 0, 'discs of the wrong shape')
  end subroutine own_discs

  subroutine two_at_once()
    type(hfrac_simulation) :: alone, one, two
    type(hfrac_definition) :: other
    integer :: i
    call alone%create(case_file)
    call alone%step(4)
    call other%load(case_file)
    call other%set('model.seed', 9)
    call one%create(case_file)
    call two%create(other)
    do i = 1, 4
      call one%step()
      call two%step()
    end do
    call expect(one%state_hash() == alone%state_hash(), 'interleaved is as alone')
    call expect(one%state_hash() /= two%state_hash(), 'another seed is another state')
  end subroutine two_at_once

end program fortran_test
