! SPDX-License-Identifier: BSD-3-Clause
! The same lines as report.c, through module hfrac.
program report_program
  use, intrinsic :: iso_fortran_env, only: int64, real64
  use hfrac
  implicit none
  type(hfrac_simulation) :: sim
  type(hfrac_sim_state) :: state
  type(hfrac_crack), allocatable :: cracks(:)
  type(hfrac_fracture), allocatable :: fractures(:)
  character(1000) :: case_file
  integer(int64) :: total
  integer :: i

  call get_command_argument(1, case_file)
  call sim%create(case_file)
  call sim%step(5)

  print '(a,1x,i0)', 'hash', sim%state_hash()
  state = sim%state()
  print '(a,3(1x,i0))', 'state', state%step, state%cycles, bits_of(state%time)

  call sim%cracks(cracks)
  total = 0
  do i = 1, size(cracks)
    total = mix(mix(total, cracks(i)%bond), bits_of(cracks(i)%aperture))
    total = mix(mix(total, bits_of(cracks(i)%position(2))), cracks(i)%disc(2))
  end do
  print '(a,2(1x,i0))', 'cracks', size(cracks), total
  call sim%fractures(fractures)
  if (size(fractures) > 0) print '(a,2(1x,i0))', 'fractures', size(fractures), bits_of(fractures(1)%length)

  call report_double('disc.position')
  call report_double('disc.radius')
  call report_double('disc.stress')
  call report_integer('disc.intact_bonds')
  call report_integer('bond.discs')
  call report_double('bond.normal_force')
  call report_double('pipe.aperture')
  call report_double('domain.pressure')
  call report_integer('domain.kind')

contains

  pure integer(int64) function mix(total, bits)
    integer(int64), intent(in) :: total, bits
    mix = ieor(ishftc(total, 1), bits)
  end function mix

  pure integer(int64) function bits_of(value)
    real(real64), intent(in) :: value
    bits_of = transfer(value, bits_of)
  end function bits_of

  subroutine report_double(name)
    character(*), intent(in) :: name
    real(real64), allocatable :: values(:, :)
    integer(int64) :: total
    integer :: i, k
    call sim%get(name, values)
    total = 0
    do i = 1, size(values, 2)
      do k = 1, size(values, 1)
        total = mix(total, bits_of(values(k, i)))
      end do
    end do
    print '(a,3(1x,i0))', name, size(values, 1), size(values, 2), total
  end subroutine report_double

  subroutine report_integer(name)
    character(*), intent(in) :: name
    integer, allocatable :: values(:, :)
    integer(int64) :: total
    integer :: i, k
    call sim%get(name, values)
    total = 0
    do i = 1, size(values, 2)
      do k = 1, size(values, 1)
        total = mix(total, int(values(k, i), int64))
      end do
    end do
    print '(a,3(1x,i0))', name, size(values, 1), size(values, 2), total
  end subroutine report_integer

end program report_program
