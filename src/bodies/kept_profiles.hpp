#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "check.hpp"
#include "stoss/bodies/round.hpp"
#include "stoss/body/body.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies {

/// r^{n−2} − r^n, r^{n−1}, r^n and r^{n+1}, with 0 for a negative power: what static fields of round bodies consist of.
struct RadialPowers {
  double below, low, here, high;
};

/// Number of orders whose static field is felt at a radius, of those up to Nyquist: r^n falls to 1e-20.
[[nodiscard]] inline int static_orders(double radius, int nyquist) {
  if (radius == 1.0) return nyquist + 1;
  const double last = 3.0 - 46.0 / std::log(std::max(radius, 1e-30));
  return 1 + (last < nyquist ? static_cast<int>(last) : nyquist);
}

/// What fields of disks and spheres at given radii have in common: the orders that count, and what the kept modes add
/// to the static field of each order,
///
///   Σ_kept (Q − w_n Q_static) u_l,   Q_static = (g_r radial + g_t tangential)/ω²,
///
/// with the generalised loads g of the forces on the contact points.
/// @tparam Shape tells the two apart: how many `components` a field has, the `angle` of a contact point, the `mode` of
/// a
///               place in a group, its `field`, the `values` and the `shear` stress of that, the `root` by which
///               tangential components of an order are weighted, and what a body is called (refusal)
template <typename Shape>
class KeptProfiles {
 public:
  static constexpr std::size_t components = Shape::components;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using Profile = std::array<Matrix, components>;  // radii × orders of a block

  /// Number of kept modes, in the order of Body::groups.
  [[nodiscard]] Eigen::Index modes() const { return modes_; }

  /// Number of contact points.
  [[nodiscard]] Eigen::Index points() const { return point_.size(); }

  /// Number of orders that count at each radius; the others are smaller by 1e-20.
  [[nodiscard]] const std::vector<int>& orders() const { return orders_; }

 protected:
  /// @throws InvalidInput if the modes of the body are not those of a free body of this Poisson's ratio
  KeptProfiles(double poisson, const Body& body, const ContactPoints& contact, std::vector<double> radius,
               const Poll& poll)
      : poisson_(poisson),
        point_(static_cast<Eigen::Index>(contact.count)),
        nyquist_(static_cast<int>(std::lround(std::numbers::pi / (contact.spacing * contact.radius)))),
        radius_(std::move(radius)) {
    for (Eigen::Index i = 0; i < point_.size(); ++i) point_(i) = Shape::angle(contact, static_cast<std::size_t>(i));
    int kept_orders = 0;
    for (const ModeGroup& group : body.groups) {
      keep(body, group, poll);
      kept_orders = std::max(kept_orders, group.order + 1);
    }
    for (const double r : radius_) orders_.push_back(std::max(kept_orders, static_orders(r, nyquist_)));
  }

  /// Weight w_n of an order in what the contact points resolve.
  [[nodiscard]] double weight(int order) const { return order < nyquist_ ? 1.0 : (order == nyquist_ ? 0.5 : 0.0); }

  /// Adds what the kept modes have more than static ones to the orders of a block.
  /// @param load w_n g_r and w_n g_t of an order
  template <typename Load>
  void add_kept(const Eigen::VectorXd& coordinate, Load load, int first, int block, Profile& profile) const {
    const auto radii = static_cast<Eigen::Index>(radius_.size());
    for (const KeptOrder& kept : kept_) {
      const int k = kept.order - first;
      if (k < 0 || k >= block) continue;
      const auto [radial, tangential] = load(kept.order);
      const Eigen::VectorXd excess =
          coordinate.segment(kept.first, kept.radial.size()) - radial * kept.radial - tangential * kept.tangential;
      const Eigen::VectorXd sum = kept.field * excess;
      for (std::size_t i = 0; i < components; ++i) {
        profile[i].col(k) += sum.segment(static_cast<Eigen::Index>(i) * radii, radii);
      }
    }
  }

  double poisson_;
  Eigen::ArrayXd point_;  // angles of the contact points
  int nyquist_;
  std::vector<double> radius_;

 private:
  /// The kept modes of one order: their amplitudes over ω², and their fields in rows of components × radii.
  struct KeptOrder {
    int order;
    Eigen::Index first;  // of its modes in the coordinates
    Eigen::VectorXd radial, tangential;
    Eigen::MatrixXd field;
  };

  void keep(const Body& body, const ModeGroup& group, const Poll& poll) {
    const auto radii = static_cast<Eigen::Index>(radius_.size());
    const auto size = static_cast<Eigen::Index>(group.omega.size());
    KeptOrder kept{group.order, modes_, Eigen::VectorXd(size), Eigen::VectorXd(size),
                   Eigen::MatrixXd(static_cast<Eigen::Index>(components) * radii, size)};
    std::vector<double> with_edge = radius_;
    with_edge.push_back(1.0);
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const Mode mode = Shape::mode(group, l);
      const auto field = Shape::field(poisson_, mode, with_edge, poll);
      require_free_edge(body, mode, field.back());
      const auto column = static_cast<Eigen::Index>(l);
      kept.radial[column] = mode.radial / (mode.omega * mode.omega);
      kept.tangential[column] = mode.tangential / (mode.omega * mode.omega);
      for (std::size_t r = 0; r < radius_.size(); ++r) {
        const auto value = Shape::values(field[r]);
        for (std::size_t i = 0; i < components; ++i) {
          kept.field(static_cast<Eigen::Index>(i) * radii + static_cast<Eigen::Index>(r), column) = value[i];
        }
      }
    }
    kept_.push_back(std::move(kept));
    modes_ += size;
  }

  /// Checks the Poisson's ratio: only with its own does a mode have these amplitudes at a free edge.
  template <typename Field>
  void require_free_edge(const Body& body, const Mode& mode, const Field& edge) const {
    const double root = Shape::root(mode.order);
    const double amplitude = std::hypot(mode.radial, root * mode.tangential);
    const double mismatch = std::hypot(edge.radial - mode.radial, root * (edge.tangential - mode.tangential));
    const double traction = std::hypot(edge.stress_rr, root * Shape::shear(edge));
    if (mismatch < 1e-6 * amplitude && traction < 1e-6 * amplitude * (mode.order + mode.omega)) return;
    throw InvalidInput::out_of_range("poisson", shown(poisson_), "only that of the body, which is '" + body.name + "'",
                                     Shape::refusal);
  }

  std::vector<int> orders_;
  std::vector<KeptOrder> kept_;
  Eigen::Index modes_ = 0;
};

}  // namespace stoss::bodies
