#include "c/handles.hpp"
#include "c/status.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/version.hpp"

namespace {

using stoss::c::guarded;
using stoss::c::require_given;

/// Hands over the body of the maker that `make` returns.
template <typename Make>
int handed_over(stoss_body** body, const Make& make) noexcept {
  return guarded([&] {
    require_given(body, "body");
    *body = new stoss_body{make()};
  });
}

}  // namespace

extern "C" {

const char* stoss_version(void) { return stoss::version().data(); }

int stoss_disk_make(double poisson, double radius, double young, double density, double loss_time, stoss_body** body) {
  return handed_over(body, [&] { return stoss::disk({poisson, radius, young, density, loss_time}); });
}

int stoss_sphere_make(double poisson, double radius, double young, double density, double loss_time,
                      stoss_body** body) {
  return handed_over(body, [&] { return stoss::sphere({poisson, radius, young, density, loss_time}); });
}

int stoss_rod_make(double length, double young, double density, double area, double loss_time, stoss_body** body) {
  return handed_over(body, [&] { return stoss::rod({length, young, density, area, loss_time}); });
}

int stoss_half_space_make(double poisson, double young, double density, double loss_time, stoss_body** body) {
  return handed_over(body, [&] { return stoss::half_space({poisson, young, density, loss_time}); });
}

int stoss_half_plane_make(double poisson, double young, double density, double loss_time, stoss_body** body) {
  return handed_over(body, [&] { return stoss::half_plane({poisson, young, density, loss_time}); });
}

int stoss_rigid_make(const stoss_body* elastic, stoss_body** body) {
  return handed_over(body, [&] {
    require_given(elastic, "elastic");
    return stoss::rigid(elastic->maker);
  });
}

void stoss_body_free(stoss_body* body) { delete body; }

}  // extern "C"
