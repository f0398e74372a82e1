#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/vibration/rod_chain.hpp"
#include "vibration/rod_wave.hpp"

namespace stoss {

/// Mass, transit time and impedance of a rod in the units in which it is given.
struct RodMeasures {
  double length, speed, mass, transit, impedance;

  explicit RodMeasures(const Rod& rod)
      : length(rod.length),
        speed(std::sqrt(rod.young / rod.density)),
        mass(rod.density * rod.area * rod.length),
        transit(length / speed),
        impedance(mass / transit) {}
};

/// What becomes of two rods that meet.
struct RodMeeting {
  double restitution = 0.0;
  double unresolved = 0.0;  ///< energy lost
};

/// The vibrations of the rods of a chain, each at its own time, and what they do to a collision.
class RodVibrations {
 public:
  virtual ~RodVibrations() = default;

  /// Lets a rod vibrate freely for a time, and leaves the share `kept` of the energy.
  virtual void age(std::size_t rod, double time, double kept) = 0;

  /// Energy of the vibration of a rod.
  [[nodiscard]] virtual double energy(std::size_t rod) const = 0;

  /// Lets a rod and its right neighbour meet, whose undeformed ends touch now. Afterwards they vibrate as they would if
  /// they had been flying freely since their undeformed ends parted. What it throws leaves the vibrations as they were.
  virtual RodMeeting meet(std::size_t left, std::size_t right, double speed) = 0;

  /// Turns the velocities of a vibration round.
  virtual void reverse(std::size_t rod) = 0;
};

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

/// Rods on a line whose collisions are computed by the method of characteristics.
///
/// While the ends touch, with the incoming waves w₁ and w₂ (each with half the velocity of its centre), the force is
///
///   F = 2 (w₁ − w₂) Z₁Z₂/(Z₁ + Z₂),   and the waves w₁ − F/Z₁ and w₂ + F/Z₂ are sent back;
///
/// where it would pull, the ends part at the rate 2(w₂ − w₁), and touch again when their gap has closed. All of this is
/// exact for waves in pieces. Afterwards pieces are merged, which keeps momentum and loses the energy that is reported.
class RodWaves : public RodVibrations {
 public:
  RodWaves(const std::vector<Rod>& rods, const RodChainOptions& options);

  void age(std::size_t rod, double time, double kept) override;
  [[nodiscard]] double energy(std::size_t rod) const override { return waves_[rod].energy(); }
  RodMeeting meet(std::size_t left, std::size_t right, double speed) override;
  void reverse(std::size_t rod) override { waves_[rod].reverse(); }

  /// The wave of a rod, of mean zero.
  [[nodiscard]] RodWave& wave(std::size_t rod) { return waves_[rod]; }

 private:
  std::vector<RodWave> waves_;
  std::size_t most_;  // pieces of a wave
  Poll poll_;
};

}  // namespace stoss
