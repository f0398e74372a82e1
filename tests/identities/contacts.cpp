// What the lines of the table of the identity suite are: their contacts, and the same seen otherwise.
#include <cmath>
#include <utility>

#include "identities/cases.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/plate.hpp"

namespace stoss::test {
namespace {

void resize_round(Solid& solid, double length, double modulus, double density) {
  const auto resize = [=](auto& round) {
    round.radius *= length;
    round.young *= modulus;
    round.density *= density;
  };
  if (auto* ball = std::get_if<Sphere>(&solid)) return resize(*ball);
  if (auto* ball = std::get_if<HollowSphere>(&solid)) return resize(*ball);
  resize(std::get<Disk>(solid));
}

Plate plate_of(const Case& its, const Sphere& like) {
  Plate plate{its.thickness, like.poisson, like.young, like.density, like.loss_time};
  if (its.layers.empty()) return plate;
  plate.thickness /= static_cast<double>(its.layers.size());
  plate.below.assign(its.layers.size() - 1, {plate.thickness, like.poisson, like.young, like.density});
  for (const MaterialLoss& each : its.layers) plate.losses.push_back(in_time(each, size(like) / wave_speed(like)));
  return plate;
}

/// A half-space, a half-plane, a plate or a strip.
BodyMaker unbounded_of(const Case& its) {
  if (const auto* ball = std::get_if<Sphere>(&*its.second)) {
    if (its.thickness > 0.0) return plate(plate_of(its, *ball));
    return half_space(HalfSpace{ball->poisson, ball->young, ball->density, ball->loss_time});
  }
  const Disk& round = std::get<Disk>(*its.second);
  if (its.thickness > 0.0)
    return strip(Strip{its.thickness, round.poisson, round.young, round.density, round.loss_time});
  return half_plane(HalfPlane{round.poisson, round.young, round.density, round.loss_time});
}

double inverse_time(const Solid& solid) { return wave_speed(solid) / size(solid); }

BodyMaker maker(const Solid& solid) {
  if (const auto* slender = std::get_if<Rod>(&solid)) return rod(*slender);
  if (const auto* ball = std::get_if<Sphere>(&solid)) return sphere(*ball);
  if (const auto* ball = std::get_if<HollowSphere>(&solid)) return hollow_sphere(*ball);
  return disk(std::get<Disk>(solid));
}

}  // namespace

Contact contact_of(const Case& its) {
  const BodyMaker first = rough(relaxing(maker(its.first), its.relaxation), its.asperities);
  if (its.soft) return contact(first(its.cutoff, {}), ExponentialWall{500.0, 1.0});
  if (its.half_space) return contact(first, relaxing(unbounded_of(its), its.second_relaxation), its.cutoff, its.speed);
  if (its.second) return contact(first, relaxing(maker(*its.second), its.second_relaxation), its.cutoff);
  return contact(first(its.cutoff, {}));
}

Case swapped(const Case& its) {
  Case other = its;
  other.first = *its.second;
  other.second = its.first;
  std::swap(other.relaxation, other.second_relaxation);
  other.speed *= wave_speed(its.first) / wave_speed(other.first);
  other.cutoff *= inverse_time(its.first) / inverse_time(other.first);
  return other;
}

Case in_units(const Case& its, double length, double modulus, double density) {
  const double time = length * std::sqrt(density / modulus);
  const auto measured = [&](Solid solid) {
    std::visit([time](auto& body) { body.loss_time *= time; }, solid);
    if (auto* slender = std::get_if<Rod>(&solid)) {
      slender->length *= length;
      slender->area *= length * length;
      slender->young *= modulus;
      slender->density *= density;
    } else {
      resize_round(solid, length, modulus, density);
    }
    return solid;
  };
  Case other = its;
  other.first = measured(its.first);
  if (its.second) other.second = measured(*its.second);
  if (its.half_space) other.second_relaxation = in_time(its.second_relaxation, length);  // in 1/c
  other.thickness *= length;
  return other;
}

}  // namespace stoss::test
