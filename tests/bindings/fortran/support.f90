! SPDX-License-Identifier: BSD-3-Clause
! What all parts of the Fortran test share: the case file, and a count of what failed.
module fortran_test_support
  use, intrinsic :: iso_fortran_env, only: error_unit
  implicit none
  integer :: failures = 0
  character(1000) :: case_file

contains

  subroutine expect(condition, what)
    logical, intent(in) :: condition
    character(*), intent(in) :: what
    if (condition) return
    write (error_unit, '(2a)') 'failed: ', what
    failures = failures + 1
  end subroutine expect

end module fortran_test_support

! Procedures that the library calls.
module fortran_test_progress
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t
  use hfrac, only: HFRAC_LOG_ERROR
  implicit none
  integer :: calls = 0
  integer :: steps = 0, messages = 0
  logical :: stop_at_once = .false.
contains
  function count_steps(step, time) result(stop_now)
    integer(c_int64_t), intent(in) :: step
    real(c_double), intent(in) :: time
    logical :: stop_now
    steps = steps + 1
    stop_now = step == 3 .or. time < 0.0_c_double
  end function count_steps

  subroutine count_messages(level, message)
    integer(c_int32_t), intent(in) :: level
    character(*), intent(in) :: message
    if (level >= HFRAC_LOG_ERROR .and. len_trim(message) > 0) messages = messages + 1
  end subroutine count_messages

  function count_calls(fraction, what) result(stop_now)
    real(c_double), intent(in) :: fraction
    character(*), intent(in) :: what
    logical :: stop_now
    calls = calls + 1
    stop_now = stop_at_once .or. fraction < 0.0_c_double .or. len(what) == 0
  end function count_calls
end module fortran_test_progress
