#pragma once

namespace bench {

/// The case of all benchmarks: ν = 0.33, v = 0.1 c.
inline constexpr double poisson = 0.33;
inline constexpr double speed = 0.1;

/// Its converged 1 − ε² at a hard wall (docs/numerics.md).
inline constexpr double converged_lost_fraction = 0.103088;

/// Converged 1 − ε² for ν = 0.33, by tolerance 1e-5 (docs/numerics.md).
struct HardWallCase {
  double speed;
  double lost_fraction;
};
inline constexpr HardWallCase hard_wall_cases[] = {
    {0.001, 0.0284886}, {0.01, 0.031382}, {speed, converged_lost_fraction}, {0.3, 0.293637}};

}  // namespace bench
