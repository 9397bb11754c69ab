! How a reservoir simulator uses hfrac: its own time steps, its own well control, and what it wants to know after each.
! Everything is set by key, as in a case file; every error is handled, none ends the program.
program reservoir_step
  use, intrinsic :: iso_fortran_env, only: error_unit, real64
  use hfrac
  implicit none
  type(hfrac_definition) :: def
  type(hfrac_simulation) :: sim
  type(hfrac_sim_state) :: state
  type(hfrac_well_state), allocatable :: wells(:)
  type(hfrac_fracture), allocatable :: fractures(:)
  real(real64), allocatable :: position(:, :), pressure(:)
  real(real64), parameter :: MPa = 1e6_real64
  real(real64) :: target_pressure
  integer :: stat, report_step
  character(500) :: message

  ! A block of 100 m with one well in the middle, with effective stresses.
  call def%set('title', 'called from a reservoir simulator')
  call def%set('stress.convention', 'effective')
  call def%set('packing.disc_count', 600)
  call def%set('packing.residual', 1e-3_real64)
  call def%set('stress.sigma_Hmax', 0)
  call def%set('stress.sigma_hmin', 0)
  call def%set('boundary.kind', 'walls')
  call def%set('stepping.flow_step', 1e-2_real64)
  call def%set('well[0].x', 50)
  call def%set('well[0].y', 50)
  call def%set('well[0].radius', 8.5_real64)
  call def%check(stat, message)
  if (stat < 0) call give_up()

  call sim%create(def, stat, message)
  if (stat < 0) call give_up()
  call sim%get('disc.position', position)
  print '(i0,a,f0.1,a)', size(position, 2), ' discs, the highest at ', maxval(position(2, :)), ' m'

  print '(a)', '  time [s]  well [MPa]  cracks  length [m]  width [mm]  highest pore pressure [MPa]'
  do report_step = 1, 5
    target_pressure = 10*MPa*report_step
    call sim%set_well_ramp(0, target_pressure, 5*MPa)
    call sim%advance(0.05_real64*report_step, stat=stat, errmsg=message)
    if (stat < 0) call give_up()

    state = sim%state()
    call sim%wells(wells)
    call sim%fractures(fractures)
    call sim%get('domain.pressure', pressure)
    if (size(fractures) > 0) then
      print '(f10.2,f12.1,i8,f12.2,f12.3,f16.1)', state%time, wells(1)%pressure/MPa, state%crack_count, &
        fractures(1)%length, 1e3_real64*fractures(1)%largest_aperture, maxval(pressure)/MPa
    else
      print '(f10.2,f12.1,i8,a12,a12,f16.1)', state%time, wells(1)%pressure/MPa, state%crack_count, '-', '-', &
        maxval(pressure)/MPa
    end if
  end do

contains

  subroutine give_up()
    write (error_unit, '(a)') trim(message)
    stop 1
  end subroutine give_up

end program reservoir_step
