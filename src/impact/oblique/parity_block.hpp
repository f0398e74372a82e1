#pragma once

#include <cstddef>
#include <vector>

#include "contact/residual/residuals.hpp"
#include "impact/kept_modes.hpp"
#include "stoss/impact/resolution.hpp"

namespace stoss {

/// Half of all motion of a contact in which directions mix: its modes, and what answers for those that are not kept, of
/// forces of one parity (Body::along). Arrays hold the values of both components at all points.
struct ParityBlock {
  ParityBlock(const Contact& along, const ContactPoints& points, const FixedResolution& resolution, const Poll& poll);

  /// Where the modes put the points.
  const std::vector<double>& place();

  /// Makes `force` that of the kick that is due.
  void load() { modes.load(force, force.size()); }

  /// Energy of the modes of one of the bodies.
  [[nodiscard]] double vibration(int body) const;

  /// What its material has taken.
  [[nodiscard]] double dissipated(int body) const;

  Contact contact;
  KeptModes modes;
  Residuals residuals;
  std::vector<double> force, displacement;

 private:
  ParityBlock(const Contact& along, const ContactGrid& grid, const FixedResolution& resolution, const Poll& poll);
  [[nodiscard]] std::size_t begin(int body) const { return body == 0 ? 0 : contact.first_groups; }
  [[nodiscard]] std::size_t end(int body) const { return body == 0 ? contact.first_groups : contact.groups.size(); }

  std::vector<double> moved_;
};

}  // namespace stoss
