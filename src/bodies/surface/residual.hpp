#pragma once

#include <memory>
#include <vector>

#include "bodies/surface/medium_surface.hpp"
#include "bodies/surface/waves.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies {

/// W and V of the surface between contact points: the waves that are not kept among those of kept wave numbers, and all
/// waves of higher ones, of W up to the wave number π/h that points of spacing h resolve.
class WaveResidual {
 public:
  /// @param highest_kept wave number up to which waves are kept
  WaveResidual(MediumSurface medium, double cutoff, double highest_kept,
               std::shared_ptr<const std::vector<SurfaceWaves>> waves);

  [[nodiscard]] std::vector<double> compliance(const ContactPoints& points, const Poll& poll) const;
  [[nodiscard]] std::vector<double> second_moment(const ContactPoints& points, const Poll& poll) const;

  /// As Body::stable_step.
  [[nodiscard]] double stable_step() const;

 private:
  MediumSurface medium_;
  double highest_kept_;    // wave number
  double highest_moment_;  // wave number up to which V is summed
  std::shared_ptr<const std::vector<SurfaceWaves>> waves_;
};

/// Distance of the point i from the axis.
[[nodiscard]] double lateral_distance(const ContactPoints& points, std::size_t i);

}  // namespace stoss::bodies
