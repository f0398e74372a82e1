// Springs at x of the elongation u = δ − x², with the force f = ∫E du from where they touch, t₁(x), and
//
//   δ̈ = −F,   F = (3/2)∫f dx,   δ(t₁) = x²
//
//   way in    F = ∫₀ᵗ E(t − t′) dδ^{3/2}
//   way out   f(b) = 0 at the edge b,   F = ∫₀^{t₁(b)} E(t − t′) dδ^{3/2} + (3/2) b f(b)
//
// The last term is 0; with it an error of b enters F in its square alone. What has let go stays free: it creeps back
// ever more slowly, as Σ U e^(−rt) with U > 0, while the ball leaves ever faster. In each step δ̈ is a polynomial of its
// values at Gauss' nodes, found by iteration, and what is remembered of it is exact.
#include "quasistatic/relaxing_motion.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "quasistatic/fading.hpp"
#include "stoss/errors.hpp"

namespace stoss::quasistatic {
namespace {

/// A step of the motion, and what is remembered at its start.
struct Piece {
  double start = 0.0, half = 0.0;
  double first_place = 0.0, first_speed = 1.0;
  Memories of_speed, of_growth;
  Polynomial place{}, speed{}, growth{}, force{};  ///< growth is the rate of δ^{3/2}
  double growth_tail = 0.0;

  [[nodiscard]] double end() const { return start + 2.0 * half; }
  [[nodiscard]] double at(double time) const { return (time - start) / half - 1.0; }

  void push(const Polynomial& its_force) {
    force = its_force;
    speed = integral_of(force, -half, first_speed);
    place = integral_of(speed, half, first_place);
  }
};

/// Where a function that falls from above 0 vanishes.
template <typename Function>
double falls_through(Function function, double low, double high) {
  for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high)) {
    (function(middle) > 0.0 ? low : high) = middle;
  }
  return low;
}

/// Finds the polynomial of the force in a step. @param law the force at the nodes of a piece that moves
/// @return the error of the speed, 1 where the iteration does not end
template <typename Law>
double solve(Piece& piece, double first_force, Law law) {
  AtNodes force;
  force.fill(first_force);
  constexpr int most = 40;
  double change = 1.0, before = 2.0;
  for (int i = 0; i < most && (change > 1e-17 && (change > 1e-14 || change < 0.5 * before)); ++i) {
    piece.push(interpolate(force).polynomial);
    const AtNodes next = law(piece);
    before = std::exchange(change, 0.0);
    for (std::size_t k = 0; k < piece_nodes; ++k) {
      change = std::max(change, piece.half * std::abs(next[k] - force[k]));
    }
    if (!(change < 10.0 * before)) break;
    force = next;
  }
  const Interpolant last = interpolate(force);
  piece.push(last.polynomial);
  return change > 1e-14 ? 1.0 : piece.half * last.tail;
}

/// The course of an impact.
class Course {
 public:
  Course(const Rates& rates, double error) : rates_(rates), allowed_error_(error) {}

  RelaxingMotion motion() {
    RelaxingMotion result = way_in();
    way_out(result);
    return result;
  }

 private:
  /// Advances `piece` by steps, until `ended` says so at the end of one.
  template <typename Law, typename Ended>
  void advance(Piece piece, double first_half, double force, Law law, Ended ended) {
    constexpr int most = 20000;
    constexpr double longest = 1.0;
    double half = first_half;
    for (int i = 0; i < most; ++i) {
      piece.half = half;
      const double error = std::max(solve(piece, force, law), piece.growth_tail * half);
      const double factor = 0.9 * std::pow(allowed_error_ / std::max(error, 1e-30), 1.0 / 13.0);
      if (error > allowed_error_ && half > 1e-14 * piece.end()) {
        half *= std::clamp(factor, 0.1, 0.6);
        continue;
      }
      half = std::min(longest, half * std::clamp(factor, 0.6, 2.0));
      if (ended(piece)) return;
      force = value_of(piece.force, 1.0);
      remember(rates_, piece.of_speed, piece.speed, piece.half, 1.0, memories_);
      std::swap(piece.of_speed, memories_);
      remember(rates_, piece.of_growth, piece.growth, piece.half, 1.0, memories_);
      std::swap(piece.of_growth, memories_);
      const double place = value_of(piece.place, 1.0), speed = value_of(piece.speed, 1.0);
      piece.start = piece.end(), piece.first_place = place, piece.first_speed = speed;
    }
    throw NotConverged(
        "quasistatic: the bodies did not separate within the steps that are computed (does too much relax?)");
  }

