#pragma once

#include <vector>

#include "stoss/quasistatic/oblique/maw.hpp"

namespace stoss::quasistatic {

/// The tangential force of Hertz' contact with Coulomb friction, exact for any history of approach and displacement of
/// distant points along the wall, as long as both directions are uncoupled and the direction of the traction uniform.
///
/// In units of the maximum approach d_m and the maximum radius of the contact a_m; displacements are times κ/(μ d_m),
/// forces over μ those of the normal direction, N = d^{3/2}, a² = d.
///
/// Pressure and tangential traction have one kernel, and with it one Abel transform: p(r) is that of d − x², and t(r)
/// that of a function Q(x),
///
///   N = (3/2)∫₀ᵃ (d − x²) dx,   T = (3/2)∫₀ᵃ Q dx,   |Q| ≤ d − x².
///
/// Q(x) follows the displacement U where it sticks, Q̇ = U̇, and else stays at its limit: springs side by side. Both
/// slacks d − x² ∓ Q fall with x, since outer springs touch last and have the lower limits. What slips is therefore
/// always x > c, in one direction, and so are its images: in the circle r < c all points move alike, in the ring r > c
/// the traction is ±μp against the slip, and inside |t| ≤ μp (docs/theory/points.md; the principle of J. Jäger, J.
/// Tribol. 120, 677, 1998, and M. Ciavarella, Int. J. Solids Struct. 35, 2349, 1998, for any path). With Q = U − B,
/// B(x²) has slopes from −1 to 1, and is a straight line where springs have slipped; new slip overwrites what lies
/// outside of c.
class TangentialContact {
 public:
  /// Before first touch.
  TangentialContact() : knots_{Knot{}} {}

  /// A contact that slides as a whole, from U = 0 on in positive direction.
  static TangentialContact sliding(double approach);

  /// Takes approach and displacement along a straight line to new values.
  void move(double approach, double displacement);

  /// T/μ, from −d^{3/2} to d^{3/2}.
  [[nodiscard]] double force() const;

  /// Radius of the contact, √d.
  [[nodiscard]] double radius() const { return knots_.back().radius; }

  /// c: inside of it nothing slipped in the last move.
  [[nodiscard]] double stick_radius() const { return stick_radius_; }

 private:
  /// B is linear in x² between knots; the last one is at the edge of the contact, where Q = 0.
  struct Knot {
    double square = 0.0;    ///< x²
    double rest = 0.0;      ///< B, the displacement at which this spring is relaxed
    double radius = 0.0;    ///< x
    double integral = 0.0;  ///< ∫₀ˣ B dx
  };
  std::vector<Knot> knots_;
  double stick_radius_ = 0.0;

  void append(double square, double rest);
};

/// Maw's impact in a given number of steps, from where the contact begins to stick to its end. The error falls as the
/// square of the steps, with a smooth part that extrapolation removes and one of where phases begin within steps.
/// @param psi1 0 to sliding_limit(chi)
/// @return the impulse, and the shares of time; the rest is left out
[[nodiscard]] MawImpact maw_path(double psi1, double chi, int steps);

}  // namespace stoss::quasistatic
