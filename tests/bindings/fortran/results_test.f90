! SPDX-License-Identifier: BSD-3-Clause
! What is read: fields, cracks, slips, fractures, the catalogue.
module fortran_test_results
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: int64, real64
  use fortran_test_support, only: case_file, expect
  use hfrac
  implicit none
  private
  public :: fields, cracks_and_fractures

contains

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

end module fortran_test_results
