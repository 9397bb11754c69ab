! SPDX-License-Identifier: BSD-3-Clause
!> Texts between Fortran and C, and errors the Fortran way.
module hfrac_text
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: error_unit
  use hfrac_c
  implicit none
  private
  public :: from_c, to_c, report, report_text, hfrac_info, hfrac_device_list

  interface
    pure function c_strlen(text) bind(C, name="strlen")
      import :: c_ptr, c_size_t
      type(c_ptr), value :: text
      integer(c_size_t) :: c_strlen
    end function c_strlen
  end interface

contains

  !> `text` without trailing blanks, ended for C.
  pure function to_c(text)
    character(*), intent(in) :: text
    character(len_trim(text) + 1, kind=c_char) :: to_c
    to_c = trim(text)//c_null_char
  end function to_c

  !> A copy of a text of the library; empty for c_null_ptr.
  function from_c(pointer) result(text)
    type(c_ptr), intent(in) :: pointer
    character(:), allocatable :: text
    character(kind=c_char), pointer :: bytes(:)
    integer :: i, length
    length = 0
    if (c_associated(pointer)) length = int(c_strlen(pointer))
    allocate (character(length) :: text)
    if (length == 0) return
    call c_f_pointer(pointer, bytes, [length])
    do i = 1, length
      text(i:i) = bytes(i)
    end do
  end function from_c

  !> Hands a status on: to `stat` if it is there; otherwise an error ends the program with the library's text. `handle`
  !> is the simulation the call was about, c_null_ptr if none. `errmsg` is changed by errors alone.
  subroutine report(status, handle, stat, errmsg)
    integer(c_int32_t), intent(in) :: status
    type(c_ptr), intent(in) :: handle
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(kind=c_char), target :: buffer(4096)
    integer(c_int32_t) :: needed
    if (status >= 0) then
      if (present(stat)) stat = int(status)
      return
    end if
    if (hfrac_last_error(handle, c_loc(buffer), size(buffer, kind=c_int32_t), needed) /= HFRAC_OK) buffer = c_null_char
    call report_text(status, from_c(c_loc(buffer)), stat, errmsg)
  end subroutine report

  !> The same for an error whose text is at hand.
  subroutine report_text(status, text, stat, errmsg)
    integer(c_int32_t), intent(in) :: status
    character(*), intent(in) :: text
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (present(errmsg)) errmsg = text
    if (present(stat)) then
      stat = int(status)
      return
    end if
    write (error_unit, '(2a)') 'hfrac: ', text
    error stop 1
  end subroutine report_text

  !> Version, compiler and instruction set of the library that runs, as one line.
  function hfrac_info() result(text)
    character(:), allocatable :: text
    character(kind=c_char), target :: buffer(1024)
    integer(c_int32_t) :: needed
    call report(hfrac_build_info(c_loc(buffer), size(buffer, kind=c_int32_t), needed), c_null_ptr)
    text = from_c(c_loc(buffer))
  end function hfrac_info

  !> The cards that run.device = "gpu" can use, a line each; with none (count 0) a line that says why. Unstable since 0.2.
  function hfrac_device_list(count) result(text)
    integer, intent(out) :: count
    character(:), allocatable :: text
    character(kind=c_char), target :: buffer(4096)
    integer(c_int32_t) :: found, needed
    call report(hfrac_devices(found, c_loc(buffer), size(buffer, kind=c_int32_t), needed), c_null_ptr)
    count = int(found)
    text = from_c(c_loc(buffer))
  end function hfrac_device_list

end module hfrac_text
