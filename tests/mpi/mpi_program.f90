! SPDX-License-Identifier: BSD-3-Clause
! An MPI program in Fortran: one simulation over all ranks; each prints its state's hash.
program mpi_program
  use mpi
  use hfrac
  use hfrac_mpi
  implicit none
  type(hfrac_definition) :: def
  type(hfrac_simulation) :: sim
  integer :: error
  call MPI_Init(error)
  call def%set('packing.disc_count', 2000)
  call def%set('stepping.flow_step', 1d-2)
  call def%set('well[0].radius', 10d0)
  call def%set('well[0].pressure', 65d6)
  allocate (def%exchange)
  call over_communicator(MPI_COMM_WORLD, def%exchange)
  call sim%create(def)
  call sim%step(2)
  print '(z16.16)', sim%state_hash()
  call sim%destroy()
  call MPI_Finalize(error)
end program mpi_program
