#pragma once

namespace bench {

/// The case of all benchmarks of disks: ν = 0.33, v = 0.1 c.
inline constexpr double poisson = 0.33;
inline constexpr double speed = 0.1;

/// Its converged 1 − ε² at a hard wall (docs/developer/numerics.md).
inline constexpr double converged_lost_fraction = 0.103088;

/// The Poisson's ratio of spheres.
inline constexpr double poisson_of_sphere = 0.3;

/// A speed and its converged 1 − ε².
struct ConvergedCase {
  double speed;
  double lost_fraction;
};

/// A disk at a hard wall, by tolerance 1e-5 (docs/developer/numerics.md).
inline constexpr ConvergedCase hard_wall_cases[] = {
    {0.001, 0.0284886}, {0.01, 0.031382}, {speed, converged_lost_fraction}, {0.3, 0.293637}};

/// A sphere at a hard wall (tests/data/sphere_restitution.csv).
inline constexpr ConvergedCase sphere_cases[] = {{0.1, 0.0173464},   {0.05, 0.0188353},   {0.02, 0.00153148},
                                                 {0.01, 0.00277848}, {1e-3, 2.398636e-4}, {1e-4, 2.494181e-5}};

/// A sphere on a half-space of its material.
inline constexpr ConvergedCase half_space_cases[] = {
    {0.1, 0.303066}, {0.01, 0.0786814}, {1e-3, 0.0187658}, {1e-4, 0.00459330}};

}  // namespace bench
