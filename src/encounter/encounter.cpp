#include "stoss/encounter/encounter.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "check.hpp"
#include "encounter/coat.hpp"
#include "encounter/participant.hpp"
#include "encounter/partners.hpp"
#include "encounter/yielding.hpp"
#include "stoss/encounter/inputs.hpp"
#include "stoss/encounter/roughness.hpp"

namespace stoss {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// In units of the first body with a material, of which rods are the exception: they keep SI.
Values in_units_of_first(const Kind& kind, Values all, const Values& first, double time) {
  for (const Parameter& each : kind.parameters) {
    if (each.unit.empty() || is_of_face(each.name) || each.unit == "kg") continue;  // no part of a solid
    all.find(each.name)->second /= each.unit == "m"   ? first.at("radius")
                                   : each.unit == "s" ? time
                                                      : first.find(each.name)->second;
  }
  return all;
}

bool is_rod(const Encounter& encounter) { return encounter.first.kind == "rod"; }

bool has_second_values(const Encounter& encounter) { return !kind(encounter.against.kind).wall; }

Values first_values(const Encounter& encounter) { return all_values(encounter.first, {}, infinite); }

Values own_units(const Encounter& encounter, const Kind& kind, Values all) {
  if (!encounter.first.material || is_rod(encounter)) return all;
  return in_units_of_first(kind, std::move(all), first_values(encounter), si_scales(encounter)->time);
}

/// A body by its modes in units of the first.
Solid modal_solid(const Encounter& encounter, const Participant& of) {
  const Values units = first_values(encounter);
  (void)all_values(of, {}, infinite);
  return in_units(*of.modal, units.at("radius"), units.at("young"), units.at("density"));
}

/// Whether it meets a wall, no body.
bool is_at_wall(const Encounter& encounter) {
  return kind(encounter.against.kind).wall && encounter.against.kind != "same";
}

/// By itself, an elastic body without modes is a mistake: its maker then refuses the cutoff.
void require_modes(const Solid& solid, double cutoff) {
  if (const auto* its = std::get_if<Disk>(&solid)) (void)disk(its->poisson, cutoff);
  if (const auto* its = std::get_if<Sphere>(&solid)) (void)sphere(its->poisson, cutoff);
}

/// What `compute` gives of a body, which knows its loss time in its own R/c alone: refused there, it is refused here as
/// it was given.
template <typename Compute>
auto with_given_loss_time(const Participant& of, const Compute& compute) {
  try {
    return compute();
  } catch (const InvalidInput& error) {
    const double given = loss_time_of(of);
    if (error.name() != "loss_time" || error.got().empty() || !(given > 0.0) || std::isinf(given)) throw;
    if (layers_differ(of)) throw;
    const double most = 1e5 * given / std::stod(error.got());
    throw InvalidInput::out_of_range(
        "loss_time", shown(given),
        "0 to " + shown_most(most) + " (eta of stress = (1 + eta d/dt) elastic stress; 1e5 R/c of the body)");
  }
}

BodyMaker made(const Encounter& encounter, const Participant& of, const Solid& solid) {
  const bool in_own = encounter.first.material && !is_rod(encounter);
  const Values units = in_own ? first_values(encounter) : Values{{"radius", 1.0}, {"density", 1.0}};
  const double unit = units.at("radius"), unit_of_mass = units.at("density") * std::pow(unit, 3);
  return with_given_loss_time(of, [&] {
    BodyMaker bare = of.rigid ? rigid(maker(solid)) : maker(solid, relaxation_of(encounter, of, solid));
    bare = laden(bare, given_or(of, "extra_mass", 0.0) / unit_of_mass);
    const BodyMaker coated = coated_in_units_of_first(bare, coat_of(encounter, of));
    return yielding_as_given(with_asperities(coated, asperities_of(of) / unit), encounter, of);
  });
}

/// Of layers that differ, each its own.
void set_losses(const Encounter& encounter, Solid& plate) {
  auto& its = std::get<Plate>(plate);
  its.losses = layer_losses(encounter, encounter.against, plate);
  its.loss_time = 0.0;
}

}  // namespace

void validate(const Encounter& encounter) {
  require_partners(encounter);
  (void)asperities_of(encounter);
  (void)first_maker(encounter);
  with_prefix_against([&] { validate(wall_of(encounter)); });
  (void)second_maker(encounter);
  (void)yield_speed(encounter);
}

