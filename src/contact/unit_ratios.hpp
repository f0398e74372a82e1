#pragma once

#include <cstddef>
#include <string>

#include "stoss/contact/contact.hpp"

namespace stoss {

/// The own units of one body in those of another: multiply by them.
struct UnitRatios {
  double length = 1.0;
  double time = 1.0;  ///< R/c
  double mass = 1.0;
  double compliance = 1.0;  ///< displacement per force, time²/mass
  double softness = 1.0;    ///< 1/E: compliance along a line, compliance times length at a point of contact
  double force = 1.0;
  double stress = 1.0;         ///< force per area; of a disk, whose forces are per thickness, per length
  double second_moment = 1.0;  ///< time⁴/mass
  double impedance = 1.0;      ///< force per velocity, mass/time

  /// Those of a body that is both.
  UnitRatios() = default;

  UnitRatios(const Body& body, const Body& other)
      : length(body.scale.length / other.scale.length),
        time(length / (body.scale.speed / other.scale.speed)),
        mass(body.scale.mass / other.scale.mass * (other.mass / body.mass)),
        compliance(time * time / mass),
        softness(body.contour == Contour::ball ? compliance * length : compliance),
        force(mass * length / (time * time)),
        stress(force / (body.contour == Contour::ball ? length * length : length)),
        second_moment(compliance * time * time),
        impedance(mass / time) {}
};

/// The own units of a body of a contact in those of the first. @param number 0: of the first, 1: of the second
[[nodiscard]] UnitRatios units_of(const Contact& contact, int number);

/// The name of a body without its numbers, which are in units that nobody may have given.
[[nodiscard]] std::string short_name(const Body& body);

/// Contact points as a body sees them: for the smaller of the two the circle is its own edge, exactly.
/// @param units those of the body in those of the first
[[nodiscard]] ContactPoints seen_by(const ContactPoints& points, const UnitRatios& units);

/// Number of rows of Surface::shape that the modes of a body use.
[[nodiscard]] std::size_t shape_rows(const Body& body);

/// Checks that two bodies can meet, at whatever cutoff each is made. @throws InvalidInput for contours that do not go
/// together, and for ratios of length, speed and mass beyond what is computed
void require_ratios(const Body& first, const Body& second);

/// The same, and that both have one cutoff.
void require_partners(const Body& first, const Body& second);

/// Refuses two bodies of which the larger or slower one has more modes than are computed.
/// @param share of their ratio of R/c that is allowed, below 1
/// @param what  is asked for: empty, or "with friction "
[[noreturn]] void refuse_unequal(const Body& first, const Body& second, double share, const std::string& what);

}  // namespace stoss
