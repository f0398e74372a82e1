#pragma once

#include <array>
#include <memory>
#include <vector>

#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// A body at one instant of its impact.
struct Frame {
  double time = 0.0;                ///< R/c, from the start of the impact
  double force = 0.0;               ///< F, πRE = mc²/R
  double contact_half_width = 0.0;  ///< R
  State state;
  std::vector<double> node_force;                    ///< share of each contact node in F
  std::array<std::vector<double>, 2> crept_force{};  ///< Snapshot::crept_force
};

/// One of two bodies at one instant. Lengths and the place are in units of the first, what is inside the body in its
/// own: the arguments of DiskField and SphereField.
struct BodyFrame {
  std::shared_ptr<const Body> body;
  double length = 1.0;              ///< R of the body, in that of the first
  double stress = 1.0;              ///< its unit of stress (of a disk or a sphere E), in that of the first
  double center = 0.0;              ///< place of its centre: the bodies at rest would first touch at x = 0
  ContactPoints points;             ///< on the body
  std::vector<double> coordinate;   ///< Q of its modes
  std::vector<double> node_force;   ///< share of each contact node in F, towards the inside of the body, its mc²/R
  std::vector<double> crept_force;  ///< the same of Frame::crept_force: node_force without loss
};

/// Place of the centre of one of the bodies, R of the first: the bodies at rest would first touch at x = 0, and the
/// first is at x < 0. Places are those of an observer who moves with the centre of mass of both; at a wall, with the
/// wall.
/// @param number 0: of the first, 1: of the second body
/// @throws InvalidInput for a body that is not there
[[nodiscard]] double center(const Contact& contact, const State& state, int number);

/// What meets, seen by one of the bodies. Places are those of an observer who moves with the centre of mass of both; at
/// a wall, with the wall.
/// @param grid   the contact points of the impact
/// @param number 0: of the first, 1: of the second body
/// @throws InvalidInput for a body that is not there, and a frame of another contact
[[nodiscard]] BodyFrame seen_by(const Contact& contact, const ContactGrid& grid, const Frame& frame, int number);

/// Displacement of the surface of a body by its kept modes, towards what it meets, in its own units: at points that lie
/// on the surface as contact points do.
[[nodiscard]] std::vector<double> surface_displacement(const BodyFrame& seen, const ContactPoints& points);

/// Compliance of the modes of a body that are not kept: displacement into the body at a contact point, in its own
/// units, per share of force BodyFrame::crept_force at another.
[[nodiscard]] std::vector<double> residual_compliance(const BodyFrame& seen, const Poll& poll = {});

/// What meets at given times of its impact, which is repeated bit by bit: during the impact at the
/// nearest step (Frame::time says which), before and after it in free flight.
/// @param contact the one of the impact, with all its modes
/// @param impact a result of `impact`
/// @param times  R/c, ascending, −1e4 … 1e4
/// @throws InvalidInput for another body, or times that do not ascend
[[nodiscard]] std::vector<Frame> frames_at(const Contact& contact, const Impact& impact,
                                           const std::vector<double>& times, const Poll& poll = {});

}  // namespace stoss
