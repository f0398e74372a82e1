#include "relaxation/zeros.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace stoss {

namespace {

constexpr double least_relaxed = 1e-12;

/// Closer rates differ by less than their square.
void add_term(double rate, double share, Rates& rates) {
  constexpr double same = 1e-9;
  if (rates.rate.empty() || rate > (1.0 + same) * rates.rate.back()) {
    rates.rate.push_back(rate);
    rates.share.push_back(share);
    return;
  }
  const double sum = rates.share.back() + share;
  rates.rate.back() += share / sum * (rate - rates.rate.back());
  rates.share.back() = sum;
}

}  // namespace

Rates::Rates(const Relaxation& relaxation) : relaxed(std::max(relaxation.relaxed(), least_relaxed)) {
  std::vector<std::pair<double, double>> sorted;
  for (const RelaxationTerm& term : relaxation.terms) sorted.emplace_back(1.0 / term.time, term.share);
  std::sort(sorted.begin(), sorted.end());
  for (const auto& [its_rate, its_share] : sorted) add_term(its_rate, its_share, *this);
}

MixedRates::MixedRates(const std::vector<MaterialLoss>& layers, double unit) {
  for (std::size_t l = 0; l < layers.size(); ++l) {
    const Rates own(in_time(layers[l].relaxation, unit));
    for (std::size_t j = 0; j < own.rate.size(); ++j) terms_.push_back({own.rate[j], l, own.share[j]});
    relaxed_.push_back(own.relaxed);
    viscous_.push_back(layers[l].loss_time * unit);
  }
  std::sort(terms_.begin(), terms_.end(), [](const Term& a, const Term& b) { return a.rate < b.rate; });
}

Rates MixedRates::of(const double* weight) const {
  constexpr double negligible = 1e-14;  // beside what is left of all moduli
  Rates mixed;
  mixed.relaxed = 0.0;
  for (std::size_t l = 0; l < relaxed_.size(); ++l) {
    mixed.relaxed += weight[l] * relaxed_[l];
    mixed.viscous += weight[l] * viscous_[l];
  }
  for (const auto& [rate, layer, share] : terms_) {
    const double its = weight[layer] * share;
    if (its > negligible * mixed.relaxed) add_term(rate, its, mixed);
  }
  return mixed;
}

namespace {

/// A point of the interval between two poles, or 0 and the first, by its distance from the nearer end.
struct Place {
  double rate;
  double down;  ///< above the lower end
  double up;    ///< below the upper end
};

/// The interval below κ_j.
class Interval {
 public:
  Interval(const Rates& rates, double inertia, std::size_t upper)
      : rates_(rates), inertia_(inertia), upper_(upper), low_(upper == 0 ? 0.0 : rates.rate[upper - 1]) {}

  [[nodiscard]] double width() const { return rates_.rate[upper_] - low_; }
  [[nodiscard]] Place from_low(double distance) const { return {low_ + distance, distance, width() - distance}; }
  [[nodiscard]] Place from_high(double distance) const {
    return {rates_.rate[upper_] - distance, width() - distance, distance};
  }

  /// M(s) + s² inertia at s = −rate times both distances (of the first interval, that from the pole): it has no poles.
  [[nodiscard]] double value(const Place& at) const {
    double rest = (inertia_ * at.rate - rates_.viscous) * at.rate + rates_.relaxed;
    for (std::size_t i = 0; i < rates_.rate.size(); ++i) {
      if (i != upper_ && i + 1 != upper_) rest -= at.rate * rates_.share[i] / difference(i, at);
    }
    const double near = at.up * rest - at.rate * rates_.share[upper_];
    return upper_ == 0 ? near : at.down * near + at.up * at.rate * rates_.share[upper_ - 1];
  }

  /// About how far below κ_j its term is as large as E(0).
  [[nodiscard]] double balance() const { return rates_.share[upper_] * rates_.rate[upper_]; }

  [[nodiscard]] double slope(const Place& at) const {
    double sum = rates_.viscous;
    for (std::size_t i = 0; i < rates_.rate.size(); ++i) {
      const double apart = difference(i, at);
      sum += rates_.share[i] * rates_.rate[i] / (apart * apart);
    }
    return sum;
  }

 private:
  /// κ_i − rate
  [[nodiscard]] double difference(std::size_t i, const Place& at) const {
    if (i == upper_) return at.up;
    if (i + 1 == upper_) return -at.down;
    return i > upper_ ? rates_.rate[i] - rates_.rate[upper_] + at.up : rates_.rate[i] - low_ - at.down;
  }

  const Rates& rates_;
  double inertia_;
  std::size_t upper_;
  double low_;
};

/// Where the pole κ_j of a weak term balances the others: by secants from it, which end after four steps or so.
std::optional<Place> zero_near_pole(const Interval& interval, double half) {
  constexpr int most_steps = 12;
  constexpr double rounding = 1e-15;
  double last = 0.0, value = interval.value(interval.from_high(0.0));
  double now = std::min(interval.balance(), 0.5 * half);
  for (int i = 0; i < most_steps; ++i) {
    const double here = interval.value(interval.from_high(now)), step = here * (now - last) / (here - value);
    last = now, value = here, now -= step;
    if (!(now > 0.0 && now < half)) return std::nullopt;
    if (std::abs(step) <= rounding * now) return interval.from_high(now);
  }
  return std::nullopt;
}

Place zero_of(const Interval& interval) {
  const double half = 0.5 * interval.width();
  const Place middle = interval.from_low(half);
  const double at_middle = interval.value(middle);
  if (at_middle == 0.0) return middle;
  const bool high = at_middle > 0.0;  // the value falls from the lower end to the upper one
  if (high) {
    if (const auto found = zero_near_pole(interval, half)) return *found;
  }
  const auto place = [&](double distance) { return high ? interval.from_high(distance) : interval.from_low(distance); };
  const auto value = [&](double distance) { return interval.value(place(distance)); };
  const double at_end = value(0.0);
  if (at_end == 0.0 || (at_end > 0.0) == (at_middle > 0.0)) return place(0.0);
  std::uintmax_t steps = 200;
  const auto [from, to] = boost::math::tools::toms748_solve(value, 0.0, half, at_end, at_middle,
                                                            boost::math::tools::eps_tolerance<double>(50), steps);
  return place(0.5 * (from + to));
}

}  // namespace

std::vector<RealZero> real_zeros(const Rates& rates, double inertia) {
  std::vector<RealZero> zeros;
  zeros.reserve(rates.rate.size());
  for (std::size_t j = 0; j < rates.rate.size(); ++j) {
    const Interval interval(rates, inertia, j);
    const Place at = zero_of(interval);
    zeros.push_back({at.rate, interval.slope(at), at.up});
  }
  return zeros;
}

double modulus_slope(const Rates& rates, double rate) {
  double sum = rates.viscous;
  for (std::size_t i = 0; i < rates.rate.size(); ++i) {
    const double apart = rates.rate[i] - rate;
    sum += rates.share[i] * rates.rate[i] / (apart * apart);
  }
  return sum;
}

}  // namespace stoss
