! SPDX-License-Identifier: BSD-3-Clause
! Seconds of processor time for single steps, as Fortran takes them.   step CASE STEPS
program step
  use, intrinsic :: iso_c_binding, only: c_double
  use hfrac
  implicit none
  type(hfrac_simulation) :: sim
  character(1000) :: case_file, number
  integer :: k, steps
  real(c_double) :: start, end
  call get_command_argument(1, case_file)
  call get_command_argument(2, number)
  read (number, *) steps
  call sim%create(case_file)
  call cpu_time(start)
  do k = 1, steps
    call sim%step()
  end do
  call cpu_time(end)
  print '(f0.6)', end - start
end program step
