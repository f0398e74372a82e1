#pragma once

#include <functional>
#include <span>

#include "stoss/bodies/half_space/field.hpp"
#include "stoss/bodies/half_space/stress.hpp"
#include "stoss/encounter/solid.hpp"
#include "stoss/poll.hpp"

/// What is below the surface of what has no end sideways: half-spaces and half-planes, plates and strips alike.
namespace stoss::ground {

/// The displacement at some points for coordinates of the kept modes and forces on the contact points.
using FieldBelow = std::function<bodies::half_space::Field(std::span<const double> coordinate,
                                                           std::span<const double> node_force, const Poll& poll)>;

/// Whether it is one of them.
[[nodiscard]] bool is_unbounded(const Solid& solid);

/// @param body that solid, and contact points and points in its unit of length
/// @throws InvalidInput as HalfSpaceField and PlateField, and for another solid
[[nodiscard]] FieldBelow field_below(const Solid& solid, const Body& body, const ContactPoints& contact,
                                     const bodies::half_space::PlaneGrid& points, const Poll& poll);

/// Stress of a field at these points, in E of the solid at its surface. @throws as field_below
[[nodiscard]] bodies::half_space::Stress stress_below(const Solid& solid, const bodies::half_space::PlaneGrid& points,
                                                      const bodies::half_space::Field& field);

/// Speeds of waves in the material at the surface, in its √(E/ρ). @throws as field_below
[[nodiscard]] bodies::half_space::WaveSpeeds speeds_below(const Solid& solid);

/// From face to face, in its unit of length; infinite of what has no lower face. @throws as field_below
[[nodiscard]] double thickness_of(const Solid& solid);

/// How long the solid must be good for to be seen up to a time at points as far as some distance, in its own units.
/// @throws as field_below
[[nodiscard]] double lasting_duration(const Solid& solid, double time, double distance);

}  // namespace stoss::ground