  /// Until the ball stands still.
  RelaxingMotion way_in() {
    Piece piece;
    piece.of_speed.assign(rates_.rate.size(), 0.0);
    piece.of_growth = piece.of_speed;
    const auto law = [this](Piece& its) {
      AtNodes force{}, growth{}, elastic{};
      for (std::size_t i = 0; i < piece_nodes; ++i) {
        const double x = node_places()[i], place = std::max(value_of(its.place, x), 0.0);
        growth[i] = 1.5 * std::sqrt(place) * value_of(its.speed, x);
        elastic[i] = place * std::sqrt(place);
      }
      const Interpolant grows = interpolate(growth);
      its.growth = grows.polynomial;
      its.growth_tail = rates_.rate.empty() ? 0.0 : grows.tail;
      for (std::size_t i = 0; i < piece_nodes; ++i) {
        remember(rates_, its.of_growth, its.growth, its.half, node_places()[i], memories_);
        force[i] = relaxed_force(rates_, elastic[i], memories_);
      }
      return force;
    };
    advance(piece, 1e-8, 0.0, law, [this](const Piece& its) {
      pieces_.push_back(its);
      return value_of(its.speed, 1.0) <= 0.0;
    });
    const Piece& last = pieces_.back();
    const double x = falls_through([&last](double at) { return value_of(last.speed, at); }, -1.0, 1.0);
    turn_ = last.start + last.half * (1.0 + x);
    RelaxingMotion result{.max_compression = value_of(last.place, x)};
    for (const Piece& its : pieces_) {  // the force is greatest before the turn
      const double end = &its == &last ? x : 1.0;
      const auto least = [&its](double at) { return -value_of(its.force, at); };
      const double inside = -boost::math::tools::brent_find_minima(least, -1.0, end, 40).second;
      result.max_force = std::max({result.max_force, inside, -least(end)});
    }
    return result;
  }

  /// What the springs at a place of the edge have: f there, E(t − t₁), and the force with t₁ in the head of this file.
  struct Edge {
    double force, modulus, speed, total;
  };

  Edge edge(double touched, double now, double whole) {
    auto piece = std::upper_bound(pieces_.begin(), pieces_.end(), touched,
                                  [](double time, const Piece& its) { return time < its.start; });
    --piece;
    const double x = piece->at(touched), then = std::max(value_of(piece->place, x), 0.0), width = std::sqrt(then);
    remember(rates_, piece->of_speed, piece->speed, piece->half, x, memories_);
    remember(rates_, piece->of_growth, piece->growth, piece->half, x, growths_);
    Edge result{whole - rates_.relaxed * then, rates_.relaxed, value_of(piece->speed, x),
                rates_.relaxed * then * width};
    for (std::size_t j = 0; j < memories_.size(); ++j) {
      const double left = rates_.share[j] * std::exp(-rates_.rate[j] * (now - touched));
      result.force -= left * memories_[j];
      result.modulus += left;
      result.total += left * growths_[j];
    }
    result.total += 1.5 * width * result.force;
    return result;
  }

  /// The force on the way out. @param whole f in the middle, above 0 @param touched a guess of t₁, and then it
  double opening_force(double now, double whole, double& touched) {
    double low = 0.0, high = turn_;
    if (!(touched > low && touched < high)) touched = 0.5 * (low + high);
    while (true) {
      const Edge its = edge(touched, now, whole);
      (its.force > 0.0 ? low : high) = touched;
      const double step = its.force / (its.modulus * its.speed);
      // F misses (3/2) f db at most, where 2b db = δ̇ dt₁
      if (std::abs(its.force * step * its.speed) < 1e-18 || !(low < 0.5 * (low + high) && 0.5 * (low + high) < high)) {
        return its.total;
      }
      touched = touched + step > low && touched + step < high ? touched + step : 0.5 * (low + high);
    }
  }

  /// Until the force in the middle is 0.
  void way_out(RelaxingMotion& result) {
    const Piece& last = pieces_.back();
    Piece piece;
    piece.start = turn_, piece.first_place = result.max_compression, piece.first_speed = 0.0;
    remember(rates_, last.of_speed, last.speed, last.half, last.at(turn_), piece.of_speed);
    piece.of_growth.assign(rates_.rate.size(), 0.0);
    AtNodes touched{};
    double started = -1.0, half = 0.0;
    const auto middle = [this](const Piece& its, double x) {
      remember(rates_, its.of_speed, its.speed, its.half, x, memories_);
      return relaxed_force(rates_, value_of(its.place, x), memories_);
    };
    const auto law = [&](Piece& its) {
      if (its.start != started || its.half != half) {
        started = its.start, half = its.half;
        for (std::size_t i = 0; i < piece_nodes; ++i) {
          touched[i] = std::max(0.0, 2.0 * turn_ - its.start - its.half * (1.0 + node_places()[i]));
        }
      }
      AtNodes force{};
      for (std::size_t i = 0; i < piece_nodes; ++i) {
        const double x = node_places()[i], whole = middle(its, x);
        if (whole > 0.0) force[i] = opening_force(its.start + its.half * (1.0 + x), whole, touched[i]);
      }
      return force;
    };
    advance(piece, 1e-8, value_of(last.force, last.at(turn_)), law, [&](const Piece& its) {
      if (middle(its, 1.0) > 0.0) return false;
      const double x = falls_through([&](double at) { return middle(its, at); }, -1.0, 1.0);
      result.contact_time = its.start + its.half * (1.0 + x);
      result.restitution = -value_of(its.speed, 1.0);
      return true;
    });
  }

  const Rates& rates_;
  double allowed_error_;
  std::vector<Piece> pieces_;
  double turn_ = 0.0;
  Memories memories_, growths_;
};

}  // namespace

RelaxingMotion relaxing_motion(const Rates& rates, double error) { return Course(rates, error).motion(); }

}  // namespace stoss::quasistatic
