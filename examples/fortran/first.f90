! The shortest useful program: build a case, run it, ask for the fracture.
!   gfortran $(pkg-config --variable=sources hfrac-fortran) first.f90 $(pkg-config --libs hfrac-fortran)
!   ./a.out case.toml
program first
  use hfrac
  implicit none
  type(hfrac_simulation) :: sim
  type(hfrac_fracture), allocatable :: fractures(:)
  character(1000) :: case_file

  call get_command_argument(1, case_file)
  call sim%create(case_file)
  call sim%step(20)
  call sim%fractures(fractures)
  if (size(fractures) == 0) then
    print '(a)', 'no fracture'
  else
    print '(a,f0.1,a,f0.1,a,i0,a)', 'fracture of ', fractures(1)%length, ' m, ', &
      1e3*fractures(1)%largest_aperture, ' mm wide, ', fractures(1)%crack_count, ' cracks'
  end if
end program first
