#include "encounter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <utility>
#include <vector>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/errors.hpp"
#include "stoss/quasistatic/yield.hpp"
#include "yield.hpp"

namespace stoss::cli {
namespace {

/// What `make` returns; its refusals say that they are of what is met.
template <typename Make>
auto of_what_is_met(Make make) {
  try {
    return make();
  } catch (const InvalidInput& error) {
    throw InvalidInput(std::string("against ") + error.what());
  }
}

/// Where the half-space has its surface for such bodies; "" for rods.
std::string unbounded_partner(BodyKind kind) {
  if (kind == BodyKind::rod) return {};
  return kind == BodyKind::sphere ? "half-space" : "half-plane";
}

void require_partner(BodyKind kind, const Against& against) {
  const std::string unbounded = unbounded_partner(kind);
  if (!against.is_body() || against.kind == "same" || against.kind == name(kind) || against.kind == unbounded) return;
  const std::string own(name(kind));
  throw InvalidInput(
      fmt::format("against: got {} with --body {}, allowed wall, same{} (a disk meets disks and half-planes, a sphere "
                  "spheres and half-spaces, a rod rods)",
                  against.kind, own, unbounded.empty() ? " or " + own : ", " + own + " or " + unbounded));
}

void require_elastic(const FirstBody& first, const Against& against) {
  if (!first.rigid) return;
  if (!against.is_body() || against.kind == "same") {
    throw InvalidInput(
        fmt::format("rigid-body: got --rigid-body with --against {}, allowed only with {} or {}, which "
                    "deform",
                    against.kind, name(first.kind), unbounded_partner(first.kind)));
  }
  if (first.sphere && first.sphere->material.yield_strength) {
    throw InvalidInput("yield: got --yield with --rigid-body, allowed only without (the second may have yield=)");
  }
  if (first.loss_time != 0.0) {
    throw InvalidInput(
        "loss-time: got --loss-time with --rigid-body, allowed only without (a rigid body loses nothing)");
  }
}

void require_si_keys(const Against& against) {
  const std::vector<std::string> round{"young", "density", "radius"}, rod{"young", "density", "length", "area"};
  const std::vector<std::string> unbounded{"young", "density"};
  const auto& keys = against.is_unbounded() ? unbounded : against.kind == "rod" ? rod : round;
  for (const std::string& key : keys) {
    if (against.values.contains(key)) continue;
    throw InvalidInput(fmt::format("against: got {} without {}, allowed all of {}, in SI as the first", against.kind,
                                   key, fmt::join(keys, ", ")));
  }
}

std::optional<Scales> si_scales(const FirstBody& first) {
  if (first.kind == BodyKind::disk) return first.disk.si();
  if (first.sphere) return scales(first.sphere->sphere());
  return first.rod ? std::optional(scales(*first.rod)) : std::nullopt;
}

}  // namespace

Encounter::Encounter(FirstBody first, Against against)
    : first_(std::move(first)), si_(si_scales(first_)), against_(std::move(against)) {
  require_partner(first_.kind, against_);
  require_elastic(first_, against_);
  if (si_ && second_is_given()) require_si_keys(against_);
  if (!si_ && against_.values.contains("yield")) {
    throw InvalidInput("against: got yield without a material, allowed only with --young, --density, --radius");
  }
  yield_speed_ = find_yield_speed();
}

bool Encounter::second_is_given() const { return against_.is_body() && against_.kind != "same"; }

double Encounter::poisson() const {
  if (first_.kind == BodyKind::disk) return first_.disk.plane_poisson();
  return rods() ? 0.0 : first_.disk.poisson;
}

double Encounter::own_loss_time(double loss_time) const { return si_ ? loss_time / si_->time : loss_time; }

Disk Encounter::first_disk(double poisson) const {
  return {.poisson = poisson, .loss_time = own_loss_time(first_.loss_time)};
}

Sphere Encounter::first_sphere(double poisson) const {
  return {.poisson = poisson, .loss_time = own_loss_time(first_.loss_time)};
}

Rod Encounter::first_rod() const {
  Rod its = first_.rod.value_or(Rod{});
  its.loss_time = first_.loss_time;
  return its;
}

BodyMaker Encounter::make_first(double poisson) const {
  if (rods()) return rod(first_rod());
  const BodyMaker elastic =
      first_.kind == BodyKind::disk ? stoss::disk(first_disk(poisson)) : stoss::sphere(first_sphere(poisson));
  return first_.rigid ? rigid(elastic) : elastic;
}

Rod Encounter::second_rod() const {
  return {against_.value("length", 1.0), against_.value("young", 1.0), against_.value("density", 1.0),
          against_.value("area", 1.0), against_.value("loss_time", 0.0)};
}

Material Encounter::second_material() const {
  const auto& given = against_.values;
  const auto yield = given.find("yield");
  return {given.at("young"), against_.value("poisson", first_.disk.poisson), given.at("density"),
          yield == given.end() ? std::nullopt : std::optional(yield->second)};
}

Disk Encounter::second_disk(double poisson) const {
  if (!si_) {
    return {against_.value("poisson", poisson), against_.value("radius", 1.0), against_.value("young", 1.0),
            against_.value("density", 1.0), against_.value("loss_time", 0.0)};
  }
  const Plane plane = first_.disk.chosen_plane();
  const Scales other = scales(second_material(), plane, against_.value("radius", si_->length));
  const auto modulus = [](const Scales& of) { return of.force / of.length; };
  return {stoss::plane_poisson(second_material(), plane), other.length / si_->length, modulus(other) / modulus(*si_),
          against_.values.at("density") / *first_.disk.density, own_loss_time(against_.value("loss_time", 0.0))};
}

Sphere Encounter::second_sphere(double poisson) const {
  const Sphere one = first_.sphere ? first_.sphere->sphere() : Sphere{};
  return {against_.value("poisson", poisson), against_.value("radius", 1.0) / one.radius,
          against_.value("young", 1.0) / one.young, against_.value("density", 1.0) / one.density,
          own_loss_time(against_.value("loss_time", 0.0))};
}

BodyMaker Encounter::make_second(double poisson) const {
  if (against_.kind == "same") return make_first(poisson);
  return of_what_is_met([&]() -> BodyMaker {
    if (rods()) return rod(second_rod());
    if (first_.kind == BodyKind::disk) {
      const Disk disk = second_disk(poisson);
      return against_.is_unbounded() ? half_plane({disk.poisson, disk.young, disk.density, disk.loss_time})
                                     : stoss::disk(disk);
    }
    const Sphere sphere = second_sphere(poisson);
    return against_.is_unbounded() ? half_space({sphere.poisson, sphere.young, sphere.density, sphere.loss_time})
                                   : stoss::sphere(sphere);
  });
}

RefinableContact Encounter::refinable(double poisson) const {
  if (!against_.is_body()) return RefinableContact(make_first(poisson));
  return {make_first(poisson), make_second(poisson)};
}

Mixture Encounter::mixture(double poisson) const {
  if (rods() || first_.rigid || !against_.is_body() || against_.is_unbounded()) {
    throw InvalidInput("ratio: got --ratio with " + std::string(rods() ? "rods" : "--against " + against_.kind) +
                       (first_.rigid ? " and --rigid-body" : "") +
                       ", allowed with elastic disks or spheres that meet " +
                       "bodies of their kind (--against same, disk,… or sphere,…)");
  }
  const bool same = against_.kind == "same";
  if (first_.kind == BodyKind::disk) {
    const Disk one = first_disk(poisson);
    return same ? stoss::mixture(one) : stoss::mixture(one, second_disk(poisson));
  }
  const Sphere one = first_sphere(poisson);
  return same ? stoss::mixture(one) : stoss::mixture(one, second_sphere(poisson));
}

Contact Encounter::contact(double poisson, double cutoff, double speed) const {
  if (against_.is_body()) return stoss::contact(make_first(poisson), make_second(poisson), cutoff, speed);
  const ExponentialWall soft{against_.value("hardness", default_hardness), against_.value("strength", 1.0)};
  const Wall wall = against_.kind == "wall" ? Wall(HardWall{}) : Wall(soft);
  of_what_is_met([&] { validate(wall); });
  if (lossy()) return stoss::contact(make_first(poisson)(cutoff, {}), wall);
  // By itself a body without modes is refused.
  if (first_.kind == BodyKind::disk) return stoss::contact(stoss::disk(poisson, cutoff), wall);
  return stoss::contact(rods() ? rod(first_rod(), cutoff) : stoss::sphere(poisson, cutoff), wall);
}

std::optional<double> Encounter::find_yield_speed() const {
  if (!first_.sphere) return std::nullopt;
  const auto& [material, radius] = *first_.sphere;
  if (!against_.is_body()) return quasistatic::yield_speed(material, radius);
  if (against_.kind == "same") return quasistatic::yield_speed(material, radius, material, radius);
  (void)quasistatic::yield_speed(material, radius);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Material met = material;
  if (first_.rigid) met.young = infinity;
  return of_what_is_met([&] {
    return quasistatic::yield_speed(met, first_.sphere->radius, second_material(), against_.value("radius", infinity));
  });
}

void Encounter::add_yield(Record& record, double speed) const {
  if (yield_speed_) cli::add_yield(record, units(), *yield_speed_, speed);
}

}  // namespace stoss::cli
