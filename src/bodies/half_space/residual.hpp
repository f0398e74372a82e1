#pragma once

#include <memory>
#include <vector>

#include "bodies/half_space/surface_waves.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::half_space {

/// W and V of the surface between contact points: the waves that are not kept among those of kept wave numbers, and all
/// waves of higher ones, of W up to the wave number π/h that points of spacing h resolve.
class Residual {
 public:
  Residual(const Medium& medium, double cutoff, std::shared_ptr<const std::vector<SurfaceWaves>> waves);

  [[nodiscard]] std::vector<double> compliance(const ContactPoints& points, const Poll& poll) const;
  [[nodiscard]] std::vector<double> second_moment(const ContactPoints& points, const Poll& poll) const;

  /// As Body::stable_step.
  [[nodiscard]] double stable_step() const;

 private:
  Medium medium_;
  double highest_kept_;    // wave number
  double highest_moment_;  // wave number up to which V is summed
  std::shared_ptr<const std::vector<SurfaceWaves>> waves_;
};

/// Distance of the point i from the axis.
[[nodiscard]] double lateral_distance(const ContactPoints& points, std::size_t i);

}  // namespace stoss::bodies::half_space
