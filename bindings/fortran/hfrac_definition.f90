! SPDX-License-Identifier: BSD-3-Clause
!> What a simulation is made of: options by key, wells, own discs, case files.
module hfrac_definition_module
  use, intrinsic :: iso_c_binding
  use hfrac_c
  use hfrac_text
  implicit none
  private
  public :: hfrac_definition, hfrac_progress, hfrac_on_step, hfrac_log

  abstract interface
    !> Called while a simulation is built and while it runs, with the share done in [0, 1] and what is being done.
    !> A true result stops. Use a module procedure: an internal one needs an executable stack with some compilers.
    function hfrac_progress(fraction, what) result(stop_now)
      import :: c_double
      real(c_double), intent(in) :: fraction
      character(*), intent(in) :: what
      logical :: stop_now
    end function hfrac_progress
    !> Called after every step with its number and the model time [s]. A true result stops after that step. Simulations
    !> may be read from it.
    function hfrac_on_step(step, time) result(stop_now)
      import :: c_double, c_int64_t
      integer(c_int64_t), intent(in) :: step
      real(c_double), intent(in) :: time
      logical :: stop_now
    end function hfrac_on_step

    !> Told what happens, and how much it matters (HFRAC_LOG_...).
    subroutine hfrac_log(level, message)
      import :: c_int32_t
      integer(c_int32_t), intent(in) :: level
      character(*), intent(in) :: message
    end subroutine hfrac_log
  end interface

  !> The options of a simulation. Starts with every option at its default; any number of set and load, in any order.
  !>
  !> Every procedure that can fail takes `stat` (0 good, negative an error, positive a note) and `errmsg` (set by
  !> errors). Without `stat`, an error ends the program with its text.
  type :: hfrac_definition
    !> The C struct, for plain assignment after `init`.
    type(hfrac_sim_def) :: values
    !> Own packing: x, y, radius [m] of each disc as (3, n); not allocated: the engine packs.
    real(c_double), allocatable :: discs(:, :)
    !> Which of them are bonded: two indices, from 0, per bond as (2, m); not allocated: all that are near.
    integer(c_int64_t), allocatable :: bonds(:, :)
    !> Asked while the simulation is built.
    procedure(hfrac_progress), pointer, nopass :: progress => null()
    !> Told what happens while the simulation is built.
    procedure(hfrac_log), pointer, nopass :: log => null()
    !> How the ranks talk that build and step the simulation together (module hfrac_mpi); not allocated: there is one.
    type(hfrac_exchange), allocatable :: exchange
  contains
    procedure :: init
    procedure :: free
    procedure :: copy_to
    procedure :: load
    procedure :: add_traces
    !> Lists of any length at once: call def%set_wells([hfrac_well_def(...), ...]); by key they grow item by item.
    procedure :: set_wells
    procedure :: set_joints
    procedure :: set_schedule
    procedure :: check
    procedure :: disc_radii
    procedure :: pack
    procedure :: lend
    procedure :: get
    procedure :: get_integer
    procedure :: get_text
    procedure :: case_text
    generic :: set => set_double, set_int32, set_int64, set_text
    procedure, private :: set_double, set_int32, set_int64, set_text
  end type hfrac_definition

