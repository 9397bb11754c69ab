! SPDX-License-Identifier: BSD-3-Clause
! What acts from outside: wells, temperature, a reservoir simulator's grid.
module fortran_test_outside
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: int64, real64
  use fortran_test_support, only: case_file, expect
  use hfrac
  implicit none
  private
  public :: wells, wellbores, warm, exchange, one_rank

contains

  ! One rank needs no functions to talk by.
  subroutine one_rank()
    type(hfrac_definition) :: def
    type(hfrac_simulation) :: sim, other
    type(hfrac_traffic) :: traffic
    type(hfrac_linear_solver) :: solver
    call def%load(case_file)
    call sim%create(def)
    allocate (def%exchange)
    call expect(hfrac_exchange_init(def%exchange, int(c_sizeof(def%exchange), c_int32_t)) == 0, 'defaults of ranks')
    call expect(def%exchange%size == 1, 'one rank')
    call expect(hfrac_linear_solver_init(solver, int(c_sizeof(solver), c_int32_t)) == 0, 'defaults of solvers')
    call expect(.not. c_associated(def%exchange%linear_solver), 'no solver from outside')
    call other%create(def)
    call expect(other%state_hash() == sim%state_hash(), 'the same model')
    traffic = other%traffic()
    call expect(traffic%messages == 0 .and. traffic%bytes == 0, 'one rank hears nothing')
  end subroutine one_rank

  subroutine wells()
    type(hfrac_simulation) :: sim
    type(hfrac_well_state), allocatable :: list(:)
    integer :: stat, added
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
    call sim%add_well(75.0_real64, 60.0_real64, added)
    call expect(added == 1, 'a second well')
    call sim%set_well_pressure(added, 3e6_real64)
    call sim%step()
    call sim%wells(list)
    call expect(size(list) == 2 .and. list(2)%pressure == 3e6_real64 .and. list(2)%radius == 0.0_real64, 'it is driven')
    call sim%add_well(-1.0_real64, 60.0_real64, added, stat, message)
    call expect(stat == HFRAC_ERR_ARGUMENT .and. added == -1 .and. index(message, 'outside the rock') > 0, &
                'no well outside the rock: '//message)
  end subroutine wells

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

  ! Two clusters of one wellbore: the drop is 8 rho Q^2 / (pi^2 n^2 D^4 C_d^2) + k sqrt(Q), and the wellhead is rho g depth lower.
  subroutine wellbores()
    type(hfrac_definition) :: def
    type(hfrac_simulation) :: sim
    type(hfrac_well_def) :: clusters(2)
    type(hfrac_well_state), allocatable :: list(:)
    real(real64), allocatable :: share(:)
    integer :: stat
    character(200) :: message
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
    call sim%set_well_fluid(0, HFRAC_WELL_FLUID_SECOND, stat, message)
    call expect(stat == HFRAC_ERR_ARGUMENT .and. index(message, 'second_viscosity') > 0, 'no second fluid: '//message)
    call def%set('fluid.second_viscosity', 0.1_real64)
    call sim%create(def)
    call sim%step()
    call sim%set_well_fluid(0, HFRAC_WELL_FLUID_SECOND)
    call sim%step()
    call sim%wells(list)
    call sim%get('domain.second_fluid', share)
    call expect(all(list%fluid == HFRAC_WELL_FLUID_SECOND) .and. all(share(list%domain + 1) == 1.0_real64), 'the second fluid')
    clusters%fluid_area = 100.0_real64
    call def%set_wells(clusters)
    call sim%create(def)
    call sim%get('domain.volume', share)
    call expect(all(abs(share(list%domain + 1) - 100.0_real64) < 1.0_real64), 'the area of fluid in the holes')
  end subroutine wellbores

end module fortran_test_outside
