! SPDX-License-Identifier: BSD-3-Clause
!> A fracture in a reservoir, two programs as one: hfrac has the rock around the well, a Darcy simulator all the rest.
!>
!>     coupled [STEPS]     STEPS: steps to take at most, 40 if left out
!>
!> Who owns what. The cells under hfrac's model are hfrac's; the simulator leaves them out. Through the model's edge passes
!> what hfrac says (`outflow` by cell); the pressure there is what the simulator says. Within every step the two are iterated to
!> agree (hfrac: pressure given, flow found; simulator: flow given, pressure found; Aitken's relaxation between). Fluid is
!> conserved whether or not they agree to the last digit, because the same flow is accounted for on either side.
!>
!> A step is rejected and tried anew at half its length if the two do not agree in a few rounds, or if too many bonds
!> break in it; after an easy one the next may be longer. The table's column "again" counts the rejections.
program coupled
  use, intrinsic :: iso_fortran_env, only: error_unit, real64
  use darcy
  use hfrac
  implicit none
  real(real64), parameter :: MPa = 1e6_real64, formation = 20*MPa, side = 60, cell = 15, rate = 4e-2_real64
  integer, parameter :: n = 28, first = 13              ! cells a side; first cell under the model
  real(real64), parameter :: tolerance = 1e3_real64     ! Pa, agreement at the edge
  integer, parameter :: most_rounds = 12, most_cracks = 12
  type(hfrac_definition) :: def
  type(hfrac_simulation) :: sim
  type(hfrac_sim_state) :: state
  type(hfrac_balance) :: balance
  type(hfrac_well_state), allocatable :: wells(:)
  type(hfrac_fracture), allocatable :: fractures(:)
  type(hfrac_cell), allocatable :: cells(:, :)
  type(reservoir) :: field
  real(real64) :: edge(n, n), agreed_edge(n, n), flow(n, n), next(n, n), missing, dt, length
  integer :: steps, step, rounds, rejected, cracks, stat
  character(500) :: message
  logical :: agreed

  steps = 40
  if (command_argument_count() > 0) then
    call get_command_argument(1, message)
    read (message, *) steps
  end if
  call set_up()

  dt = 8
  rejected = 0
  edge = formation
  agreed_edge = edge
  print '(a)', 'step     time       dt  rounds  again    well  cracks  length  to reservoir   produced    missing'
  print '(a)', '            s        s                   MPa              m          m2/s         m2         m2'
  do step = 1, steps
    state = sim%state()
    cracks = int(state%crack_count)
    call sim%prepare_step(stat, message)
    call stop_on_error()
    do
      call agree()
      state = sim%state()
      if (agreed .and. state%crack_count - cracks <= most_cracks) exit
      if (agreed .and. dt < 1e-2_real64) exit        ! a burst of cracks at once, however short the step
      if (dt < 1e-6_real64) error stop 'no step is short enough'
      rejected = rejected + 1
      dt = 0.5_real64*dt
      edge = agreed_edge
      call sim%reject_step(stat, message)
      call stop_on_error()
      call sim%prepare_step(stat, message)
      call stop_on_error()
    end do
    call sim%finalize_step(stat, message)
    call stop_on_error()
    call field%accept(dt, next)
    agreed_edge = edge
    call show()
    if (state%stop_reason == HFRAC_REASON_EXTENT) then
      print '(a)', 'the fracture nears the edge of the model; what followed would be the edge''s doing'
      exit
    end if
    if (agreed .and. rounds <= 8 .and. state%crack_count - cracks <= most_cracks/2) dt = min(1.5_real64*dt, 20.0_real64)
  end do

  print '(i0,a)', rejected, ' steps were rejected and tried anew'
  print '(a,es10.3,a)', 'injected through the well   ', balance%injected_volume, ' m2'
  print '(a,es10.3,a)', 'stored around the fracture  ', balance%stored_volume, ' m2'
  print '(a,es10.3,a)', 'stored in the reservoir     ', field%stored(formation), ' m2'
  print '(a,es10.3,a)', 'produced                    ', field%produced, ' m2'
  print '(a,es10.3,a)', 'missing                     ', missing, ' m2'
  if (abs(missing) > 1e-8_real64*balance%injected_volume) error stop 'fluid is missing'
  if (steps >= 10 .and. rejected == 0) error stop 'no step was rejected: this example shows nothing'

contains

  subroutine set_up()
    call def%set('title', 'the rock around the well of a reservoir simulator')
    call def%set('model.width', side)
    call def%set('model.height', side)
    call def%set('packing.disc_count', 700)
    call def%set('stress.sigma_Hmax', 33*MPa)
    call def%set('stress.sigma_hmin', 28*MPa)
    call def%set('bond.tensile_strength', 10*MPa)
    call def%set('bond.shear_strength', 30*MPa)
    call def%set('fluid.viscosity', 1e-3_real64)
    call def%set('fluid.bulk_modulus', 2.2e9_real64)
    call def%set('fluid.formation_pressure', formation)
    call def%set('flow.permeability', 5e-14_real64)
    call def%set('flow.aperture_limit', 1e-3_real64)
    call def%set('well[0].x', side/2)
    call def%set('well[0].y', side/2)
    call def%set('well[0].radius', 4.0_real64)
    call def%set('well[0].control', 'rate')
    call def%set('well[0].rate', rate)
    call sim%create(def, stat, message)
    call stop_on_error()

    ! The simulator's grid; the model is its middle.
    call sim%set_grid(n, n, [-cell*(first - 1), -cell*(first - 1)], [cell, cell], stat=stat, errmsg=message)
    call stop_on_error()
    call field%create(n, n, cell, formation)
    field%permeability = 5e-14_real64
    field%viscosity = 1e-3_real64
    field%storage = 0.15_real64/2.2e9_real64
    field%producer = [first + 12, first + 2]
    field%producer_pressure = 15*MPa
    call sim%cells(cells, HFRAC_UPSCALE_ODA)
    field%active = cells%coverage < 0.5_real64
  end subroutine set_up

  !> One try of both programs over dt, until the pressure at the model's edge is the same in both.
  subroutine agree()
    real(real64) :: found(n, n), change(n, n), before(n, n), relaxation
    relaxation = 0.5_real64
    agreed = .false.
    do rounds = 1, most_rounds
      call sim%set_boundary_pressure(edge, stat, message)
      call stop_on_error()
      call sim%do_step(dt, stat, message)
      call stop_on_error()
      call sim%cells(cells, HFRAC_UPSCALE_ODA, stat, message)
      call stop_on_error()
      flow = cells%outflow
      call field%try(dt, flow, next)
      ! From the middle of a cell to the model's edge is half a cell: twice the conductance.
      found = next + flow/(2*field%transmissibility())
      change = 0
      where (abs(flow) > 0) change = found - edge    ! the cells beside the model
      if (maxval(abs(change)) < tolerance) then
        agreed = .true.
        return
      end if
      if (rounds > 1) relaxation = -relaxation*sum(before*(change - before))/sum((change - before)**2)
      relaxation = max(0.05_real64, min(1.0_real64, relaxation))
      before = change
      edge = edge + relaxation*change
      if (minval(edge) < 0) return                     ! overshot: a shorter step is needed
    end do
  end subroutine agree

  subroutine show()
    balance = sim%balance()
    state = sim%state()
    call sim%wells(wells)
    call sim%fractures(fractures)
    length = 0
    if (size(fractures) > 0) length = fractures(1)%length
    missing = balance%injected_volume - balance%stored_volume - field%stored(formation) - field%produced
    print '(i4,f9.2,f9.3,2i7,f9.2,i8,f8.1,es14.3,2es11.2)', step, state%time, dt, rounds, rejected, &
      wells(1)%pressure/MPa, state%crack_count, length, sum(flow), field%produced, missing
  end subroutine show

  subroutine stop_on_error()
    if (stat >= 0) return
    write (error_unit, '(a)') trim(message)
    error stop 1
  end subroutine stop_on_error

end program coupled
