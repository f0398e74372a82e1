#pragma once

#include <array>
#include <vector>

#include "contact/edge/compliance.hpp"
#include "contact/edge/edge_law.hpp"

namespace stoss {

/// Up to three neighbouring nodes from `first` on: S f − p = g with the law of each, S their compliance.
struct EdgeZone {
  std::size_t first = 0;
  std::size_t count = 0;
  std::array<std::array<double, 3>, 3> compliance{};  // S; 0 beyond the count, as p
  std::array<double, 3> position{};                   // p
  std::array<double, 3> closure{};                    // t, of the start; then of the solution
};

/// Solves for the closures of the zone by Newton's method from those that it has. @return whether it converged
[[nodiscard]] bool solve_zone(const EdgeLaw& law, EdgeZone& zone);

/// Solves W f − q = g with the law of each node for the closures of all of them, from any start: Newton's method with
/// steps halved while the residual does not fall. f and −g rise with t and W is positive definite, so the solution is
/// unique and no step is singular.
/// @param scale of the positions, to whose rounding the solution is found
/// @return whether it converged
[[nodiscard]] bool solve_all(const FactoredCompliance& compliance, const EdgeLaw& law, const std::vector<double>& q,
                             double scale, const Poll& poll, std::vector<double>& closure);

/// The same for a compliance that need not be symmetric. Where its symmetric part is not positive definite, there need
/// not be a solution, nor only one.
[[nodiscard]] bool solve_all(VaryingCompliance& compliance, const EdgeLaw& law, const std::vector<double>& q,
                             double scale, const Poll& poll, std::vector<double>& closure);

}  // namespace stoss
