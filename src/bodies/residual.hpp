#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "numeric/kernels.hpp"
#include "stoss/bodies/round.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies {

/// What the static response of a round body has more than that of the plain one, by order: none of a plain one.
struct OrderExcess {
  std::vector<Flexibility> compliance{}, second_moment{};

  /// Entry of an order, 0 beyond the last.
  [[nodiscard]] static Flexibility at(const std::vector<Flexibility>& of, int order) {
    return static_cast<std::size_t>(order) < of.size() ? of[static_cast<std::size_t>(order)] : Flexibility{};
  }
};

[[nodiscard]] inline Flexibility operator+(const Flexibility& one, const Flexibility& other) {
  return {one.radial + other.radial, one.mixed + other.mixed, one.tangential + other.tangential};
}
[[nodiscard]] inline Flexibility operator-(const Flexibility& one, const Flexibility& other) {
  return {one.radial - other.radial, one.mixed - other.mixed, one.tangential - other.tangential};
}

/// The kept modes of a round body, added up order by order: what its static response has too much without them. The
/// two amplitudes of a mode, radial and tangential, make the three entries of a symmetric matrix, a Flexibility.
class KeptSums {
 public:
  /// @param kept modes, sorted by order
  explicit KeptSums(const std::vector<Mode>& kept) {
    const auto orders = kept.empty() ? 0 : static_cast<std::size_t>(kept.back().order) + 1;
    radial_.resize(orders);
    compliance_.resize(orders);
    second_moment_.resize(orders);
    for (const Mode& mode : kept) {
      const auto n = static_cast<std::size_t>(mode.order);
      const double compliance = 1.0 / (mode.omega * mode.omega);
      radial_[n] += mode.radial * mode.radial;
      add(compliance_[n], mode, compliance);
      add(second_moment_[n], mode, compliance * compliance);
    }
  }

  /// Number of orders up to the last that has a kept mode.
  [[nodiscard]] int orders() const { return static_cast<int>(compliance_.size()); }

  /// Σ_kept (radial, tangential)(radial, tangential)ᵀ/ω² of an order.
  [[nodiscard]] const Flexibility& compliance(int order) const { return compliance_[static_cast<std::size_t>(order)]; }

  /// The compliance that a body has more than a plain one, less Σ_kept (radial, tangential)(radial, tangential)ᵀ/ω².
  [[nodiscard]] std::vector<Flexibility> missing_compliance(const OrderExcess& excess = {}) const {
    std::vector<Flexibility> missing = excess.compliance;
    missing.resize(std::max(missing.size(), compliance_.size()));
    for (std::size_t n = 0; n < compliance_.size(); ++n) missing[n] = missing[n] - compliance_[n];
    return missing;
  }

  /// The same with ω⁴ for ω², taken from the sum over all modes of the orders up to a highest one.
  /// @param whole that sum of an order
  template <typename Whole>
  [[nodiscard]] std::vector<Flexibility> remaining_second_moment(int highest, Whole whole) const {
    std::vector<Flexibility> remaining;
    for (int n = 0; n <= highest; ++n) {
      remaining.push_back(whole(n));
      if (static_cast<std::size_t>(n) >= second_moment_.size()) continue;
      const Flexibility& kept = second_moment_[static_cast<std::size_t>(n)];
      remaining.back() = remaining.back() - kept;
    }
    return remaining;
  }

  /// Δt for which Δt² Σ_kept radial² is a share of the radial compliance that is left, in the worst order.
  /// @param whole flexibility of all modes of an order
  template <typename Whole>
  [[nodiscard]] double stable_step(double share, Whole whole) const {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < compliance_.size(); ++n) {
      const double residual = whole(static_cast<int>(n)).radial - compliance_[n].radial;
      if (radial_[n] > 0.0) smallest = std::min(smallest, share * residual / radial_[n]);
    }
    return std::sqrt(smallest);
  }

 private:
  static void add(Flexibility& sum, const Mode& mode, double weight) {
    sum.radial += weight * mode.radial * mode.radial;
    sum.mixed += weight * mode.radial * mode.tangential;
    sum.tangential += weight * mode.tangential * mode.tangential;
  }

  std::vector<double> radial_;  // Σ_kept radial², by order
  std::vector<Flexibility> compliance_, second_moment_;
};

/// What is summed over the orders for a response between contact points: coefficients of the orders 0, 1, 2, … and,
/// where `with_static`, the static flexibilities of all orders.
struct OrderSum {
  double poisson = 0.0;
  bool with_static = false;
  std::vector<Flexibility> coefficients;
};

