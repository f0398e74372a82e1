#pragma once

#include <cstddef>

namespace gas {

/// Equal rough particles of constant ε_n and ε_t, whose velocities and spins stay Gaussian and independent of one
/// another. Per collision of a particle its temperatures T of translation and T_r of rotation, energies over half of
/// the degrees of freedom, D and D_r = D(D − 1)/2, change by
///
///     D ΔT = −(1 − ε_n²) T − 2(D − 1) η [T − η (T + T_r/q)],   D_r ΔT_r = 2(D − 1) (η/q) [η (T + T_r/q) − T_r],
///
/// with q = I/mR² and η = q(1 + ε_t)/2(1 + q) (M. Huthmann and A. Zippelius, Phys. Rev. E 56, R6275, 1997).
struct MeanField {
  std::size_t dimension;
  double restitution, tangential;

  struct State {
    double moving, turning;
  };

  /// Changes in one collision of each particle.
  [[nodiscard]] State change(const State& now) const {
    const auto d = static_cast<double>(dimension);
    const double inertia = dimension == 2 ? 0.5 : 0.4, turns = 0.5 * d * (d - 1.0), ways = 2.0 * (d - 1.0);
    const double eta = inertia * (1.0 + tangential) / (2.0 * (1.0 + inertia));
    const double slides = now.moving + now.turning / inertia;
    return {-((1.0 - restitution * restitution) * now.moving + ways * eta * (now.moving - eta * slides)) / d,
            ways * eta / inertia * (eta * slides - now.turning) / turns};
  }

  /// After some collisions of each particle.
  [[nodiscard]] State after(State now, double collisions) const {
    constexpr int steps = 200;
    for (int k = 0; k < steps; ++k) {
      const State first = change(now);
      const double half = 0.5 * collisions / steps;
      const State middle = change({now.moving + half * first.moving, now.turning + half * first.turning});
      now.moving += 2.0 * half * middle.moving;
      now.turning += 2.0 * half * middle.turning;
    }
    return now;
  }
};

}  // namespace gas
