! SPDX-License-Identifier: BSD-3-Clause
! What a simulation is made of: library, options, definitions, lists, own discs.
module fortran_test_definition
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: int64, real64
  use fortran_test_support, only: case_file, expect
  use hfrac
  implicit none
  private
  public :: library, options, definition, own_discs

contains

  subroutine library()
    integer(c_int32_t) :: major, minor, patch, abi, needed
    integer :: devices
    character(kind=c_char), target :: buffer(200)
    call expect(hfrac_version(major, minor, patch) == HFRAC_OK, 'version')
    call expect(major == HFRAC_VERSION_MAJOR .and. minor == HFRAC_VERSION_MINOR, 'version of the module')
    call expect(hfrac_abi_version(abi) == HFRAC_OK .and. abi == HFRAC_ABI_NUMBER, 'ABI number')
    call expect(index(hfrac_info(), 'hfrac') == 1, 'build info')
    call expect(len_trim(hfrac_device_list(devices)) > 0 .and. devices >= 0, 'devices, or why there are none')
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
    call def%pack('/nonexistent/model', stat, message)
    call expect(stat == HFRAC_ERR_FILE .and. index(message, '/nonexistent/model') > 0, 'a model that cannot be written')
    call def%pack('definition_test.model')
    call def%set('packing.file', 'definition_test.model')
    call expect(def%get_text('packing.file') == 'definition_test.model', 'the name of a packed model')
    call def%check()
    call def%set('packing.porosity', 0.14_real64)
    call def%check(stat, message)
    call expect(stat == HFRAC_ERR_MODEL .and. index(message, 'packing.porosity') > 0, 'a model of other discs')
    call def%set('packing.file', '')
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

end module fortran_test_definition
