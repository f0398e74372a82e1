#pragma once

#include <memory>
#include <vector>

#include "bodies/half_space/plane/waves.hpp"
#include "bodies/parity.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::half_space {

/// W and V of both components of a half-plane between contact points, as Residual.
class PlaneResidual {
 public:
  PlaneResidual(const Medium& medium, double cutoff, std::shared_ptr<const std::vector<PlaneWaves>> waves);

  [[nodiscard]] std::vector<double> compliance(Parity parity, const ContactPoints& points, const Poll& poll) const;
  [[nodiscard]] std::vector<double> second_moment(Parity parity, const ContactPoints& points, const Poll& poll) const;

 private:
  Medium medium_;
  double highest_kept_;    // wave number
  double highest_moment_;  // wave number up to which V is summed
  std::shared_ptr<const std::vector<PlaneWaves>> waves_;
};

}  // namespace stoss::bodies::half_space
