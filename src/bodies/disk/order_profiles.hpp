#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "bodies/disk/harmonics.hpp"
#include "bodies/disk/radial_field.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::disk {

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
class OrderProfiles {
 public:
  static constexpr std::size_t components = 5;  // those of RadialField, in its order
  using Profile = std::array<Harmonics::Matrix, components>;

  /// @throws InvalidInput if the modes of the body are not those of a disk of this Poisson's ratio
  OrderProfiles(double poisson, const Body& body, const ContactPoints& contact, std::vector<double> radius,
                const Poll& poll);

  /// Number of kept modes, in the order of Body::groups.
  [[nodiscard]] Eigen::Index modes() const { return modes_; }
  [[nodiscard]] Eigen::Index nodes() const { return node_.size(); }

  /// Number of orders that count at each radius; the others are smaller by 1e-20.
  [[nodiscard]] const std::vector<int>& orders() const { return orders_; }

  /// Fills radii × order_block values of each component for the orders from `first`.
  void evaluate(const Eigen::VectorXd& coordinate, const Eigen::ArrayXd& node_force, int first, const Poll& poll,
                Profile& profile) const;

 private:
  /// The kept modes of one order: C/ω² and S/ω², and their fields in rows of components × radii.
  struct KeptOrder {
    int order;
    Eigen::Index first;  // of its modes in the coordinates
    Eigen::VectorXd radial, tangential;
    Eigen::MatrixXd field;
  };

  /// w_n p_n and w_n t_n of a block of orders.
  struct Loads {
    Eigen::VectorXd normal, shear;
  };

  void keep(const Body& body, const ModeGroup& group, const Poll& poll);
  [[nodiscard]] Loads loads(const Eigen::ArrayXd& node_force, int first) const;
  void add_static(const Loads& loads, int first, const Poll& poll, Profile& profile) const;
  void add_kept(const Eigen::VectorXd& coordinate, const Loads& loads, int first, Profile& profile) const;

  double poisson_;
  Eigen::ArrayXd node_;  // φ_i
  int nyquist_;
  std::vector<double> radius_;
  std::vector<int> orders_;
  std::vector<KeptOrder> kept_;
  Eigen::Index modes_ = 0;
};

}  // namespace stoss::bodies::disk
