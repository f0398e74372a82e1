#pragma once

#include <algorithm>
#include <string>
#include <variant>

#include "stoss/encounter/encounter.hpp"
#include "stoss/poll.hpp"
#include "stoss/quasistatic.hpp"
#include "stoss/quasistatic/quantities.hpp"

/// What `stoss quasistatic` needs of a contact: law, range of speeds, what takes the energy; at a wall also half-width
/// under a force and exact static contact; and how its values are shown. Speeds are in c, lengths in R.
namespace stoss::cli {

/// A disk, which touches the wall along a line.
struct LineContact {
  static constexpr const char* size = "half_width";
  static constexpr double slowest = quasistatic::min_slow_speed;
  static constexpr int width = 12;  // of the half-width

  quasistatic::CompressionLaw law;
  double poisson;
  double last_force = std::min(limit_force(law, poisson), quasistatic::max_hertz_force);
  double fastest = limit_speed(law, poisson);

  [[nodiscard]] static const auto& quantities() { return quasistatic::rayleigh_quantities(); }
  [[nodiscard]] auto modes(double cutoff, const Poll& poll) const { return bodies::disk::modes(poisson, cutoff, poll); }
  [[nodiscard]] static double half_width(double force) { return quasistatic::hertz_half_width(force); }
  [[nodiscard]] quasistatic::StaticContact exact(double compression, const Poll& poll) const {
    return quasistatic::static_contact(poisson, compression, {.poll = poll});
  }
};

/// A sphere, which touches it at a point; its half-width is the radius of the contact.
struct PointContact {
  static constexpr const char* size = "contact_radius";
  static constexpr double slowest = quasistatic::min_point_speed;
  static constexpr int width = 16;

  quasistatic::PointLaw law;
  double poisson;
  double last_force = limit_force(law, poisson);
  double fastest = limit_speed(law, poisson);

  [[nodiscard]] static const auto& quantities() { return quasistatic::point_rayleigh_quantities(); }
  [[nodiscard]] auto modes(double cutoff, const Poll& poll) const {
    return bodies::sphere::modes(poisson, cutoff, poll);
  }
  [[nodiscard]] double half_width(double force) const { return contact_radius(law, poisson, force); }
  [[nodiscard]] quasistatic::StaticContact exact(double compression, const Poll& poll) const {
    constexpr int nodes = 80;  // a row takes 0.1 s, its force is good to 1e-4
    return quasistatic::static_contact(Sphere{.poisson = poisson}, compression,
                                       quasistatic::StaticContactOptions{nodes, poll});
  }
};

/// A sphere on an elastic half-space, which carries energy away as waves.
struct BlockContact {
  static constexpr double slowest = quasistatic::min_point_speed;

  quasistatic::PointLaw law;
  quasistatic::BallOnHalfSpace bodies;
  double poisson = bodies.poisson;
  double fastest = limit_speed(law, bodies);

  [[nodiscard]] static const auto& quantities() { return quasistatic::half_space_radiation_quantities(); }
};

/// @param law a word of --law
/// @throws InvalidInput for a law of other bodies, and for what is met unless it is a wall or, by a sphere, an elastic
/// half-space
[[nodiscard]] std::variant<LineContact, PointContact, BlockContact> slow_contact(const Encounter& encounter,
                                                                                 const std::string& law);

}  // namespace stoss::cli
