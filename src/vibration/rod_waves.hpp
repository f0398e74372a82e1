#pragma once

#include <vector>

#include "vibration/rod_vibrations.hpp"
#include "vibration/rod_wave.hpp"

namespace stoss {

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
