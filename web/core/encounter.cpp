#include "encounter.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"
#include "stoss/quasistatic/yield.hpp"
#include "text.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

constexpr std::array<UnitSystem, 3> own_units{UnitSystem::disk, UnitSystem::sphere, UnitSystem::rod};
constexpr std::array<UnitSystem, 3> si_units{UnitSystem::disk_si, UnitSystem::sphere_si, UnitSystem::rod_si};

GivenBody given_body(const val& body) {
  const auto number = [&](const char* name) { return body[name].as<double>(); };
  const val strength = body["yieldStrength"];
  return {number("poisson"),
          number("radius"),
          number("young"),
          number("density"),
          number("area"),
          number("lossTime"),
          strength.isUndefined() ? 0.0 : strength.as<double>()};
}

BodyKind kind_of(const std::string& name) {
  if (name == "sphere") return BodyKind::sphere;
  return name == "rod" ? BodyKind::rod : BodyKind::disk;
}

Material material_of(const GivenBody& body) {
  Material material{body.young, body.poisson, body.density};
  if (body.yield_strength > 0.0) material.yield_strength = body.yield_strength;
  return material;
}

/// What `make` returns; its refusals say that they are of what is met.
template <typename Make>
auto of_what_is_met(Make make) {
  try {
    return make();
  } catch (const InvalidInput& error) {
    throw InvalidInput(std::string("against ") + error.what());
  }
}

}  // namespace

Encounter::Encounter(const val& given)
    : kind_(kind_of(given["kind"].as<std::string>())),
      against_(given["against"]["kind"].as<std::string>()),
      strain_(given["plane"].as<std::string>() == "strain"),
      one_(given_body(given["first"])) {
  const bool in_si = given["si"].as<bool>();
  if (in_si) {
    si_ = scales_of(one_);
  } else {
    // Its size and material are the units.
    one_ = {one_.poisson, 1.0, 1.0, 1.0, 1.0, one_.loss_time, 0.0};
  }
  first_ = make(one_, 0);
  if (against_ == "wall") {
    refinable_.emplace(first_);
    return;
  }
  if (against_ == "same") {
    other_ = one_;
    second_ = first_;
  } else {
    other_ = given_body(given["against"]["body"]);
    second_ = of_what_is_met([&] { return against_half_space() ? make_half_space(other_) : make(other_, 1); });
  }
  refinable_.emplace(first_, second_);
}

std::optional<Scales> Encounter::scales_of(const GivenBody& body) const {
  switch (kind_) {
    case BodyKind::disk:
      return scales(Material{body.young, body.poisson, body.density}, plane(), body.radius);
    case BodyKind::sphere:
      return scales(Sphere{body.poisson, body.radius, body.young, body.density});
    case BodyKind::rod:
      return scales(Rod{body.radius, body.young, body.density, body.area});
  }
  return std::nullopt;
}

double Encounter::poisson(int body) const {
  const GivenBody& of = body == 0 ? one_ : other_;
  if (kind_ != BodyKind::disk || !si_) return of.poisson;
  return plane_poisson(Material{of.young, of.poisson, of.density}, plane());
}

BodyMaker Encounter::make(const GivenBody& body, int number) const {
  if (kind_ == BodyKind::rod) return rod(Rod{body.radius, body.young, body.density, body.area, body.loss_time});
  const double loss_time = si_ ? body.loss_time / si_->time : body.loss_time;
  if (kind_ == BodyKind::sphere) {
    return sphere(Sphere{body.poisson, body.radius / one_.radius, body.young / one_.young, body.density / one_.density,
                         loss_time});
  }
  Disk made{body.poisson, body.radius, body.young, body.density, loss_time};
  if (si_) {
    const Scales own = scales(Material{body.young, body.poisson, body.density}, plane(), body.radius);
    const auto modulus = [](const Scales& of) { return of.force / of.length; };
    made.poisson = plane_poisson(Material{body.young, body.poisson, body.density}, plane());
    made.radius = number == 0 ? 1.0 : own.length / si_->length;
    made.young = number == 0 ? 1.0 : modulus(own) / modulus(*si_);
    made.density = body.density / one_.density;
  }
  return disk(made);
}

BodyMaker Encounter::make_half_space(const GivenBody& body) const {
  if (kind_ == BodyKind::rod) {
    throw InvalidInput("against: got half-space with a rod, allowed wall, same or another rod");
  }
  const double loss_time = si_ ? body.loss_time / si_->time : body.loss_time;
  if (kind_ == BodyKind::sphere) {
    return half_space({body.poisson, body.young / one_.young, body.density / one_.density, loss_time});
  }
  if (!si_) return half_plane({body.poisson, body.young, body.density, loss_time});
  const Material material{body.young, body.poisson, body.density};
  const Scales own = scales(material, plane(), si_->length);
  const auto modulus = [](const Scales& of) { return of.force / of.length; };
  return half_plane(
      {plane_poisson(material, plane()), modulus(own) / modulus(*si_), body.density / one_.density, loss_time});
}

Contact Encounter::contact(double cutoff, double speed) const {
  if (second_) return stoss::contact(first_, second_, cutoff, speed);
  return stoss::contact(first_(cutoff, {}));
}

double Encounter::own_speed(double speed) const {
  constexpr double slowest = 1e-8, fastest = 1.0;
  const double scale = unit(Dimension::speed);
  if (!(speed >= slowest * scale && speed <= fastest * scale)) {
    throw InvalidInput("speed: got " + text(speed) + ", allowed " + text(slowest * scale) + " to " +
                       text(fastest * scale) + " " + unit_name(Dimension::speed) + " (of approach)");
  }
  // The division may round beyond an end.
  return std::clamp(speed / scale, slowest, fastest);
}

std::optional<double> Encounter::yield_speed() const {
  if (!si_ || kind_ != BodyKind::sphere) return std::nullopt;
  if (against_ == "wall") return quasistatic::yield_speed(material_of(one_), one_.radius);
  const double radius = against_half_space() ? std::numeric_limits<double>::infinity() : other_.radius;
  return quasistatic::yield_speed(material_of(one_), one_.radius, material_of(other_), radius);
}

double Encounter::unit(Dimension dimension) const { return si_ ? unit_in_si(dimension, *si_) : 1.0; }

std::string Encounter::unit_name(Dimension dimension) const {
  return std::string(stoss::unit_name(dimension, (si_ ? si_units : own_units).at(static_cast<std::size_t>(kind_))));
}

std::string Encounter::own_unit_name(Dimension dimension) const {
  return std::string(stoss::unit_name(dimension, own_units.at(static_cast<std::size_t>(kind_))));
}

}  // namespace stoss::web
