#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "bodies/parity.hpp"
#include "bodies/surface/medium_surface.hpp"
#include "bodies/surface/waves.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies {

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
