#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "bodies/parity.hpp"
#include "bodies/surface/medium_surface.hpp"
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

/// A surface that is moved in both directions of a plane through the wave number.
struct PlaneSurface {
  MediumSurface medium;
  double highest_kept;  ///< wave number up to which waves are kept

  /// Of all waves of one wave number, per dk: their compliance, and Σ 1/ω⁴.
  std::function<Flexibility(double wave_number)> compliance, second_moment;
};

/// W and V of both components of a surface between contact points, as WaveResidual.
class PlaneResidual {
 public:
  PlaneResidual(PlaneSurface surface, double cutoff, std::shared_ptr<const std::vector<PlaneWaves>> waves);

  [[nodiscard]] std::vector<double> compliance(Parity parity, const ContactPoints& points, const Poll& poll) const;
  [[nodiscard]] std::vector<double> second_moment(Parity parity, const ContactPoints& points, const Poll& poll) const;

 private:
  PlaneSurface surface_;
  double highest_moment_;  // wave number up to which V is summed
  std::shared_ptr<const std::vector<PlaneWaves>> waves_;
};

}  // namespace stoss::bodies