std::optional<Scales> si_scales(const Encounter& encounter) {
  const Participant& first = encounter.first;
  if (!first.material) return std::nullopt;
  const Values all = first_values(encounter);
  if (first.kind == "disk") {
    Material its = *first.material;
    its.young *= stiffening(first, all.at("radius")).front();
    return scales(its, first.plane, all.at("radius"));
  }
  if (first.modal) return scales(*first.modal);
  return with_given_loss_time(first, [&] {
    if (is_rod(encounter)) return scales(std::get<Rod>(kind("rod").solid(all)));
    const Solid solid = kind(first.kind).solid(all);
    const auto* hollow = std::get_if<HollowSphere>(&solid);
    Scales its = hollow != nullptr ? scales(*hollow) : scales(std::get<Sphere>(solid));
    its.force *= 1.0 + all.at("extra_mass") * inverse_mass_of_solid(first);
    return its;
  });
}

UnitSystem unit_system(const Encounter& encounter) {
  const Kind& first = kind(encounter.first.kind);
  return encounter.first.material ? first.si : first.own;
}

double speed_unit(const Encounter& encounter) {
  const auto si = si_scales(encounter);
  return si ? si->speed : 1.0;
}

double speed_in_c(const Encounter& encounter, double speed) {
  return in_own_units(input(Question::restitution, "speed"), speed, si_scales(encounter), unit_system(encounter));
}

Solid first_solid(const Encounter& encounter) {
  const Kind& its = kind(encounter.first.kind);
  if (its.from_file) return modal_solid(encounter, encounter.first);
  return its.solid(own_units(encounter, its, first_values(encounter)));
}

std::optional<Solid> second_solid(const Encounter& encounter) {
  if (encounter.against.kind == "same") return first_solid(encounter);
  if (!has_second_values(encounter)) return std::nullopt;
  const Values first = first_values(encounter);
  const auto poisson = first.find("poisson");
  const auto its = poisson == first.end() ? std::nullopt : std::optional(poisson->second);
  // A half-plane has no size: that of the first serves to express its modulus.
  const double radius = size_of_first(encounter);
  const Kind& against = kind(encounter.against.kind);
  return with_prefix_against([&] {
    if (against.from_file) return std::optional(modal_solid(encounter, encounter.against));
    Solid made = against.solid(own_units(encounter, against, all_values(encounter.against, its, radius)));
    for (Values& layer : values_below(encounter.against, its, radius)) {
      against.add_layer(made, own_units(encounter, against, std::move(layer)));
    }
    if (layers_differ(encounter.against)) set_losses(encounter, made);
    return std::optional(std::move(made));
  });
}

BodyMaker first_maker(const Encounter& encounter) { return made(encounter, encounter.first, first_solid(encounter)); }

BodyMaker second_maker(const Encounter& encounter) {
  if (encounter.against.kind == "same") return first_maker(encounter);
  const auto second = second_solid(encounter);
  return second ? with_prefix_against([&] { return made(encounter, encounter.against, *second); }) : BodyMaker{};
}

Wall wall_of(const Encounter& encounter) {
  if (!is_at_wall(encounter)) return HardWall{};
  const Values all = all_values(encounter.against, {}, infinite);
  if (encounter.against.kind == "exponential") return ExponentialWall{all.at("hardness"), all.at("strength")};
  const double asperities = asperities_of(encounter.against);
  if (asperities == 0.0) return HardWall{};
  const Values first = first_values(encounter);
  return ExponentialWall{first.at(is_rod(encounter) ? "length" : "radius") / asperities};
}

RefinableContact refinable(const Encounter& encounter) {
  validate(encounter);
  if (!is_at_wall(encounter)) return {first_maker(encounter), second_maker(encounter)};
  BodyMaker maker = first_maker(encounter);
  if (kind(encounter.first.kind).from_file) (void)contact(maker(1e-6, {}));  // refuses a flat one, whatever the cutoff
  return {std::move(maker), wall_of(encounter)};
}

Contact contact_of(const Encounter& encounter, double cutoff, double speed, const Poll& poll) {
  validate(encounter);
  if (!is_at_wall(encounter)) return contact(first_maker(encounter), second_maker(encounter), cutoff, speed, poll);
  Body body = first_maker(encounter)(cutoff, poll);
  if (mode_count(body) == 0 && body.loss_time == 0.0) require_modes(first_solid(encounter), cutoff);
  return contact(std::move(body), wall_of(encounter));
}

}  // namespace stoss
