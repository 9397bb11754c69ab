! SPDX-License-Identifier: BSD-3-Clause
!> One simulation over the ranks of an MPI communicator (libhfrac_mpi). Not part of the library of modules, so that programs without
!> MPI need none: compile this file with the program and link -lhfrac_mpi.
!>
!>     allocate (def%exchange)
!>     call over_communicator(MPI_COMM_WORLD, def%exchange)     ! mpi_f08: MPI_COMM_WORLD%MPI_VAL
!>     call sim%create(def)
module hfrac_mpi
  use, intrinsic :: iso_c_binding, only: c_int32_t
  use hfrac_c, only: hfrac_exchange, hfrac_linear_solver
  implicit none
  private
  public :: over_communicator, hfrac_mpi_exchange, hfrac_petsc_solver

  interface
    !> The table by which ranks of a communicator talk; collective. It holds as long as the communicator. Unstable since 0.2.
    function hfrac_mpi_exchange(fortran_comm, exchange) bind(C, name="hfrac_mpi_exchange")
      import :: c_int32_t, hfrac_exchange
      integer(c_int32_t), value :: fortran_comm
      type(hfrac_exchange), intent(out) :: exchange
      integer(c_int32_t) :: hfrac_mpi_exchange
    end function hfrac_mpi_exchange

    !> PETSc's solvers over those ranks (-lhfrac_petsc), collective: def%exchange%linear_solver = c_loc(solver), with `solver` a target that
    !> lives until the simulation has been created. Unstable since 0.2.
    function hfrac_petsc_solver(fortran_comm, solver) bind(C, name="hfrac_petsc_solver")
      import :: c_int32_t, hfrac_linear_solver
      integer(c_int32_t), value :: fortran_comm
      type(hfrac_linear_solver), intent(out) :: solver
      integer(c_int32_t) :: hfrac_petsc_solver
    end function hfrac_petsc_solver
  end interface

contains

  !> Collective. Without `stat` an error ends the program.
  subroutine over_communicator(comm, exchange, stat)
    integer, intent(in) :: comm
    type(hfrac_exchange), intent(out) :: exchange
    integer, intent(out), optional :: stat
    integer(c_int32_t) :: status
    status = hfrac_mpi_exchange(int(comm, c_int32_t), exchange)
    if (present(stat)) then
      stat = status
    else if (status /= 0) then
      error stop 'hfrac_mpi: the communicator cannot be used; is MPI initialised?'
    end if
  end subroutine over_communicator
end module hfrac_mpi