contains

  !> Defaults, once; the other procedures see to it themselves.
  subroutine init(self)
    class(hfrac_definition), intent(inout) :: self
    if (self%values%struct_size /= 0) return
    call report(hfrac_sim_def_init(self%values, int(c_sizeof(self%values), c_int32_t)), c_null_ptr)
  end subroutine init

  !> Ends the lists (wells, joints, schedule), which the library holds; they are empty then. Assigning a definition does not
  !> copy them: of two such, one is used and freed, or the other is made with copy_to.
  subroutine free(self, stat, errmsg)
    class(hfrac_definition), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call self%init()
    call report(hfrac_sim_def_free(self%values), c_null_ptr, stat, errmsg)
  end subroutine free

  !> The same values in another definition, with lists, discs and bonds of its own.
  subroutine copy_to(self, other, stat, errmsg)
    class(hfrac_definition), intent(inout) :: self
    type(hfrac_definition), intent(inout) :: other
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call self%init()
    call other%init()
    if (allocated(self%discs)) other%discs = self%discs
    if (allocated(self%bonds)) other%bonds = self%bonds
    other%progress => self%progress
    other%log => self%log
    if (allocated(self%exchange)) other%exchange = self%exchange
    call report(hfrac_sim_def_copy(self%values, other%values), c_null_ptr, stat, errmsg)
  end subroutine copy_to

  !> These wells instead of those that are set.
  subroutine set_wells(self, wells, stat, errmsg)
    class(hfrac_definition), intent(inout) :: self
    type(hfrac_well_def), intent(in), target, contiguous :: wells(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_sim_def) :: given
    call self%init()
    given = self%values
    given%well_count = size(wells, kind=c_int64_t)
    given%wells = c_null_ptr
    if (size(wells) > 0) then
      given%wells = c_loc(wells)
      given%well_size = c_sizeof(wells(1))
    end if
    call report(hfrac_sim_def_copy(given, self%values), c_null_ptr, stat, errmsg)
  end subroutine set_wells

  !> These joints instead of those that are set. Set every value of each: zeros are not the defaults of the keys.
  subroutine set_joints(self, joints, stat, errmsg)
    class(hfrac_definition), intent(inout) :: self
    type(hfrac_joint_def), intent(in), target, contiguous :: joints(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_sim_def) :: given
    call self%init()
    given = self%values
    given%joint_count = size(joints, kind=c_int64_t)
    given%joints = c_null_ptr
    if (size(joints) > 0) then
      given%joints = c_loc(joints)
      given%joint_size = c_sizeof(joints(1))
    end if
    call report(hfrac_sim_def_copy(given, self%values), c_null_ptr, stat, errmsg)
  end subroutine set_joints

  !> This schedule of the wells instead of the one that is set.
  subroutine set_schedule(self, entries, stat, errmsg)
    class(hfrac_definition), intent(inout) :: self
    type(hfrac_schedule_def), intent(in), target, contiguous :: entries(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_sim_def) :: given
    call self%init()
    given = self%values
    given%schedule_count = size(entries, kind=c_int64_t)
    given%schedule = c_null_ptr
    if (size(entries) > 0) then
      given%schedule = c_loc(entries)
      given%schedule_size = c_sizeof(entries(1))
    end if
    call report(hfrac_sim_def_copy(given, self%values), c_null_ptr, stat, errmsg)
  end subroutine set_schedule

  !> Reads a case file over what is set so far.
  subroutine load(self, path, stat, errmsg)
    class(hfrac_definition), intent(inout) :: self
    character(*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call self%init()
    call report(hfrac_sim_def_load(self%values, to_c(path)), c_null_ptr, stat, errmsg)
  end subroutine load

  !> Adds a joint for each trace of a table or of GeoJSON [m]; all but its ends has its default.
  subroutine add_traces(self, path, stat, errmsg)
    class(hfrac_definition), intent(inout) :: self
    character(*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call self%init()
    call report(hfrac_sim_def_add_traces(self%values, to_c(path)), c_null_ptr, stat, errmsg)
  end subroutine add_traces

  !> Refuses what no simulation can be built from. With the path of the case file that was loaded the text also names the
  !> file and the line of the value.
  subroutine check(self, stat, errmsg, path)
    class(hfrac_definition), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(*), intent(in), optional :: path
    call self%init()
    if (present(path)) then
      call report(hfrac_sim_def_check_file(self%values, to_c(path)), c_null_ptr, stat, errmsg)
    else
      call report(hfrac_sim_def_check(self%values), c_null_ptr, stat, errmsg)
    end if
  end subroutine check

  !> Mean radius of the packing's discs where they are fine, and where they are coarsest [m]; the same in a uniform packing.
  subroutine disc_radii(self, fine, coarsest, stat, errmsg)
    class(hfrac_definition), intent(inout) :: self
    real(c_double), intent(out) :: fine, coarsest
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call self%init()
    call report(hfrac_sim_def_disc_radii(self%values, fine, coarsest), c_null_ptr, stat, errmsg)
  end subroutine disc_radii

  !> Packs the model, brings it to rest and keeps it as file `path`, for definitions that name it as packing.file.
  subroutine pack(self, path, stat, errmsg)
    class(hfrac_definition), intent(inout) :: self
    character(*), intent(in) :: path
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(hfrac_sim_def) :: full
    character(:), allocatable :: fault
    call self%init()
    full = self%values
    call self%lend(full, fault)
    if (allocated(fault)) then
      call report_text(HFRAC_ERR_ARGUMENT, fault, stat, errmsg)
    else
      call report(hfrac_pack(full, to_c(path)), c_null_ptr, stat, errmsg)
    end if
  end subroutine pack

  !> Has `values` borrow the discs and bonds of this definition; `fault` says why not.
  subroutine lend(self, values, fault)
    class(hfrac_definition), intent(in), target :: self
    type(hfrac_sim_def), intent(inout) :: values
    character(:), allocatable, intent(out) :: fault
    if (allocated(self%discs)) then
      if (size(self%discs, 1) /= 3) fault = 'discs must have the shape (3, n): x, y, radius.'
      values%given_disc_count = size(self%discs, 2, c_int64_t)
      if (size(self%discs) > 0) values%given_discs = c_loc(self%discs)
    end if
    if (allocated(self%bonds)) then
      if (size(self%bonds, 1) /= 2) fault = 'bonds must have the shape (2, m): two discs each, from 0.'
      values%given_bond_count = size(self%bonds, 2, c_int64_t)
      if (size(self%bonds) > 0) values%given_bonds = c_loc(self%bonds)
    end if
  end subroutine lend

  !> An option by its key, integers and choices as a double.
  function get(self, key, stat, errmsg) result(value)
    class(hfrac_definition), intent(inout) :: self
    character(*), intent(in) :: key
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    real(c_double) :: value
    integer(c_int32_t) :: status
    call self%init()
    status = hfrac_sim_def_get_f64(self%values, to_c(key), value)
    if (status < 0) value = 0.0_c_double
    call report(status, c_null_ptr, stat, errmsg)
  end function get

  !> An integer option, or a choice's index, by its key.
  function get_integer(self, key, stat, errmsg) result(value)
    class(hfrac_definition), intent(inout) :: self
    character(*), intent(in) :: key
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    integer(c_int64_t) :: value
    integer(c_int32_t) :: status
    call self%init()
    status = hfrac_sim_def_get_i64(self%values, to_c(key), value)
    if (status < 0) value = 0_c_int64_t
    call report(status, c_null_ptr, stat, errmsg)
  end function get_integer

  !> Any option as text: a choice's word, 'title', numbers with all their digits.
  function get_text(self, key, stat, errmsg) result(text)
    class(hfrac_definition), intent(inout) :: self
    character(*), intent(in) :: key
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(:), allocatable :: text
    character(kind=c_char), allocatable, target :: buffer(:)
    integer(c_int32_t) :: needed, status
    call self%init()
    status = hfrac_sim_def_get_str(self%values, to_c(key), c_null_ptr, 0_c_int32_t, needed)
    if (status == HFRAC_OK) then
      allocate (buffer(needed))
      status = hfrac_sim_def_get_str(self%values, to_c(key), c_loc(buffer), size(buffer, kind=c_int32_t), needed)
    end if
    text = ''
    if (status == HFRAC_OK) text = from_c(c_loc(buffer))
    call report(status, c_null_ptr, stat, errmsg)
  end function get_text

  !> The definition as a case file with every option filled in.
  function case_text(self, stat, errmsg) result(text)
    class(hfrac_definition), intent(inout) :: self
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(:), allocatable :: text
    character(kind=c_char), allocatable, target :: buffer(:)
    integer(c_int32_t) :: needed, status
    call self%init()
    status = hfrac_sim_def_write(self%values, c_null_ptr, 0_c_int32_t, needed)
    if (status == HFRAC_OK) then
      allocate (buffer(needed))
      status = hfrac_sim_def_write(self%values, c_loc(buffer), size(buffer, kind=c_int32_t), needed)
    end if
    text = ''
    if (status == HFRAC_OK) text = from_c(c_loc(buffer))
    call report(status, c_null_ptr, stat, errmsg)
  end function case_text

  !> A real option: call def%set('fluid.viscosity', 0.1_c_double). Single precision is not taken: it would lose digits.
  subroutine set_double(self, key, value, stat, errmsg)
    class(hfrac_definition), intent(inout) :: self
    character(*), intent(in) :: key
    real(c_double), intent(in) :: value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call self%init()
    call report(hfrac_sim_def_set_f64(self%values, to_c(key), value), c_null_ptr, stat, errmsg)
  end subroutine set_double

  !> An integer option, or a real one by an integer.
  subroutine set_int64(self, key, value, stat, errmsg)
    class(hfrac_definition), intent(inout) :: self
    character(*), intent(in) :: key
    integer(c_int64_t), intent(in) :: value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call self%init()
    call report(hfrac_sim_def_set_i64(self%values, to_c(key), value), c_null_ptr, stat, errmsg)
  end subroutine set_int64

  subroutine set_int32(self, key, value, stat, errmsg)
    class(hfrac_definition), intent(inout) :: self
    character(*), intent(in) :: key
    integer(c_int32_t), intent(in) :: value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call self%set_int64(key, int(value, c_int64_t), stat, errmsg)
  end subroutine set_int32

  !> A choice by its word, or 'title'. Trailing blanks do not count.
  subroutine set_text(self, key, value, stat, errmsg)
    class(hfrac_definition), intent(inout) :: self
    character(*), intent(in) :: key
    character(*), intent(in) :: value
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    call self%init()
    call report(hfrac_sim_def_set_str(self%values, to_c(key), to_c(value)), c_null_ptr, stat, errmsg)
  end subroutine set_text

end module hfrac_definition_module
