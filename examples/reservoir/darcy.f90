! SPDX-License-Identifier: BSD-3-Clause
!> A small reservoir simulator: one slightly compressible fluid in a plane of unit thickness, Darcy's law, finite volumes on equal
!> square cells, implicit in time.
!>
!>     storage A dp/dt = sum over sides T (p_neighbour - p) + source,      T = k / viscosity for square cells
!>
!> Cells may be left out (`active`): another program has them, and `source` [m2/s] says what comes from there. The outer edge is
!> closed; one cell may hold a well of constant pressure (Peaceman 1978: equivalent radius 0.2 of the cell).
module darcy
  use, intrinsic :: iso_fortran_env, only: real64
  implicit none
  private
  public :: reservoir

  type :: reservoir
    integer :: nx = 0, ny = 0
    real(real64) :: size = 0          !< m, of a cell
    real(real64) :: permeability = 0  !< m2
    real(real64) :: viscosity = 0     !< Pa s
    real(real64) :: storage = 0       !< 1/Pa, porosity times compressibility
    logical, allocatable :: active(:, :)
    real(real64), allocatable :: pressure(:, :)      !< Pa
    integer :: producer(2) = 0        !< cell of the well, 0: none
    real(real64) :: producer_pressure = 0, producer_radius = 0.1_real64
    real(real64) :: produced = 0      !< m2 since the start
    real(real64), private, allocatable :: diagonal(:, :)
  contains
    procedure :: create
    procedure :: transmissibility
    procedure :: try
    procedure :: accept
    procedure :: stored
    procedure, private :: apply
    procedure, private :: well_index
  end type reservoir

contains

  subroutine create(self, nx, ny, size, pressure)
    class(reservoir), intent(inout) :: self
    integer, intent(in) :: nx, ny
    real(real64), intent(in) :: size, pressure
    self%nx = nx
    self%ny = ny
    self%size = size
    allocate (self%active(nx, ny), source=.true.)
    allocate (self%pressure(nx, ny), source=pressure)
    allocate (self%diagonal(nx, ny), source=0.0_real64)
  end subroutine create

  !> Between the middles of two neighbours [m2/(Pa s)].
  pure real(real64) function transmissibility(self)
    class(reservoir), intent(in) :: self
    transmissibility = self%permeability/self%viscosity
  end function transmissibility

  pure real(real64) function well_index(self)
    class(reservoir), intent(in) :: self
    real(real64), parameter :: pi = acos(-1.0_real64)
    well_index = 0
    if (self%producer(1) > 0) &
      well_index = 2*pi*self%transmissibility()/log(0.2_real64*self%size/self%producer_radius)
  end function well_index

  !> Fluid in the active cells beyond what they hold at pressure `from` [m2].
  pure real(real64) function stored(self, from)
    class(reservoir), intent(in) :: self
    real(real64), intent(in) :: from
    stored = self%storage*self%size**2*sum(self%pressure - from, mask=self%active)
  end function stored

  !> Pressure after `dt` [s] with `source` [m2/s] by cell; what the simulator holds stays as it is until `accept`.
  subroutine try(self, dt, source, pressure)
    class(reservoir), intent(inout) :: self
    real(real64), intent(in) :: dt, source(:, :)
    real(real64), intent(out) :: pressure(:, :)
    real(real64) :: right(self%nx, self%ny), residual(self%nx, self%ny), search(self%nx, self%ny), &
      image(self%nx, self%ny), scaled(self%nx, self%ny), step, product, before, target
    integer :: round
    call set_diagonal(self, dt)
    right = self%storage*self%size**2/dt*self%pressure + source
    if (self%producer(1) > 0) right(self%producer(1), self%producer(2)) = &
      right(self%producer(1), self%producer(2)) + self%well_index()*self%producer_pressure
    where (.not. self%active) right = 0
    ! Conjugate gradients, preconditioned by the diagonal (Hestenes and Stiefel 1952).
    pressure = self%pressure
    where (.not. self%active) pressure = 0
    call self%apply(pressure, image)
    residual = right - image
    target = 1e-13_real64*sqrt(sum(right**2))
    scaled = residual/self%diagonal
    search = scaled
    product = sum(residual*scaled)
    do round = 1, 20*(self%nx + self%ny)
      if (sqrt(sum(residual**2)) <= target) return
      call self%apply(search, image)
      step = product/sum(search*image)
      pressure = pressure + step*search
      residual = residual - step*image
      scaled = residual/self%diagonal
      before = product
      product = sum(residual*scaled)
      search = scaled + product/before*search
    end do
  end subroutine try

  !> Takes a pressure that `try` gave for a step of `dt` [s].
  subroutine accept(self, dt, pressure)
    class(reservoir), intent(inout) :: self
    real(real64), intent(in) :: dt, pressure(:, :)
    self%pressure = pressure
    if (self%producer(1) > 0) self%produced = self%produced + &
      dt*self%well_index()*(pressure(self%producer(1), self%producer(2)) - self%producer_pressure)
  end subroutine accept

  subroutine set_diagonal(self, dt)
    type(reservoir), intent(inout) :: self
    real(real64), intent(in) :: dt
    real(real64) :: t
    integer :: i, j
    t = self%transmissibility()
    do j = 1, self%ny
      do i = 1, self%nx
        self%diagonal(i, j) = self%storage*self%size**2/dt
        if (.not. self%active(i, j)) cycle
        if (i > 1) self%diagonal(i, j) = self%diagonal(i, j) + merge(t, 0.0_real64, self%active(i - 1, j))
        if (i < self%nx) self%diagonal(i, j) = self%diagonal(i, j) + merge(t, 0.0_real64, self%active(i + 1, j))
        if (j > 1) self%diagonal(i, j) = self%diagonal(i, j) + merge(t, 0.0_real64, self%active(i, j - 1))
        if (j < self%ny) self%diagonal(i, j) = self%diagonal(i, j) + merge(t, 0.0_real64, self%active(i, j + 1))
      end do
    end do
    if (self%producer(1) > 0) self%diagonal(self%producer(1), self%producer(2)) = &
      self%diagonal(self%producer(1), self%producer(2)) + self%well_index()
  end subroutine set_diagonal

  !> image = matrix times x; cells left out give 0.
  subroutine apply(self, x, image)
    class(reservoir), intent(in) :: self
    real(real64), intent(in) :: x(:, :)
    real(real64), intent(out) :: image(:, :)
    real(real64) :: t
    integer :: i, j
    t = self%transmissibility()
    image = self%diagonal*x
    do j = 1, self%ny
      do i = 1, self%nx
        if (.not. self%active(i, j)) cycle
        if (i > 1) image(i, j) = image(i, j) - merge(t*x(i - 1, j), 0.0_real64, self%active(i - 1, j))
        if (i < self%nx) image(i, j) = image(i, j) - merge(t*x(i + 1, j), 0.0_real64, self%active(i + 1, j))
        if (j > 1) image(i, j) = image(i, j) - merge(t*x(i, j - 1), 0.0_real64, self%active(i, j - 1))
        if (j < self%ny) image(i, j) = image(i, j) - merge(t*x(i, j + 1), 0.0_real64, self%active(i, j + 1))
      end do
    end do
    where (.not. self%active) image = 0
  end subroutine apply

end module darcy
