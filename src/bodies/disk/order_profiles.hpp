#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "bodies/disk/edge_points.hpp"
#include "bodies/disk/radial_field.hpp"
#include "bodies/kept_profiles.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::disk {

/// Sums over angular orders are taken so many orders at a time: the tables stay small for any number of orders.
inline constexpr int order_block = 32;

/// Cosines and sines of nφ for n = first … first + order_block − 1: orders × angles.
struct Harmonics {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Matrix cosine, sine;
};

[[nodiscard]] Harmonics harmonics(const Eigen::ArrayXd& angle, int first);

/// What tells the profiles of a disk from those of other round bodies.
struct ProfileShape {
  static constexpr std::size_t components = 5;  // those of RadialField, in its order
  static constexpr auto refusal = "a disk; with another number its modes would not leave the edge free";

  static double angle(const ContactPoints& contact, std::size_t i) { return edge_angle(contact, i); }
  static Mode mode(const ModeGroup& group, std::size_t l) {
    return {group.order, static_cast<int>(l), group.omega[l], group.upper[l] + group.lower[l],
            group.upper[l] - group.lower[l]};
  }
  static std::vector<RadialField> field(double poisson, const Mode& mode, const std::vector<double>& radius,
                                        const Poll& poll) {
    return mode_field(poisson, mode, radius, poll);
  }
  static std::array<double, components> values(const RadialField& field) {
    return {field.radial, field.tangential, field.stress_rr, field.stress_pp, field.stress_rp};
  }
  static double shear(const RadialField& field) { return field.stress_rp; }
  static double root(int /*order*/) { return 1.0; }
};

/// Displacement and stress of every angular order n of a disk at given radii,
///
///   w_n u_static[p_n, t_n] + Σ_kept (Q − w_n Q_static) u_l,   Q_static = (g_C C + g_S S)/ω²,
///
/// with the generalised loads of the node forces F_i (docs/theory/modes.md),
///
///   g_C = −Σ_i F_i cos nφ_i cos φ_i,   g_S = Σ_i F_i sin nφ_i sin φ_i,
///
/// p = g_C and t = g_S for n ≥ 1, p = ½ g_C for n = 0, and w_n = 1 below the Nyquist order π/h of the nodes, ½ at it
/// and 0 beyond, as in Residual.
class OrderProfiles : public KeptProfiles<ProfileShape> {
 public:
  OrderProfiles(double poisson, const Body& body, const ContactPoints& contact, std::vector<double> radius,
                const Poll& poll);

  /// Fills radii × order_block values of each component for the orders from `first`.
  void evaluate(const Eigen::VectorXd& coordinate, const Eigen::ArrayXd& node_force, int first, const Poll& poll,
                Profile& profile) const;

 private:
  /// w_n p_n and w_n t_n of a block of orders.
  struct Loads {
    Eigen::VectorXd normal, shear;
  };

  [[nodiscard]] Loads loads(const Eigen::ArrayXd& node_force, int first) const;
  void add_static(const Loads& loads, int first, const Poll& poll, Profile& profile) const;
};

}  // namespace stoss::bodies::disk
