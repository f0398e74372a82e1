#pragma once

#include <functional>
#include <span>

#include "stoss/contact/contact.hpp"

namespace stoss {

/// What a contact point does along the surface; where it slips, the sign of its slip.
enum class Grip : int {
  backward = -1,  ///< slips along −y
  stick = 0,      ///< stays where it is
  forward = 1,    ///< slips along +y
  open = 2        ///< carries no pressure
};

/// A contact point at one instant of an oblique impact. Of disks there are points on both sides of the axis, of
/// spheres rings that move in one direction.
struct ObliquePoint {
  double place = 0.0;    ///< R along the surface from the axis; of disks < 0 on the side of −y, of rings their radius
  double measure = 0.0;  ///< what it stands for: length of edge, R; area of a ring, R²
  double pressure = 0.0;  ///< share in the force, πRE = mc²/R
  double friction = 0.0;  ///< share in the friction, mc²/R
  double slip = 0.0;      ///< velocity of the first surface along y over the second, mean of the step before, c; 0 at
                          ///< the first instant. Points that stick move a little where they land (Friction)
  Grip grip = Grip::open;
};

/// Where the energy is during an oblique impact, as shares of what there was before; the sum is 1 but for the error.
struct ObliqueEnergies {
  double translation = 0.0;      ///< along the normal
  double across = 0.0;           ///< along the surface
  double rotation = 0.0;         ///< of the first body
  double second_rotation = 0.0;  ///< of the second
  double elastic = 0.0;   ///< what went into the bodies: they vibrate with it, hold it, or have lost it to the material
                          ///< and to the modes above the cutoff
  double friction = 0.0;  ///< heat of sliding, and what points hold that land (ObliqueLedger)
};

/// One instant of an oblique impact, in units of the first body and with the axes and signs of Obliquity.
struct ObliqueSnapshot {
  double time = 0.0;          ///< R/c, from the start
  double center = 0.0;        ///< x₀, R, as of Snapshot
  double velocity = 0.0;      ///< of approach along the normal, c
  double shift = 0.0;         ///< way of the centre of the first along y relative to the second since the start, R
  double tangential = 0.0;    ///< v_t, c
  double angle = 0.0;         ///< by which the first has turned since the start, radians
  double second_angle = 0.0;  ///< the second, in its own sense
  double spin = 0.0;          ///< Ω₁, c/R
  double second_spin = 0.0;   ///< Ω₂, c/R of the first
  double force = 0.0;         ///< F, the sum of all pressures, πRE = mc²/R
  double friction = 0.0;      ///< Q, the sum of all friction, mc²/R; positive where it acts against +y on the first
  int touching = 0;           ///< number of points with pressure
  ObliqueEnergies energy;
  std::span<const ObliquePoint> points;  ///< in order of their places; valid during the call
};

/// Where something is in the plane of an oblique impact, R of the first body.
struct PlanePoint {
  double x = 0.0;
  double y = 0.0;
};

/// Place of the centre of one of the bodies: the bodies at rest would first touch at x = 0, and both centres are at
/// y = 0 at the start. Places are those of an observer who moves with the centre of mass of both; at a wall or with a
/// half-space, with that.
/// @param number 0: of the first, 1: of the second body
/// @throws InvalidInput for a body that is not there
[[nodiscard]] PlanePoint center(const Contact& contact, const ObliqueSnapshot& now, int number);

/// Receives the instants of an oblique impact in order of time. What it throws ends the impact and reaches the caller.
using ObliqueImpactObserver = std::function<void(const ObliqueSnapshot&)>;

/// What is seen of an oblique impact.
struct ObliqueObservation {
  ObliqueImpactObserver observer{};
  int every = 1;  ///< the observer sees the first instant, every so many steps, and the last
};

}  // namespace stoss
