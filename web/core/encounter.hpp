#pragma once

#include <emscripten/val.h>

#include <optional>
#include <string>

#include "stoss/material.hpp"
#include "stoss/quantity.hpp"
#include "stoss/restitution/ladder.hpp"

namespace stoss::web {

enum class BodyKind { disk, sphere, rod };

/// A body as the page gives it, in SI or in units of the first.
struct GivenBody {
  double poisson, radius, young, density, area, loss_time;
  double yield_strength;  ///< 0: not known
};

/// Who meets whom: the Encounter of web/src/core/protocol.ts in the words of the core.
class Encounter {
 public:
  /// @throws InvalidInput for numbers that no body can have
  explicit Encounter(const emscripten::val& given);

  [[nodiscard]] BodyKind kind() const { return kind_; }
  [[nodiscard]] const std::optional<Scales>& si() const { return si_; }
  [[nodiscard]] bool against_half_space() const { return against_ == "half-space"; }

  /// Of a body, that the core computes with: of a disk the 2-D one.
  [[nodiscard]] double poisson(int body) const;

  [[nodiscard]] const RefinableContact& refinable() const { return *refinable_; }

  /// At one cutoff and speed, in c/R and c, as `stoss impact` has it.
  [[nodiscard]] Contact contact(double cutoff, double speed) const;

  /// 0: of the first body, 1: of the second.
  [[nodiscard]] BodyMaker maker(int body) const { return body == 0 ? first_ : second_; }

  /// A speed as the page gives it, in c. @throws InvalidInput out of 1e-8 … 1 c
  [[nodiscard]] double own_speed(double speed) const;

  /// At which one of the bodies begins to yield, m/s: of spheres in SI with a yield strength.
  [[nodiscard]] std::optional<double> yield_speed() const;

  /// Value of a unit of the first body in what the page is given: 1, or in SI.
  [[nodiscard]] double unit(Dimension dimension) const;

  /// Name of what the page is given: as R/c, or s.
  [[nodiscard]] std::string unit_name(Dimension dimension) const;

  /// Name of a unit of the first body.
  [[nodiscard]] std::string own_unit_name(Dimension dimension) const;

 private:
  [[nodiscard]] Plane plane() const { return strain_ ? Plane::strain : Plane::stress; }
  [[nodiscard]] std::optional<Scales> scales_of(const GivenBody& body) const;
  [[nodiscard]] BodyMaker make(const GivenBody& body, int number) const;
  [[nodiscard]] BodyMaker make_half_space(const GivenBody& body) const;

  BodyKind kind_ = BodyKind::disk;
  std::string against_;
  bool strain_ = false;
  GivenBody one_{}, other_{};
  std::optional<Scales> si_;
  BodyMaker first_, second_;
  std::optional<RefinableContact> refinable_;
};

}  // namespace stoss::web
