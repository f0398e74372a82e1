! A user's program in Fortran: the disk of docs/reference/c.md, a function of the speed, a refusal and a poll.
program main
  use, intrinsic :: iso_c_binding
  use stoss
  implicit none

  integer, target :: calls = 0
  type(c_ptr) :: disk, contact, handle
  type(stoss_control) :: control
  type(stoss_result) :: results(2)
  type(stoss_obliquity) :: obliquities(1)
  type(stoss_oblique_result) :: rules(1)
  real(c_double) :: speeds(2) = [0.1_c_double, 0.05_c_double], values(2), errors(2), slowest, fastest, greatest

  call require(stoss_disk_make(0.33_c_double, 1.0_c_double, 1.0_c_double, 1.0_c_double, 0.0_c_double, disk) == stoss_ok, 1)
  call require(stoss_wall_contact_make(disk, contact) == stoss_ok, 2)
  call stoss_body_free(disk)
  call require(stoss_hollow_sphere_make(0.3_c_double, 0.9_c_double, 1.0_c_double, 1.0_c_double, 1.0_c_double, &
    0.0_c_double, disk) == stoss_ok, 1)
  call stoss_body_free(disk)
  call require(stoss_curve(contact, speeds, 2_c_size_t, stoss_tolerance, stoss_absolute, control, results) == stoss_ok, 3)
  print '(f7.5, a, f7.5)', results(1)%restitution%value, ' +- ', results(1)%restitution%error
  call require(all(results%converged == 1) .and. all(results%speed == speeds), 4)
  call require(abs(results(1)%restitution%value - 0.94704_c_double) < 5e-5_c_double, 5)

  call require(stoss_function_make(contact, 0.02_c_double, 0.2_c_double, 1e-3_c_double, stoss_beyond_error, control, &
    handle) == stoss_ok, 6)
  call require(stoss_function_evaluate(handle, speeds, 2_c_size_t, values, errors) == stoss_ok, 7)
  call require(all(abs(values - results%restitution%value) <= errors + results%restitution%error), 8)
  call require(stoss_function_range(handle, slowest, fastest, greatest) == stoss_ok, 9)
  call require(slowest == 0.02_c_double .and. fastest == 0.2_c_double .and. all(errors <= greatest), 10)
  speeds(1) = 0.5_c_double
  call require(stoss_function_evaluate(handle, speeds, 2_c_size_t, values, errors) == stoss_invalid_input, 11)
  call require(index(stoss_message(), 'speed: got 0.5, allowed 0.02 to 0.2') == 1, 12)
  call stoss_function_free(handle)

  control = stoss_control(threads=1, poll=c_funloc(stop_at_once), context=c_loc(calls))
  call require(stoss_function_make(contact, 0.02_c_double, 0.2_c_double, 1e-5_c_double, stoss_beyond_clamp, control, &
    handle) == stoss_interrupted, 13)
  call require(calls == 1, 14)
  call stoss_contact_free(contact)

  call require(stoss_open('{"first": {"kind": "sphere", "poisson": 0.3}}'//c_null_char, contact) == stoss_ok, 15)
  call require(stoss_collision(contact, '{"speed": 0.01, "tangential": 0.03, "friction": 0.1}'//c_null_char, &
    obliquities(1)) == stoss_ok, 15)
  control = stoss_control()
  call require(stoss_oblique(contact, obliquities, 1_c_size_t, stoss_oblique_tolerance, control, rules) == stoss_ok, 16)
  call require(rules(1)%converged == 1 .and. abs(rules(1)%sliding_after%value - 0.023_c_double) < 5e-5_c_double, 17)
  call stoss_contact_free(contact)
  print '(a)', 'stoss in Fortran'

contains

  subroutine require(condition, number)
    logical, intent(in) :: condition
    integer, intent(in) :: number
    if (condition) return
    print '(a, i0, 2a)', 'failed: ', number, ' ', stoss_message()
    stop 1
  end subroutine require

  integer(c_int) function stop_at_once(context) bind(c)
    type(c_ptr), value :: context
    integer, pointer :: seen
    call c_f_pointer(context, seen)
    seen = seen + 1
    stop_at_once = 1
  end function stop_at_once
end program main
