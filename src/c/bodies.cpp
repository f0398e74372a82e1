#include "c/interface.hpp"
#include "stoss/encounter/roughness.hpp"
#include "stoss/errors.hpp"

#include "stoss/version.hpp"

namespace {

using stoss::c::guarded;
using stoss::c::require_given;

/// Hands over what `make` makes.
template <typename Make>
int handed_over(stoss_body** body, const Make& make) {
  return guarded([&] {
    require_given(body, "body");
    *body = new stoss_body(make());
  });
}

}  // namespace

extern "C" {

const char* stoss_version() { return stoss::version().data(); }

int stoss_disk_make(double poisson, double radius, double young, double density, double loss_time, stoss_body** body) {
  return handed_over(body, [&] {
    const stoss::Disk value{poisson, radius, young, density, loss_time};
    return stoss_body{value, false, stoss::disk(value)};
  });
}

int stoss_sphere_make(double poisson, double radius, double young, double density, double loss_time,
                      stoss_body** body) {
  return handed_over(body, [&] {
    const stoss::Sphere value{poisson, radius, young, density, loss_time};
    return stoss_body{value, false, stoss::sphere(value)};
  });
}

int stoss_hollow_sphere_make(double poisson, double inner, double radius, double young, double density,
                             double loss_time, stoss_body** body) {
  return handed_over(body, [&] {
    const stoss::HollowSphere value{poisson, inner, radius, young, density, loss_time};
    return stoss_body{value, false, stoss::hollow_sphere(value)};
  });
}

int stoss_rod_make(double length, double young, double density, double area, double loss_time, stoss_body** body) {
  return handed_over(body, [&] {
    const stoss::Rod value{length, young, density, area, loss_time};
    return stoss_body{value, false, stoss::rod(value)};
  });
}

int stoss_half_space_make(double poisson, double young, double density, double loss_time, stoss_body** body) {
  return handed_over(body, [&] {
    const stoss::HalfSpace value{poisson, young, density, loss_time};
    return stoss_body{value, false, stoss::half_space(value)};
  });
}

int stoss_half_plane_make(double poisson, double young, double density, double loss_time, stoss_body** body) {
  return handed_over(body, [&] {
    const stoss::HalfPlane value{poisson, young, density, loss_time};
    return stoss_body{value, false, stoss::half_plane(value)};
  });
}

int stoss_plate_make(double thickness, double poisson, double young, double density, double loss_time,
                     stoss_body** body) {
  return handed_over(body, [&] {
    const stoss::Plate value{thickness, poisson, young, density, loss_time};
    return stoss_body{value, false, stoss::plate(value)};
  });
}

int stoss_strip_make(double thickness, double poisson, double young, double density, double loss_time,
                     stoss_body** body) {
  return handed_over(body, [&] {
    const stoss::Strip value{thickness, poisson, young, density, loss_time};
    return stoss_body{value, false, stoss::strip(value)};
  });
}

int stoss_relaxing_make(const stoss_body* elastic, const double* shares, const double* times, size_t count,
                        stoss_body** body) {
  return handed_over(body, [&] {
    require_given(elastic, "elastic");
    if (count > 0) require_given(shares, "shares"), require_given(times, "times");
    stoss::Relaxation relaxation;
    for (size_t i = 0; i < count; ++i) relaxation.terms.push_back({shares[i], times[i]});
    const double loss_time = std::visit([](const auto& its) { return its.loss_time; }, elastic->value);
    if (elastic->rigid || !elastic->relaxation.terms.empty() || elastic->rough || loss_time != 0.0) {
      throw stoss::InvalidInput::conflict("elastic", "it is rigid or rough, has a loss_time or relaxes already");
    }
    return stoss_body{elastic->value, false, stoss::maker(elastic->value, relaxation), relaxation};
  });
}

int stoss_rough_make(const stoss_body* smooth, double u0, stoss_body** body) {
  return handed_over(body, [&] {
    require_given(smooth, "smooth");
    if (smooth->rough) throw stoss::InvalidInput::conflict("smooth", "it is rough already");
    stoss_body made = *smooth;
    made.maker = stoss::with_asperities(smooth->maker, u0);
    made.rough = u0 > 0.0;
    return made;
  });
}

int stoss_rigid_make(const stoss_body* elastic, stoss_body** body) {
  return handed_over(body, [&] {
    require_given(elastic, "elastic");
    return stoss_body{elastic->value, true, stoss::rigid(elastic->maker), {}, elastic->rough};
  });
}

void stoss_body_free(stoss_body* body) { delete body; }

}  // extern "C"
