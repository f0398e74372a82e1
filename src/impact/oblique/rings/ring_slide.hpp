#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "contact/residual/residuals.hpp"
#include "impact/kept_modes.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/oblique/rings/outward_impact.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

/// The motion along the surface of balls whose rings also slide outward as in an outward impact: Coulomb's law
/// averaged over each ring (RingFriction). What friction along y takes from that outward is left out, and what it does
/// to the pressure; so is then what friction outward does to it, as stuck surfaces are stiffer in both directions
/// alike.
class RingSlide {
 public:
  /// @param along      the contact against forces along the surface (contacts_along)
  /// @param resolution of the outward impacts
  RingSlide(const Contact& contact, const Contact& along, double speed, const FixedResolution& resolution,
            const Poll& poll);

  /// v_t′ and Ω′ after an impact.
  /// @param steps   of the outward impact without friction, for the pressures
  /// @param outward those with this friction, for what it takes and where rings slide; null: friction has one direction
  ///                on all of a ring
  /// @param sliding s
  [[nodiscard]] AlongOutcome after(const std::vector<OutwardStep>& steps, const std::vector<OutwardStep>* outward,
                                   double friction, const AlongOutcome& before, double sliding, const Poll& poll) const;

 private:
  RingSlide(const Contact& contact, const Contact& along, double speed, const FixedResolution& resolution,
            const ContactGrid& grid, const Poll& poll);

  ObliqueFrame frame_;
  double step_;
  double ratio_;  // of softness along the surface to that along the normal
  std::array<Eigen::VectorXd, 2> arm_;
  // At rest.
  KeptModes modes_;
  Residuals residuals_;
  Eigen::MatrixXd compliance_;
};

}  // namespace stoss
