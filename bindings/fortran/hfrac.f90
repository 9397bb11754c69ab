! SPDX-License-Identifier: BSD-3-Clause
!> hfrac for Fortran programs: hydraulic fracturing with a bonded-particle model.
!>
!>     use hfrac
!>     type(hfrac_simulation) :: sim
!>     type(hfrac_fracture), allocatable :: fractures(:)
!>     call sim%create('case.toml')
!>     call sim%step(60)
!>     call sim%fractures(fractures)
!>
!> - SI units, unit thickness out of the plane, compression positive for stress and pressure.
!> - Every procedure that can fail takes `stat` (0 good, negative HFRAC_ERR_..., positive a note) and `errmsg` (changed
!>   by errors alone). Without `stat`, an error ends the program with its text; a note never does.
!> - Indices count from 0, as in case files ('well[0].pressure') and in what the library reports: disc i of
!>   'bond.discs' is column i + 1 of 'disc.position'.
!> - Floating-point traps of the program stay as they are and are not set off by the library.
!>
!> All of the C interface (module hfrac_c: constants, types, functions) comes along.
module hfrac
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_funloc, c_int32_t, c_int64_t, &
    c_int8_t, c_loc, c_null_funptr, c_null_ptr, c_ptr, c_sizeof
  use hfrac_c
  use hfrac_calls
  use hfrac_definition_module
  use hfrac_text
  implicit none
  public
  private :: c_associated, c_char, c_double, c_f_pointer, c_funloc, c_int32_t, c_int64_t, c_int8_t, c_loc, &
    c_null_funptr, c_null_ptr, c_ptr, c_sizeof
  private :: from_c, to_c, report, report_text

  !> Where the C callbacks find the Fortran procedures.
  type, private :: progress_holder
    procedure(hfrac_progress), pointer, nopass :: ask => null()
    procedure(hfrac_on_step), pointer, nopass :: step => null()
    procedure(hfrac_log), pointer, nopass :: log => null()
  end type progress_holder

  !> One simulation. Ends with `destroy`, with its scope, or with the next `create`; cannot be assigned.
  !> Its further methods are those of hfrac_handle, written from the C headers (hfrac_calls.f90).
  type, extends(hfrac_handle) :: hfrac_simulation
    private
    integer(c_int64_t) :: grid_shape(2) = 0
    type(progress_holder), pointer :: holder => null()
  contains
    generic, public :: create => create_from_definition, create_from_file
    procedure, public :: destroy
    procedure, public :: exists
    procedure, public :: c_handle
    generic, public :: step => step_int32, step_int64
    procedure, public :: advance
    procedure, public :: on_progress
    procedure, public :: on_step
    procedure, public :: on_log
    procedure, public :: definition
    procedure, public :: add_well
    procedure, public :: set_well_schedule
    procedure, public :: set_disc_temperature
    procedure, public :: hold_disc_temperature
    !> A reservoir simulator's grid: call sim%set_grid(nx, ny, origin, cell_size) or sim%set_grid(corners).
    generic, public :: set_grid => set_regular_grid, set_grid_corners
    procedure, public :: cells
    procedure, public :: set_boundary_pressure
    procedure, public :: set_cell_pressure
    procedure, public :: set_cell_stress
    procedure, public :: set_cell_temperature
    procedure, public :: cell_temperature
    procedure, public :: write_grdecl
    procedure, public :: save => save_image
    procedure, public :: restore
    procedure, public :: cracks
    procedure, public :: slips
    procedure, public :: fractures
    procedure, public :: fracture_line
    !> Copies of a field: call sim%get('disc.position', x) with x allocatable, of rank 1 if the field has one component,
    !> otherwise of shape (components, n); real(c_double) or integer(c_int32_t) as the field is.
    generic, public :: get => get_double_1, get_double_2, get_int32_1, get_int32_2
    !> The library's own memory, shape (components, n), not to be written to; valid as long as `epoch` stays the same.
    generic, public :: view => view_double, view_int32
    generic, public :: assignment(=) => refuse_copy
    procedure :: create_from_definition, create_from_file, step_int32, step_int64, refuse_copy
    procedure :: get_double_1, get_double_2, get_int32_1, get_int32_2, view_double, view_int32
    procedure :: describe, borrow, set_regular_grid, set_grid_corners
    final :: finish
  end type hfrac_simulation

  private :: create_from_definition, create_from_file, destroy, exists, c_handle, step_int32, step_int64, advance, &
    on_progress, on_step, on_log, definition, add_well, set_well_schedule, set_regular_grid, set_grid_corners, &
    cells, set_boundary_pressure, set_cell_pressure, set_cell_stress, write_grdecl, save_image, restore, cracks, &
    slips, fractures, fracture_line, get_double_1, get_double_2, get_int32_1, get_int32_2, view_double, view_int32, &
    refuse_copy, describe, borrow, finish, ask_host, show_step, tell_host, set_disc_temperature, &
    hold_disc_temperature, set_cell_temperature, cell_temperature

