! SPDX-License-Identifier: BSD-3-Clause
! Module hfrac from outside: every procedure at least once, right use and wrong, with floating-point traps armed.
!   fortran_test CASE
program fortran_test
  use fortran_test_support, only: case_file, failures
  use fortran_test_definition
  use fortran_test_stepping
  use fortran_test_results
  use fortran_test_outside
  use fortran_test_laboratory
  implicit none

  call get_command_argument(1, case_file)
  call library()
  call options()
  call definition()
  call building()
  call running()
  call wells()
  call wellbores()
  call one_rank()
  call fields()
  call cracks_and_fractures()
  call progress()
  call going_back()
  call exchange()
  call warm()
  call wrong_use()
  call own_discs()
  call two_at_once()
  call rock_tests()
  if (failures > 0) error stop 1
  print '(a)', 'all good'
end program fortran_test
