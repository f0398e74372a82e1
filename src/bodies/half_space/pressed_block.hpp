#pragma once

#include <vector>

#include "bodies/half_space/lasting_force.hpp"
#include "bodies/surface/pressed.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::half_space {

/// How forces on a small part of the surface of a half-space move one of its points, in its units (E = ρ = 1).
///
/// In each step the rate of the force is linear, so that ∫Ḟ G dt needs two integrals of the exact answer G to a force
/// that lasts; velocities have the same with the rate in place of the force.
class PressedBlock {
 public:
  /// @param largest radius of the loads
  PressedBlock(double poisson, double distance, double depth, double largest, const Instants& instants,
               const Poll& poll);

  [[nodiscard]] Motion of(const PressedLoad& load) const;

 private:
  struct Source {
    bool middle;
    Displaced weight;
    std::vector<LastingForce::Step> answer;  ///< over steps
  };
  Instants instants_;
  Cross cross_;
  std::vector<Source> sources_;
};

}  // namespace stoss::bodies::half_space