contains

  ! Life

  !> Builds a simulation: packs, cuts the wells, bonds, and brings the model to rest. HFRAC_STOPPED: the definition's
  !> progress procedure stopped it; there is no simulation then.
  subroutine create_from_definition(self, def, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    type(hfrac_definition), intent(in), target :: def
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_definition) :: full
    type(progress_holder), target :: holder
    character(:), allocatable :: fault
    integer(c_int32_t) :: status
    status = hfrac_sim_destroy(self%handle)
    if (status /= HFRAC_OK) then
      call report(status, self%handle, stat, errmsg)
      return
    end if
    full%values = def%values
    call full%init()
    call def%lend(full%values, fault)
    if (allocated(fault)) then
      call report_text(HFRAC_ERR_ARGUMENT, fault, stat, errmsg)
      return
    end if
    if (associated(def%progress)) then
      holder%ask => def%progress
      full%values%progress = c_funloc(ask_host)
      full%values%progress_user = c_loc(holder)
    end if
    if (associated(def%log)) then
      holder%log => def%log
      full%values%log = c_funloc(tell_host)
      full%values%log_user = c_loc(holder)
    end if
    if (allocated(def%exchange)) then
      call report(hfrac_sim_create_on(full%values, def%exchange, self%handle), c_null_ptr, stat, errmsg)
    else
      call report(hfrac_sim_create(full%values, self%handle), c_null_ptr, stat, errmsg)
    end if
  end subroutine create_from_definition

  !> Builds a simulation from a case file.
  subroutine create_from_file(self, case_file, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    character(*), intent(in) :: case_file
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_definition) :: def
    integer :: load_stat
    if (present(stat)) then
      call def%load(case_file, load_stat, errmsg)
      stat = load_stat
      if (load_stat < 0) return
    else
      call def%load(case_file)
    end if
    call self%create_from_definition(def, stat, errmsg)
    load_stat = hfrac_sim_def_free(def%values)
  end subroutine create_from_file

  !> Ends the simulation; there may be none.
  subroutine destroy(self, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: status
    status = hfrac_sim_destroy(self%handle)
    if (status == HFRAC_OK .and. associated(self%holder)) deallocate (self%holder)
    call report(status, self%handle, stat, errmsg)
  end subroutine destroy

  subroutine finish(self)
    type(hfrac_simulation), intent(inout) :: self
    integer :: unused
    call self%destroy(unused)
  end subroutine finish

  !> Two variables would end the same simulation twice.
  subroutine refuse_copy(left, right)
    class(hfrac_simulation), intent(inout) :: left
    type(hfrac_simulation), intent(in) :: right
    call left%destroy()
    if (c_associated(right%handle)) call report_text(HFRAC_ERR_ARGUMENT, 'a simulation cannot be copied.')
  end subroutine refuse_copy

  !> Whether there is a simulation.
  pure logical function exists(self)
    class(hfrac_simulation), intent(in) :: self
    exists = c_associated(self%handle)
  end function exists

  !> For calls of module hfrac_c; stays this variable's.
  pure function c_handle(self)
    class(hfrac_simulation), intent(in) :: self
    type(c_ptr) :: c_handle
    c_handle = self%handle
  end function c_handle

  ! Running

  !> Takes `count` steps, 1 if left out. stat: HFRAC_STOPPED if the progress procedure asked for it, HFRAC_STOP_CONDITION
  !> if stop.extent_fraction or stop.cracks is reached, HFRAC_NOT_AT_REST if the last step did not come to rest.
  subroutine step_int32(self, count, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    integer(c_int32_t), intent(in), optional :: count
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t) :: steps
    steps = 1
    if (present(count)) steps = count
    call self%step_int64(steps, stat, errmsg)
  end subroutine step_int32

  subroutine step_int64(self, count, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    integer(c_int64_t), intent(in) :: count
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call report(hfrac_step(self%handle, count), self%handle, stat, errmsg)
  end subroutine step_int64

  !> Steps until model time `time` [s] is reached, with `exact` at that time to the last bit, or a stop condition holds (stat:
  !> HFRAC_STOP_CONDITION); `reached` [s] and `reason` (HFRAC_REASON_...) say how far and why.
  subroutine advance(self, time, reached, reason, stat, errmsg, exact)
    class(hfrac_simulation), intent(inout) :: self
    real(c_double), intent(in) :: time
    real(c_double), intent(out), optional :: reached
    integer(c_int32_t), intent(out), optional :: reason
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    logical, intent(in), optional :: exact
    real(c_double) :: to
    integer(c_int32_t) :: status, why
    logical :: at_that_time
    at_that_time = .false.
    if (present(exact)) at_that_time = exact
    if (at_that_time) then
      status = hfrac_advance_to(self%handle, time, to, why)
    else
      status = hfrac_advance(self%handle, time, to, why)
    end if
    if (status < 0) then
      to = 0.0_c_double
      why = HFRAC_REASON_TARGET
    end if
    if (present(reached)) reached = to
    if (present(reason)) reason = why
    call report(status, self%handle, stat, errmsg)
  end subroutine advance

  !> Has `progress` called about every `seconds` of wall time (0, if left out: between any two steps and often within
  !> one); no procedure: none any more.
  subroutine on_progress(self, progress, seconds, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    procedure(hfrac_progress), optional :: progress
    real(c_double), intent(in), optional :: seconds
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double) :: every
    integer(c_int32_t) :: status
    every = 0.0_c_double
    if (present(seconds)) every = seconds
    if (present(progress)) then
      if (.not. associated(self%holder)) allocate (self%holder)
      self%holder%ask => progress
      status = hfrac_set_progress(self%handle, c_funloc(ask_host), c_loc(self%holder), every)
    else
      status = hfrac_set_progress(self%handle, c_null_funptr, c_null_ptr, every)
    end if
    call report(status, self%handle, stat, errmsg)
  end subroutine on_progress

  !> Has `on_step` called after every step; no procedure: none any more.
  subroutine on_step(self, look, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    procedure(hfrac_on_step), optional :: look
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: status
    if (present(look)) then
      if (.not. associated(self%holder)) allocate (self%holder)
      self%holder%step => look
      status = hfrac_set_on_step(self%handle, c_funloc(show_step), c_loc(self%holder))
    else
      status = hfrac_set_on_step(self%handle, c_null_funptr, c_null_ptr)
    end if
    call report(status, self%handle, stat, errmsg)
  end subroutine on_step

  !> Has `log` told what happens up to `level` (HFRAC_LOG_INFO if left out); no procedure: nobody any more.
  subroutine on_log(self, log, level, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    procedure(hfrac_log), optional :: log
    integer(c_int32_t), intent(in), optional :: level
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: status, up_to
    up_to = HFRAC_LOG_INFO
    if (present(level)) up_to = level
    if (present(log)) then
      if (.not. associated(self%holder)) allocate (self%holder)
      self%holder%log => log
      status = hfrac_set_log(self%handle, c_funloc(tell_host), c_loc(self%holder), up_to)
    else
      status = hfrac_set_log(self%handle, c_null_funptr, c_null_ptr, up_to)
    end if
    call report(status, self%handle, stat, errmsg)
  end subroutine on_log

  !> What the library calls after a step; `user` is a progress_holder.
  function show_step(user, sim, step, time) bind(C, name="") result(stop_now)
    type(c_ptr), value :: user
    type(c_ptr), value :: sim
    integer(c_int64_t), value :: step
    real(c_double), value :: time
    integer(c_int32_t) :: stop_now
    type(progress_holder), pointer :: holder
    stop_now = 0
    if (.not. c_associated(sim)) return
    call c_f_pointer(user, holder)
    stop_now = merge(1_c_int32_t, 0_c_int32_t, holder%step(step, time))
  end function show_step

  !> What the library tells; `user` is a progress_holder.
  function tell_host(user, level, message) bind(C, name="") result(unused)
    type(c_ptr), value :: user
    integer(c_int32_t), value :: level
    type(c_ptr), value :: message
    integer(c_int32_t) :: unused
    type(progress_holder), pointer :: holder
    call c_f_pointer(user, holder)
    call holder%log(level, from_c(message))
    unused = 0
  end function tell_host

  !> What the library calls; `user` is a progress_holder.
  function ask_host(user, fraction, what) bind(C, name="") result(stop_now)
    type(c_ptr), value :: user
    real(c_double), value :: fraction
    type(c_ptr), value :: what
    integer(c_int32_t) :: stop_now
    type(progress_holder), pointer :: holder
    call c_f_pointer(user, holder)
    stop_now = merge(1_c_int32_t, 0_c_int32_t, holder%ask(fraction, from_c(what)))
  end function ask_host

  ! How it stands

  !> What the simulation was built from, defaults filled in. Its lists are freed by def%free.
  subroutine definition(self, def, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    type(hfrac_definition), intent(inout) :: def
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call def%init()
    call report(hfrac_sim_definition(self%handle, def%values), self%handle, stat, errmsg)
  end subroutine definition

  ! Wells

  !> A further well, at any time between two steps: the pore of the rock nearest to (`x`, `y`) [m], shut in until it is driven.
  !> `index` is its number, from 0 (-1: refused). It belongs to the state: an image brings it back, one from before takes it away.
  subroutine add_well(self, x, y, index, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    real(c_double), intent(in) :: x, y
    integer, intent(out) :: index
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: new, status
    status = hfrac_well_add(self%handle, x, y, new)
    if (status < 0) new = -1
    index = int(new)
    call report(status, self%handle, stat, errmsg)
  end subroutine add_well

  !> Replaces the schedule of well `index` (from 0): from model time `time(k)` [s] on it is held at `value(k)` [Pa] where
  !> `control(k)` is HFRAC_WELL_PRESSURE, or takes `value(k)` [m2/s] where it is HFRAC_WELL_RATE. In order of time; steps end at
  !> the times; arrays without elements end the schedule.
  subroutine set_well_schedule(self, index, time, control, value, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    integer, intent(in) :: index
    real(c_double), intent(in), contiguous :: time(:), value(:)
    integer(c_int32_t), intent(in), contiguous :: control(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: count
    if (size(control) /= size(time) .or. size(value) /= size(time)) then
      call report_text(HFRAC_ERR_ARGUMENT, 'time, control and value must be of one size.', stat, errmsg)
      return
    end if
    count = size(time, kind=c_int32_t)
    call report(hfrac_well_set_schedule(self%handle, int(index, c_int32_t), count, time, control, value), &
                self%handle, stat, errmsg)
  end subroutine set_well_schedule

  ! Temperature, in kelvin.

  !> Gives every disc its temperature [K]. Needs thermal.mode "transport".
  subroutine set_disc_temperature(self, temperature, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    real(c_double), contiguous, intent(in) :: temperature(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call report(hfrac_set_disc_temperature(self%handle, temperature, size(temperature, kind=c_int64_t)), self%handle, stat, &
      errmsg)
  end subroutine set_disc_temperature

  !> Discs that keep their temperature whatever flows.
  subroutine hold_disc_temperature(self, held, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    logical, intent(in) :: held(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call report(hfrac_hold_disc_temperature(self%handle, int(merge(1, 0, held), c_int32_t), size(held, kind=c_int64_t)), &
      self%handle, stat, errmsg)
  end subroutine hold_disc_temperature

  ! A reservoir simulator's grid. Arrays have the grid's shape (nx, ny), i first.

  !> Lays a grid of nx times ny cells of `cell_size` (dx, dy) [m] over the model; `origin` [m] is the first corner of cell (1, 1),
  !> `angle` [rad] (0 if left out) turns it anticlockwise.
  subroutine set_regular_grid(self, nx, ny, origin, cell_size, angle, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    integer, intent(in) :: nx, ny
    real(c_double), intent(in) :: origin(2), cell_size(2)
    real(c_double), intent(in), optional :: angle
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_grid) :: grid
    integer(c_int32_t) :: status
    grid%nx = nx
    grid%ny = ny
    grid%origin = origin
    grid%dx = cell_size(1)
    grid%dy = cell_size(2)
    if (present(angle)) grid%angle = angle
    status = hfrac_set_grid(self%handle, grid)
    if (status >= 0) self%grid_shape = [grid%nx, grid%ny]
    call report(status, self%handle, stat, errmsg)
  end subroutine set_regular_grid

  !> The same for quadrilateral cells: x, y of the four corners of each in order around it, shape (2, 4, nx, ny) [m].
  subroutine set_grid_corners(self, corners, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    real(c_double), contiguous, target, intent(in) :: corners(:, :, :, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_grid) :: grid
    integer(c_int32_t) :: status
    if (size(corners, 1) /= 2 .or. size(corners, 2) /= 4 .or. size(corners) == 0) then
      call report_text(HFRAC_ERR_ARGUMENT, 'corners must have the shape (2, 4, nx, ny).', stat, errmsg)
      return
    end if
    grid%nx = size(corners, 3, c_int64_t)
    grid%ny = size(corners, 4, c_int64_t)
    grid%corners = c_loc(corners)
    status = hfrac_set_grid(self%handle, grid)
    if (status >= 0) self%grid_shape = [grid%nx, grid%ny]
    call report(status, self%handle, stat, errmsg)
  end subroutine set_grid_corners

  !> Every cell of the grid as it is now, shape (nx, ny); `method` HFRAC_UPSCALE_FLOW (if left out) or HFRAC_UPSCALE_ODA.
  subroutine cells(self, list, method, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    type(hfrac_cell), allocatable, target, intent(out) :: list(:, :)
    integer(c_int32_t), intent(in), optional :: method
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_cell) :: one
    integer(c_int64_t) :: count
    integer(c_int32_t) :: status, rule
    rule = HFRAC_UPSCALE_FLOW
    if (present(method)) rule = method
    allocate (list(self%grid_shape(1), self%grid_shape(2)))
    status = hfrac_grid_cells(self%handle, rule, int(c_sizeof(one), c_int32_t), c_loc(list), size(list, kind=c_int64_t), &
      count)
    call report(status, self%handle, stat, errmsg)
  end subroutine cells

  !> From the next step on, pressure [Pa] beyond the model's edge, shape (nx, ny); it stays until it is set anew or, without
  !> `pressure`, taken back: the formation's again.
  subroutine set_boundary_pressure(self, pressure, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    real(c_double), contiguous, intent(in), optional :: pressure(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: status
    if (present(pressure)) then
      status = hfrac_set_boundary_pressure(self%handle, pressure, size(pressure, kind=c_int64_t))
    else
      status = hfrac_set_boundary_pressure(self%handle, [real(c_double) ::], 0_c_int64_t)
    end if
    call report(status, self%handle, stat, errmsg)
  end subroutine set_boundary_pressure

  !> At once, gives the rock's pores the host's pressure [Pa], shape (nx, ny); `added` gets the fluid [m2] each cell gave.
  subroutine set_cell_pressure(self, pressure, added, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    real(c_double), contiguous, intent(in) :: pressure(:, :)
    real(c_double), allocatable, target, intent(out), optional :: added(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(c_ptr) :: room
    integer(c_int64_t) :: count
    count = size(pressure, kind=c_int64_t)
    room = c_null_ptr
    if (present(added)) then
      allocate (added(size(pressure, 1), size(pressure, 2)), source=0.0_c_double)
      if (count > 0) room = c_loc(added)
    end if
    call report(hfrac_set_cell_pressure(self%handle, pressure, count, room, count), self%handle, stat, errmsg)
  end subroutine set_cell_pressure

  !> From the next step on, stress [Pa] on top of the far field: xx, yy, xy, shape (3, nx, ny).
  subroutine set_cell_stress(self, stress, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    real(c_double), contiguous, intent(in) :: stress(:, :, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call report(hfrac_set_cell_stress(self%handle, stress, size(stress, kind=c_int64_t)), self%handle, stat, errmsg)
  end subroutine set_cell_stress

  !> Gives the discs of each cell the host's temperature [K], shape (nx, ny); the rock answers in the next step.
  subroutine set_cell_temperature(self, temperature, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    real(c_double), contiguous, intent(in) :: temperature(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call report(hfrac_set_cell_temperature(self%handle, temperature, size(temperature, kind=c_int64_t)), self%handle, &
      stat, errmsg)
  end subroutine set_cell_temperature

  !> Temperature [K] of the rock by cell, shape (nx, ny).
  subroutine cell_temperature(self, temperature, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    real(c_double), allocatable, target, intent(out) :: temperature(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t) :: count
    integer(c_int32_t) :: status
    allocate (temperature(self%grid_shape(1), self%grid_shape(2)), source=0.0_c_double)
    status = hfrac_get_cell_temperature(self%handle, c_loc(temperature), size(temperature, kind=c_int64_t), count)
    call report(status, self%handle, stat, errmsg)
  end subroutine cell_temperature

  !> Writes an Eclipse include file. Left out: HFRAC_UPSCALE_FLOW, HFRAC_GRDECL_PERM, one layer, the network's porosity and
  !> permeability [m2] of the rock.
  subroutine write_grdecl(self, path, method, kind, layers, porosity, permeability, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    character(*), intent(in) :: path
    integer(c_int32_t), intent(in), optional :: method, kind
    integer, intent(in), optional :: layers
    real(c_double), intent(in), optional :: porosity, permeability
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: rule, which
    integer(c_int64_t) :: repeats
    real(c_double) :: pores, rock
    rule = HFRAC_UPSCALE_FLOW
    which = HFRAC_GRDECL_PERM
    repeats = 1
    pores = 0.0_c_double
    rock = 0.0_c_double
    if (present(method)) rule = method
    if (present(kind)) which = kind
    if (present(layers)) repeats = layers
    if (present(porosity)) pores = porosity
    if (present(permeability)) rock = permeability
    call report(hfrac_write_grdecl(self%handle, to_c(path), rule, which, repeats, pores, rock), self%handle, stat, errmsg)
  end subroutine write_grdecl

  ! Going back: images of the state

  !> An image of the state, for `restore`.
  subroutine save_image(self, image, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    integer(c_int8_t), allocatable, target, intent(out) :: image(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t) :: bytes
    integer(c_int32_t) :: status
    status = hfrac_state_size(self%handle, bytes)
    if (status < 0) bytes = 0
    allocate (image(bytes))
    if (status >= 0) status = hfrac_state_save(self%handle, c_loc(image), size(image, kind=c_int64_t), bytes)
    call report(status, self%handle, stat, errmsg)
  end subroutine save_image

  !> Goes back to an image of this simulation; a damaged or foreign one is refused and changes nothing.
  subroutine restore(self, image, stat, errmsg)
    class(hfrac_simulation), intent(inout) :: self
    integer(c_int8_t), contiguous, target, intent(in) :: image(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call report(hfrac_state_restore(self%handle, c_loc(image), size(image, kind=c_int64_t)), self%handle, stat, errmsg)
  end subroutine restore

  ! Cracks and fractures

  !> Cracks in order of breakage, from id `since` (0 if left out) on; `next` is the `since` of the next call.
  subroutine cracks(self, list, since, next, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    type(hfrac_crack), allocatable, target, intent(out) :: list(:)
    integer(c_int64_t), intent(in), optional :: since
    integer(c_int64_t), intent(out), optional :: next
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_crack) :: one
    integer(c_int64_t) :: cursor, following, count
    integer(c_int32_t) :: status, crack_size
    cursor = 0
    if (present(since)) cursor = since
    crack_size = int(c_sizeof(one), c_int32_t)
    status = hfrac_cracks_since(self%handle, cursor, crack_size, c_null_ptr, 0_c_int64_t, count, following)
    if (status < 0) count = 0
    allocate (list(count))
    if (count > 0) then
      status = hfrac_cracks_since(self%handle, cursor, crack_size, c_loc(list), size(list, kind=c_int64_t), count, &
        following)
    end if
    if (present(next)) next = cursor + size(list, kind=c_int64_t)
    call report(status, self%handle, stat, errmsg)
  end subroutine cracks

  !> What smooth joints slipped, in order of time, from id `since` (0 if left out) on; `next` is the `since` of the next call.
  subroutine slips(self, list, since, next, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    type(hfrac_slip), allocatable, target, intent(out) :: list(:)
    integer(c_int64_t), intent(in), optional :: since
    integer(c_int64_t), intent(out), optional :: next
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_slip) :: one
    integer(c_int64_t) :: cursor, following, count
    integer(c_int32_t) :: status, slip_size
    cursor = 0
    if (present(since)) cursor = since
    slip_size = int(c_sizeof(one), c_int32_t)
    status = hfrac_slips_since(self%handle, cursor, slip_size, c_null_ptr, 0_c_int64_t, count, following)
    if (status < 0) count = 0
    allocate (list(count))
    if (count > 0) then
      status = hfrac_slips_since(self%handle, cursor, slip_size, c_loc(list), size(list, kind=c_int64_t), count, &
        following)
    end if
    if (present(next)) next = cursor + size(list, kind=c_int64_t)
    call report(status, self%handle, stat, errmsg)
  end subroutine slips

  !> Fractures as they are now, most cracks first.
  subroutine fractures(self, list, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    type(hfrac_fracture), allocatable, target, intent(out) :: list(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_fracture) :: one
    integer(c_int64_t) :: count
    integer(c_int32_t) :: status, fracture_size
    fracture_size = int(c_sizeof(one), c_int32_t)
    status = hfrac_fractures(self%handle, fracture_size, c_null_ptr, 0_c_int64_t, count)
    if (status < 0) count = 0
    allocate (list(count))
    if (count > 0) status = hfrac_fractures(self%handle, fracture_size, c_loc(list), size(list, kind=c_int64_t), count)
    call report(status, self%handle, stat, errmsg)
  end subroutine fractures

  !> A fracture, by its index in `fractures` from 0, as an ordered line from tip to tip.
  subroutine fracture_line(self, fracture, points, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    integer(c_int64_t), intent(in) :: fracture
    type(hfrac_fracture_point), allocatable, target, intent(out) :: points(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_fracture_point) :: one
    integer(c_int64_t) :: count
    integer(c_int32_t) :: status, point_size
    count = 0
    point_size = int(c_sizeof(one), c_int32_t)
    status = hfrac_fracture_line(self%handle, fracture, point_size, c_null_ptr, 0_c_int64_t, count)
    if (status < 0) count = 0
    allocate (points(count))
    if (count > 0) status = hfrac_fracture_line(self%handle, fracture, point_size, c_loc(points), &
      size(points, kind=c_int64_t), count)
    call report(status, self%handle, stat, errmsg)
  end subroutine fracture_line

  ! Fields

  !> Looks a field up by name for an array of rank `rank`.
  subroutine describe(self, name, rank, desc, found, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    character(*), intent(in) :: name
    integer, intent(in) :: rank
    type(hfrac_field_desc), intent(out) :: desc
    logical, intent(out) :: found
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int32_t) :: field, status
    found = .false.
    status = hfrac_field_find(to_c(name), field)
    if (status < 0) then
      call report(status, c_null_ptr, stat, errmsg)
      return
    end if
    status = hfrac_field_info(self%handle, field, desc)
    found = status >= 0
    call report(status, self%handle, stat, errmsg)
    if (.not. found .or. rank == 2 .or. desc%components == 1) return
    found = .false.
    call report_text(HFRAC_ERR_ARGUMENT, trim(name)//' has several components; give an array of rank 2.', stat, errmsg)
  end subroutine describe

  !> Address and shape of the library's own array of a field of type `dtype`; c_null_ptr if there is none.
  subroutine borrow(self, name, dtype, data, shape, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    character(*), intent(in) :: name
    integer, intent(in) :: dtype
    type(c_ptr), intent(out) :: data
    integer(c_int64_t), intent(out) :: shape(2)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_field_desc) :: desc
    integer(c_int64_t) :: count, taken_at
    integer(c_int32_t) :: status
    logical :: found
    data = c_null_ptr
    shape = 0
    call self%describe(name, 2, desc, found, stat, errmsg)
    if (.not. found) return
    if (desc%dtype /= dtype) then
      call report_text(HFRAC_ERR_ARGUMENT, trim(name)//' is of another type than the pointer given.', stat, errmsg)
      return
    end if
    status = hfrac_field_view(self%handle, desc%field, data, count, taken_at)
    if (status < 0) data = c_null_ptr
    if (status >= 0) shape = [int(desc%components, c_int64_t), desc%count]
    call report(status, self%handle, stat, errmsg)
  end subroutine borrow

  subroutine get_double_1(self, name, values, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    character(*), intent(in) :: name
    real(c_double), allocatable, target, intent(out) :: values(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_field_desc) :: desc
    integer(c_int64_t) :: count
    integer(c_int32_t) :: status
    logical :: found
    call self%describe(name, 1, desc, found, stat, errmsg)
    if (found) then
      allocate (values(desc%count))
      status = hfrac_field_copy_f64(self%handle, desc%field, c_loc(values), size(values, kind=c_int64_t), count)
      call report(status, self%handle, stat, errmsg)
    else
      allocate (values(0))
    end if
  end subroutine get_double_1

  subroutine get_double_2(self, name, values, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    character(*), intent(in) :: name
    real(c_double), allocatable, target, intent(out) :: values(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_field_desc) :: desc
    integer(c_int64_t) :: count
    integer(c_int32_t) :: status
    logical :: found
    call self%describe(name, 2, desc, found, stat, errmsg)
    if (found) then
      allocate (values(desc%components, desc%count))
      status = hfrac_field_copy_f64(self%handle, desc%field, c_loc(values), size(values, kind=c_int64_t), count)
      call report(status, self%handle, stat, errmsg)
    else
      allocate (values(0, 0))
    end if
  end subroutine get_double_2

  subroutine get_int32_1(self, name, values, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    character(*), intent(in) :: name
    integer(c_int32_t), allocatable, target, intent(out) :: values(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_field_desc) :: desc
    integer(c_int64_t) :: count
    integer(c_int32_t) :: status
    logical :: found
    call self%describe(name, 1, desc, found, stat, errmsg)
    if (found) then
      allocate (values(desc%count))
      status = hfrac_field_copy_i32(self%handle, desc%field, c_loc(values), size(values, kind=c_int64_t), count)
      call report(status, self%handle, stat, errmsg)
    else
      allocate (values(0))
    end if
  end subroutine get_int32_1

  subroutine get_int32_2(self, name, values, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    character(*), intent(in) :: name
    integer(c_int32_t), allocatable, target, intent(out) :: values(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_field_desc) :: desc
    integer(c_int64_t) :: count
    integer(c_int32_t) :: status
    logical :: found
    call self%describe(name, 2, desc, found, stat, errmsg)
    if (found) then
      allocate (values(desc%components, desc%count))
      status = hfrac_field_copy_i32(self%handle, desc%field, c_loc(values), size(values, kind=c_int64_t), count)
      call report(status, self%handle, stat, errmsg)
    else
      allocate (values(0, 0))
    end if
  end subroutine get_int32_2

  subroutine view_double(self, name, values, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    character(*), intent(in) :: name
    real(c_double), pointer, intent(out) :: values(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(c_ptr) :: data
    integer(c_int64_t) :: shape(2)
    nullify (values)
    call self%borrow(name, 0, data, shape, stat, errmsg)
    if (c_associated(data)) call c_f_pointer(data, values, shape)
  end subroutine view_double

  subroutine view_int32(self, name, values, stat, errmsg)
    class(hfrac_simulation), intent(in) :: self
    character(*), intent(in) :: name
    integer(c_int32_t), pointer, intent(out) :: values(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(c_ptr) :: data
    integer(c_int64_t) :: shape(2)
    nullify (values)
    call self%borrow(name, 1, data, shape, stat, errmsg)
    if (c_associated(data)) call c_f_pointer(data, values, shape)
  end subroutine view_int32

end module hfrac
