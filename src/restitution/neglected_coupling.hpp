#pragma once

#include <map>
#include <optional>

#include "impact/oblique/rings/outward_impact.hpp"
#include "impact/oblique/rings/ring_slide.hpp"
#include "stoss/restitution/oblique.hpp"

namespace stoss {

/// Estimates what the coupling of both directions would change in oblique impacts of balls at one speed: an outward
/// impact for each friction, and a slide with it and one without for each obliquity, on a few rings and with few modes.
class NeglectedCoupling {
 public:
  NeglectedCoupling(const RefinableContact& contact, double speed, Poll poll);

  [[nodiscard]] Coupling at(const Obliquity& obliquity);

 private:
  void prepare();
  const std::optional<OutwardImpact>& outward(double friction);
  [[nodiscard]] Coupling unknown() const;

  const RefinableContact& refinable_;
  double speed_;
  Poll poll_;
  bool prepared_ = false;
  double dundurs_ = 0.0;
  const Contact* contact_ = nullptr;  // null: the bodies are equal
  std::optional<Contact> outward_;
  std::optional<TangentialResponse> response_;
  std::map<double, std::optional<OutwardImpact>> impacts_;  // by friction; empty: there is none
};

}  // namespace stoss
