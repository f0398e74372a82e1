#pragma once

#include <memory>
#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/impact/impact.hpp"
#include "vibration/rod_vibrations.hpp"

namespace stoss {

/// Rods on a line with modes u(s, t) = Σ Q_l √2 cos(lπs/L), s from the left end, whose collisions `impact` computes.
///
/// At its right end a rod moves towards the other one with (−1)^l Q_l, at its left end with −Q_l. Speeds are scaled to
/// a fixed one: rods have no scale of their own.
class RodModes : public RodVibrations {
 public:
  RodModes(const std::vector<Rod>& rods, const RodChainOptions& options);

  void age(std::size_t rod, double time, double kept) override;
  [[nodiscard]] double energy(std::size_t rod) const override;
  RodMeeting meet(std::size_t left, std::size_t right, double speed) override;
  void reverse(std::size_t rod) override;

  /// Q and P of a mode, l = 1, 2, …, in the units of the rods.
  void set(std::size_t rod, int l, double coordinate, double momentum);

  /// ω_l of the modes, in the order in which they are kept.
  [[nodiscard]] const std::vector<double>& frequencies(std::size_t rod) const { return rods_[rod].omega; }

 private:
  struct Vibration {
    RodMeasures measures;
    std::shared_ptr<const Body> body;
    std::vector<int> number{};  // l
    std::vector<double> omega{}, coordinate{}, momentum{};
  };

  /// The impact of a pair that touches in a state, or unexcited.
  [[nodiscard]] Impact collision(const Contact& pair, const State* touching) const;

  std::vector<Vibration> rods_;
  std::vector<Contact> contacts_;  // of each rod and its right neighbour
  Resolution resolution_;
  Poll poll_;
};

}  // namespace stoss
