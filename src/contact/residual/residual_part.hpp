#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "relaxation/creep.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// The modes that are not kept of one body, or of all bodies together, at the points of a contact, in units of the
/// first body.
struct ResidualPart {
  std::vector<double> compliance;                      ///< W, points × points
  std::function<std::vector<double>()> second_moment;  ///< V, points × points; refers to the contact and its grid
  std::vector<double> impedance;                       ///< Z of each point
  double cutoff = 0.0;                                 ///< of the kept modes
  Creep creep{};                                       ///< of the material
  std::size_t body = 0;                                ///< 0: of the first or of all, 1: of the second
};

/// One of the two residual matrices of a body: of its compliance, or of its second moment.
using Residual = std::function<std::vector<double>(const ContactPoints&, const Poll&)> Body::*;

/// That matrix of one body at the points of a contact, in its own units. @param number 0: of the first, 1: of the
/// second
/// @throws InvalidInput for a matrix of another size
[[nodiscard]] std::vector<double> residual_of(const Contact& contact, const ContactGrid& grid, int number,
                                              Residual residual, const Poll& poll);

/// How the material of a body creeps. @param unit of time of the body, in which it is
[[nodiscard]] Creep creep_of(const Body& body, double unit);

/// The parts that yield to one force, in series: all bodies together while they lose nothing, else each body, as each
/// has a loss time, and a part of what the materials take; a rigid one has no part.
[[nodiscard]] std::vector<ResidualPart> residual_parts(const Contact& contact, const ContactGrid& grid,
                                                       const Poll& poll);

/// The coats of both bodies, which have no mass: the compliance of each point by itself, over the area that it stands
/// for (projected_areas).
[[nodiscard]] std::vector<ResidualPart> coats(const Contact& contact, const ContactGrid& grid);

/// Adds the compliance between the points with which the kept modes follow a force at once, beside the kicks of period
/// Δt. It is what the kicks leave out (docs/developer/numerics.md, section 2): without losses they move a mode under a
/// constant force by (Δt/2ω) cot(ωΔt/2) instead of 1/ω². Where a body has a loss time it is more, and the kicks are
/// weaker by as much (numeric::stable_kicks). In all the response to slow forces is exact.
/// @param compliance points × points
void add_kick_compliance(const Contact& contact, const ContactGrid& grid, double step, const Poll& poll,
                         Eigen::Ref<Eigen::MatrixXd> compliance);

}  // namespace stoss
