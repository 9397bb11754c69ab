! SPDX-License-Identifier: BSD-3-Clause
! A simulation from its building to its end: steps, images of the state, steps that may be rejected, callbacks, misuse.
module fortran_test_stepping
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: int64, real64
  use fortran_test_progress
  use fortran_test_support, only: case_file, expect
  use hfrac
  implicit none
  private
  public :: building, running, going_back, progress, wrong_use, two_at_once

contains

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

end module fortran_test_stepping
