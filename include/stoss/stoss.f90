! The C interface of stoss for Fortran 2003 (stoss.h describes it). Compile this file with your own.
module stoss
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_f_pointer, c_funptr, c_int, c_null_funptr, c_null_ptr, &
    c_ptr, c_size_t
  implicit none

  integer(c_int), parameter :: stoss_ok = 0, stoss_invalid_input = 1, stoss_not_converged = 2, &
    stoss_out_of_memory = 3, stoss_interrupted = 4, stoss_failed = 5
  integer(c_int), parameter :: stoss_beyond_error = 0, stoss_beyond_clamp = 1, stoss_beyond_law = 2
  real(c_double), parameter :: stoss_tolerance = 1e-3_c_double, stoss_absolute = 1e-6_c_double, &
    stoss_oblique_tolerance = 1e-2_c_double

  ! Handles are of type(c_ptr).
  type, bind(c) :: stoss_control
    integer(c_int) :: threads = 0
    type(c_funptr) :: poll = c_null_funptr  ! integer(c_int) function poll(context) bind(c), with a type(c_ptr), value
    type(c_ptr) :: context = c_null_ptr
  end type stoss_control

  type, bind(c) :: stoss_estimate
    real(c_double) :: value, error
  end type stoss_estimate

  type, bind(c) :: stoss_result
    real(c_double) :: speed
    type(stoss_estimate) :: restitution, lost_fraction, contact_time, max_force, max_compression
    integer(c_int) :: converged
  end type stoss_result

  type, bind(c) :: stoss_obliquity
    real(c_double) :: speed, tangential = 0, spin = 0, second_spin = 0, friction = 0
  end type stoss_obliquity

  type, bind(c) :: stoss_oblique_result
    type(stoss_obliquity) :: before
    real(c_double) :: sliding
    type(stoss_estimate) :: restitution, tangential_restitution, sliding_after, tangential_after, spin_after, &
      second_spin_after, friction_loss, vibration
    real(c_double) :: dundurs, coupling_restitution, coupling_tangential_restitution, coupling_sliding_after
    integer(c_int) :: converged
  end type stoss_oblique_result

  interface
    integer(c_int) function stoss_disk_make(poisson, radius, young, density, loss_time, body) bind(c)
      import
      real(c_double), value :: poisson, radius, young, density, loss_time
      type(c_ptr), intent(out) :: body
    end function stoss_disk_make

    integer(c_int) function stoss_sphere_make(poisson, radius, young, density, loss_time, body) bind(c)
      import
      real(c_double), value :: poisson, radius, young, density, loss_time
      type(c_ptr), intent(out) :: body
    end function stoss_sphere_make

    integer(c_int) function stoss_hollow_sphere_make(poisson, inner, radius, young, density, loss_time, body) bind(c)
      import
      real(c_double), value :: poisson, inner, radius, young, density, loss_time
      type(c_ptr), intent(out) :: body
    end function stoss_hollow_sphere_make

    integer(c_int) function stoss_rod_make(length, young, density, area, loss_time, body) bind(c)
      import
      real(c_double), value :: length, young, density, area, loss_time
      type(c_ptr), intent(out) :: body
    end function stoss_rod_make

    integer(c_int) function stoss_half_space_make(poisson, young, density, loss_time, body) bind(c)
      import
      real(c_double), value :: poisson, young, density, loss_time
      type(c_ptr), intent(out) :: body
    end function stoss_half_space_make

    integer(c_int) function stoss_half_plane_make(poisson, young, density, loss_time, body) bind(c)
      import
      real(c_double), value :: poisson, young, density, loss_time
      type(c_ptr), intent(out) :: body
    end function stoss_half_plane_make

    integer(c_int) function stoss_plate_make(thickness, poisson, young, density, loss_time, body) bind(c)
      import
      real(c_double), value :: thickness, poisson, young, density, loss_time
      type(c_ptr), intent(out) :: body
    end function stoss_plate_make

    integer(c_int) function stoss_strip_make(thickness, poisson, young, density, loss_time, body) bind(c)
      import
      real(c_double), value :: thickness, poisson, young, density, loss_time
      type(c_ptr), intent(out) :: body
    end function stoss_strip_make

    integer(c_int) function stoss_relaxing_make(elastic, shares, times, count, body) bind(c)
      import
      type(c_ptr), value :: elastic
      real(c_double), intent(in) :: shares(*), times(*)
      integer(c_size_t), value :: count
      type(c_ptr), intent(out) :: body
    end function stoss_relaxing_make

    integer(c_int) function stoss_rough_make(smooth, u0, body) bind(c)
      import
      type(c_ptr), value :: smooth
      real(c_double), value :: u0
      type(c_ptr), intent(out) :: body
    end function stoss_rough_make

    integer(c_int) function stoss_rigid_make(elastic, body) bind(c)
      import
      type(c_ptr), value :: elastic
      type(c_ptr), intent(out) :: body
    end function stoss_rigid_make

    subroutine stoss_body_free(body) bind(c)
      import
      type(c_ptr), value :: body
    end subroutine stoss_body_free

    integer(c_int) function stoss_wall_contact_make(body, contact) bind(c)
      import
      type(c_ptr), value :: body
      type(c_ptr), intent(out) :: contact
    end function stoss_wall_contact_make

    integer(c_int) function stoss_pair_contact_make(first, second, contact) bind(c)
      import
      type(c_ptr), value :: first, second
      type(c_ptr), intent(out) :: contact
    end function stoss_pair_contact_make

    ! The document ends with c_null_char.
    integer(c_int) function stoss_open(json, contact) bind(c)
      import
      character(kind=c_char), intent(in) :: json(*)
      type(c_ptr), intent(out) :: contact
    end function stoss_open

    real(c_double) function stoss_speed_unit(contact) bind(c)
      import
      type(c_ptr), value :: contact
    end function stoss_speed_unit

    subroutine stoss_contact_free(contact) bind(c)
      import
      type(c_ptr), value :: contact
    end subroutine stoss_contact_free

    integer(c_int) function stoss_curve(contact, speeds, count, tolerance, absolute, control, results) bind(c)
      import
      type(c_ptr), value :: contact
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: speeds(count)
      real(c_double), value :: tolerance, absolute
      type(stoss_control), intent(in) :: control
      type(stoss_result), intent(inout) :: results(count)
    end function stoss_curve

    integer(c_int) function stoss_collision(contact, json, obliquity) bind(c)
      import
      type(c_ptr), value :: contact
      character(kind=c_char), intent(in) :: json(*)
      type(stoss_obliquity), intent(out) :: obliquity
    end function stoss_collision

    integer(c_int) function stoss_oblique(contact, obliquities, count, tolerance, control, results) bind(c)
      import
      type(c_ptr), value :: contact
      integer(c_size_t), value :: count
      type(stoss_obliquity), intent(in) :: obliquities(count)
      real(c_double), value :: tolerance
      type(stoss_control), intent(in) :: control
      type(stoss_oblique_result), intent(inout) :: results(count)
    end function stoss_oblique

    integer(c_int) function stoss_row(json, speeds, count, tolerance, control, velocities) bind(c)
      import
      character(c_char), intent(in) :: json(*)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: speeds(count)
      real(c_double), value :: tolerance
      type(stoss_control), intent(in) :: control
      type(stoss_estimate), intent(inout) :: velocities(count)
    end function stoss_row

    integer(c_int) function stoss_function_make(contact, slowest, fastest, error, beyond, control, handle) bind(c)
      import
      type(c_ptr), value :: contact
      real(c_double), value :: slowest, fastest, error
      integer(c_int), value :: beyond
      type(stoss_control), intent(in) :: control
      type(c_ptr), intent(out) :: handle
    end function stoss_function_make

    integer(c_int) function stoss_function_evaluate(handle, speeds, count, values, errors) bind(c)
      import
      type(c_ptr), value :: handle
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: speeds(count)
      real(c_double), intent(out) :: values(count), errors(count)
    end function stoss_function_evaluate

    integer(c_int) function stoss_function_range(handle, slowest, fastest, greatest_error) bind(c)
      import
      type(c_ptr), value :: handle
      real(c_double), intent(out) :: slowest, fastest, greatest_error
    end function stoss_function_range

    subroutine stoss_function_free(handle) bind(c)
      import
      type(c_ptr), value :: handle
    end subroutine stoss_function_free
  end interface

contains

  ! Why the last function that failed in this thread did.
  function stoss_message() result(line)
    character(:), allocatable :: line
    character(kind=c_char), pointer :: text(:)
    type(c_ptr) :: start
    integer :: i
    interface
      type(c_ptr) function message_of_c() bind(c, name='stoss_message')
        import
      end function message_of_c

      integer(c_size_t) function length_of_c(text) bind(c, name='strlen')
        import
        type(c_ptr), value :: text
      end function length_of_c
    end interface
    start = message_of_c()
    call c_f_pointer(start, text, [length_of_c(start)])
    allocate (character(size(text)) :: line)
    do i = 1, size(text)
      line(i:i) = text(i)
    end do
  end function stoss_message
end module stoss