/// Static response of the modes of a disk or a sphere that are not kept, between contact points.
/// @tparam Shape tells the two apart: its static_flexibility and static_second_moment of an order, its `sum` over the
///               orders, its stable_share, its mass, and its Loads, what forces at points are to each order in turn
template <typename Shape>
class Residual {
 public:
  /// @param kept   modes, sorted by order
  /// @param excess of its static response, over that of a plain disk or sphere
  Residual(double poisson, double cutoff, const std::vector<Mode>& kept, OrderExcess excess = {})
      : poisson_(poisson), highest_order_(highest_order(cutoff, excess)), excess_(std::move(excess)), kept_(kept) {}

  /// Highest order that counts in the second moment.
  [[nodiscard]] static int highest_order(double cutoff, const OrderExcess& excess) {
    return std::max(static_cast<int>(std::lround(8.0 * cutoff)), static_cast<int>(excess.second_moment.size()) - 1);
  }

  /// W_ij: the sum of R_n = Σ_{not kept} (radial, tangential)(radial, tangential)ᵀ/ω².
  [[nodiscard]] std::vector<double> compliance(const ContactPoints& points, const Poll& poll = {}) const {
    return Shape::sum({poisson_, true, kept_.missing_compliance(excess_)}, points, poll);
  }

  /// V_ij: the same with ω⁴ for ω². Orders that follow any force that the time steps can resolve are left out.
  [[nodiscard]] std::vector<double> second_moment(const ContactPoints& points, const Poll& poll = {}) const {
    const auto whole = [this](int n) {
      return Shape::static_second_moment(poisson_, n) + OrderExcess::at(excess_.second_moment, n);
    };
    return Shape::sum({poisson_, false, kept_.remaining_second_moment(highest_order_, whole)}, points, poll);
  }

  /// Σ_n (−1)^n R_n between points here and at the opposite face: smooth, as no force acts where it is asked for, so
  /// that the sum, faded out over its last half, has no error that counts from some orders above the kept ones on.
  [[nodiscard]] std::vector<double> opposite_compliance(const ContactPoints& here, const ContactPoints& there) const {
    constexpr int enough = 128;
    const int orders = std::max({enough, 3 * kept_.orders(), static_cast<int>(excess_.compliance.size())});
    typename Shape::Loads mine(here), others(there);
    std::vector<double> sum(here.count * there.count);
    // Several orders at a time, so that each element of the sum is taken up once for them.
    constexpr std::size_t block = 8, rows = 2 * block;
    std::vector<double> push(rows * here.count);    // of each of mine
    std::vector<double> moved(rows * there.count);  // the others, by each order radially and tangentially
    for (int first = 0; first < orders; first += static_cast<int>(block)) {
      for (std::size_t b = 0; b < block; ++b, mine.advance(), others.advance()) {
        const int n = first + static_cast<int>(b);
        const Flexibility r = n < orders ? opposite_share(n, orders) : Flexibility{};
        for (std::size_t i = 0; i < here.count; ++i) {
          const double radial = mine.radial(i), tangential = mine.tangential(i);
          push[i * rows + 2 * b] = r.radial * radial + r.mixed * tangential;
          push[i * rows + 2 * b + 1] = r.mixed * radial + r.tangential * tangential;
        }
        for (std::size_t j = 0; j < there.count; ++j) {
          moved[2 * b * there.count + j] = others.radial(j);
          moved[(2 * b + 1) * there.count + j] = others.tangential(j);
        }
      }
      for (std::size_t i = 0; i < here.count; ++i) {
        numeric::kernels::add_transposed(moved.data(), there.count, rows, there.count, push.data() + i * rows,
                                         sum.data() + i * there.count);
      }
    }
    for (double& each : sum) each /= Shape::mass;
    return sum;
  }

  /// Δt for which Δt² Σ_kept radial² is a share of the radial R_n in the worst order.
  [[nodiscard]] double stable_step() const {
    return kept_.stable_step(Shape::stable_share, [this](int n) { return static_flexibility(n); });
  }

 private:
  /// (−1)^n R_n, faded out over the last half of some orders.
  [[nodiscard]] Flexibility opposite_share(int n, int orders) const {
    Flexibility r = static_flexibility(n);
    if (n < kept_.orders()) r = r - kept_.compliance(n);
    const double late = std::max(0.0, 2.0 * n / orders - 1.0);
    const double weight = (n % 2 == 0 ? 1.0 : -1.0) * std::pow(std::cos(0.5 * std::numbers::pi * late), 2);
    return {weight * r.radial, weight * r.mixed, weight * r.tangential};
  }

  [[nodiscard]] Flexibility static_flexibility(int n) const {
    return Shape::static_flexibility(poisson_, n) + OrderExcess::at(excess_.compliance, n);
  }

  double poisson_;
  int highest_order_;  // in the second moment
  OrderExcess excess_;
  KeptSums kept_;
};

}  // namespace stoss::bodies
