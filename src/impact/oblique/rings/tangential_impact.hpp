#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "contact/residual/residuals.hpp"
#include "impact/kept_modes.hpp"
#include "impact/oblique/film.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/oblique/rings/wave_memory.hpp"
#include "impact/oblique/tangential_motion.hpp"
#include "numeric/kernels.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss {

/// What answers friction at the rings of a contact whose two directions do not act on each other, at rest: the same for
/// all motions along the surface.
struct TangentialResponse {
  /// @param contact    along the normal
  /// @param along      the same against forces along the surface (contacts_along)
  /// @param remembered steps for which waves that run away are a memory of forces (WaveMemory); 0: all are modes
  TangentialResponse(const Contact& contact, const Contact& along, const ContactPoints& points,
                     const FixedResolution& resolution, std::size_t remembered, const Poll& poll);

  double step, ratio;  ///< of softness along the surface to that along the normal
  std::array<std::vector<double>, 2> arm;
  Contact along;  ///< without the waves that are remembered
  WaveMemory waves;
  KeptModes modes;
  Residuals residuals;
  std::vector<double> compliance;  ///< of the residuals in a step, nodes × nodes

 private:
  TangentialResponse(const Contact& contact, const Contact& along, const ContactGrid& grid,
                     const FixedResolution& resolution, std::size_t remembered, const Poll& poll);
};

/// The motion of two bodies along their surfaces under pressures that are known, by kick–rotate–kick as Collision:
/// TangentialMotion, the modes, and friction at each ring.
class TangentialImpact {
 public:
  /// @param response must live as long
  TangentialImpact(const TangentialResponse& response, const ObliqueFrame& frame, const Obliquity& before);

  /// Moves on by one step.
  /// @param give     D of each node, were both directions equally soft (edge_compliance_along)
  /// @param touching number of leading nodes beyond which there is no friction
  /// @param law      law(give, free, friction): the friction of each node, at first that of the step before, for these
  ///                 D and slips without friction
  template <typename Law>
  void advance(const double* give, std::size_t touching, const Law& law) {
    begin_step(give);
    law(give_, free_, friction_);
    end_step(touching);
  }

  [[nodiscard]] AlongMotion motion() const;
  [[nodiscard]] AlongOutcome outcome() const;

  /// What friction does at each node; whether it slides is left to the law.
  [[nodiscard]] std::vector<PointFriction> point_friction() const;

 private:
  using Values = std::vector<double>;
  void begin_step(const double* give);
  void end_step(std::size_t touching);

  const TangentialResponse& response_;
  TangentialMotion rigid_;
  KeptModes modes_;
  WaveMemory waves_;
  Residuals residuals_;
  Values friction_, friction_before_;  // q
  Values at_;                          // where rigid motion and kept modes put the nodes
  Values place_, place_before_;        // of each node along y; in the step before
  Values give_, free_;
  Values moved_, moved_before_;     // u
  double work_ = 0.0, heat_ = 0.0;  // ∫ q du, ∫ q dy
};

}  // namespace stoss
