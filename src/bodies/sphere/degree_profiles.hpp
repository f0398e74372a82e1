#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "bodies/kept_profiles.hpp"
#include "bodies/sphere/radial_field.hpp"
#include "bodies/sphere/surface_points.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::sphere {

/// What tells the profiles of a sphere from those of other round bodies.
struct ProfileShape {
  static constexpr std::size_t components = 6;  // those of RadialField, in its order
  static constexpr auto refusal = "a sphere; with another number its modes would not leave the surface free";

  static double angle(const ContactPoints& contact, std::size_t i) { return ring_angle(contact, i); }
  static Mode mode(const ModeGroup& group, std::size_t l) {
    const double n = group.order, upper = group.upper[l], lower = group.lower[l];
    return {group.order, static_cast<int>(l), group.omega[l], upper + lower,
            group.order > 0 ? lower / n - upper / (n + 1.0) : 0.0};
  }
  static std::vector<RadialField> field(double poisson, const Mode& mode, const std::vector<double>& radius,
                                        const Poll& poll) {
    return mode_field(poisson, mode, radius, poll);
  }
  static std::array<double, components> values(const RadialField& field) {
    return {field.radial, field.tangential, field.stress_rr, field.stress_rt, field.hoop, field.bend};
  }
  static double shear(const RadialField& field) { return field.stress_rt; }
  static double root(int degree) { return std::sqrt(degree * (degree + 1.0)); }
};

/// Displacement and stress of every degree n of a sphere at given radii,
///
///   w_n u_static[p_n, t_n] + Σ_kept (Q − w_n Q_static) u_l,   Q_static = (g_U U + g_V V)/ω²,
///
/// with the generalised loads of the ring forces F_i (in units mc²/R)
///
///   g_U = −Σ_i F_i cos θ_i P_n,   g_V = Σ_i F_i sin θ_i dP_n/dθ,
///
/// p = (2n+1) g_U/3 and t = (2n+1) g_V/(3L), L = n(n+1), and w_n = 1 below the Nyquist degree π/h of the rings, ½ at it
/// and 0 beyond, as in Residual.
class DegreeProfiles : public KeptProfiles<ProfileShape> {
 public:
  static constexpr int block = 32;  // of degrees

  /// w_n g_U and w_n g_V of all degrees up to Nyquist and of all kept ones.
  struct Loads {
    std::vector<double> radial, tangential;
  };

  DegreeProfiles(double poisson, const Body& body, const ContactPoints& contact, std::vector<double> radius,
                 const Poll& poll);

  [[nodiscard]] Loads loads(const Eigen::ArrayXd& ring_force, const Poll& poll) const;

  /// Fills radii × block values of each component for the degrees from `first`.
  void evaluate(const Eigen::VectorXd& coordinate, const Loads& loads, int first, const Poll& poll,
                Profile& profile) const;

 private:
  void add_static(const Loads& loads, int first, const Poll& poll, Profile& profile) const;
};

}  // namespace stoss::bodies::sphere
