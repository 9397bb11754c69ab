! SPDX-License-Identifier: BSD-3-Clause
! Without `stat`, an error ends the program with the library's text and a status other than 0.
program fortran_stops
  use hfrac
  implicit none
  type(hfrac_definition) :: def
  call def%set('packing.disk_count', 500)
  print '(a)', 'still here'
end program fortran_stops
