#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "stoss/bodies/rod.hpp"
#include "stoss/impact/resolution.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// How the collisions of a chain of rods are computed.
enum class RodMethod {
  modes,           ///< by `impact`, of the kept modes of both rods
  characteristics  ///< by d'Alembert's waves in pieces of constant velocity, exact but for merged pieces
};

/// How a chain of rods is computed.
struct RodChainOptions {
  RodMethod method = RodMethod::modes;
  int modes = 50;    ///< of the rod of the shortest transit time, 1 … 10 000; the others keep all up to its frequency
  int pieces = 400;  ///< most of the wave in each rod (characteristics), 2 … 1 000 000
  /// Of each collision (modes). The radiating tail absorbs energy for good, the static one none; times are in the
  /// transit time of the left rod.
  Resolution resolution{};
  std::optional<double> decay_time{};  ///< in which the energy of a vibration falls to 1/e; absent: none, 0: complete
  Poll poll{};
};

/// One collision of a chain. Energies are of the two rods that meet.
struct RodCollision {
  double time = 0.0;
  std::size_t pair = 0;           ///< the rods `pair` and `pair + 1`, of the last one the rod 0
  double speed = 0.0;             ///< of approach
  double restitution = 0.0;       ///< ε, may exceed 1
  double vibration_before = 0.0;  ///< energy of their vibration before
  double vibration_after = 0.0;   ///< and after it
  double unresolved = 0.0;        ///< energy lost to modes above the cutoff, or to pieces that were merged
};

/// A chain of rods at one time.
struct RodChainSample {
  double time = 0.0;
  long collisions = 0;       ///< so far
  double translation = 0.0;  ///< kinetic energy of the rods' centres in the frame of their centre of mass
  double vibration = 0.0;    ///< energy of all vibrations
  double dissipated = 0.0;   ///< energy of vibrations that has decayed so far
  double unresolved = 0.0;   ///< energy lost so far to modes above the cutoff, or to pieces that were merged
  double momentum = 0.0;
};

/// Elastic rods on a ring that move along it, meet their neighbours head-on and remember in their vibrations what they
/// met: the granular gas of G. Giese and A. Zippelius, Phys. Rev. E 54, 4828 (1996), and T. Aspelmeier, G. Giese and
/// A. Zippelius, Phys. Rev. E 57, 857 (1998). All values are in the consistent units in which the rods are given.
///
/// Between collisions rods fly freely, and their modes rotate and decay. A collision is instantaneous compared with the
/// flights: how far rods move while they touch, and how far their ends swing, is neglected against the gaps between
/// them (docs/theory/rod_chain.md). Rods have no scale of speed, so nothing limits how slow they may become.
class RodChain {
 public:
  /// Unexcited rods, with equal gaps.
  /// @param rods          2 to 100 000; lossy material is not computed
  /// @param circumference of the ring, above the sum of the lengths
  /// @param velocities    one for each rod
  /// @throws InvalidInput for arguments out of range
  RodChain(std::vector<Rod> rods, double circumference, const std::vector<double>& velocities,
           const RodChainOptions& options = {});
  RodChain(RodChain&&) noexcept;
  RodChain& operator=(RodChain&&) noexcept;
  ~RodChain();

  /// When the next collision is due; infinite if the rods only part.
  [[nodiscard]] double next() const;

  /// Moves to the next collision and past it.
  /// @throws InvalidInput if there is none; NotConverged if the collisions accumulate at one time (inelastic collapse),
  ///         or as `impact` does: then the collision has not happened
  RodCollision collide();

  /// Moves to a time before the next collision. @throws InvalidInput for a time that has passed, or after that
  void fly(double time);

  /// The chain as it is now.
  [[nodiscard]] RodChainSample sample() const;

  /// Velocity of each rod.
  [[nodiscard]] std::vector<double> velocities() const;

  /// Turns all motion round: the chain runs back in time, exactly where nothing decays or is lost.
  void reverse();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stoss
