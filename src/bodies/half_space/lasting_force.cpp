#include "bodies/half_space/lasting_force.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "numeric/quadrature.hpp"

namespace stoss::bodies::half_space {
namespace {

constexpr double half_turn = 0.5 * std::numbers::pi;

/// P₀ … P_n at x.
template <std::size_t n>
std::array<double, n> legendre(double x) {
  std::array<double, n> its{1.0, x};
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const auto degree = static_cast<double>(k);
    its[k + 1] = ((2.0 * degree + 1.0) * x * its[k] - degree * its[k - 1]) / (degree + 1.0);
  }
  return its;
}

}  // namespace

LastingForce::LastingForce(const PointForce& answer, double latest, const Poll& poll) {
  std::vector<double> ends;
  for (const double arrival : answer.arrivals()) ends.push_back(std::min(arrival, latest));
  ends.push_back(latest);
  constexpr double accuracy = 1e-8;
  const Displaced rest = answer.at_rest();
  accuracy_ = accuracy * std::hypot(rest.normal, rest.radial);
  Displaced sum;
  constexpr int most_halvings = 18;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (!(ends[i + 1] > ends[i])) continue;
    Interval interval{ends[i], ends[i + 1], {}};
    add(answer, interval, 0.0, 1.0, most_halvings, sum, poll);
    intervals_.push_back(std::move(interval));
  }
}

void LastingForce::add(const PointForce& answer, Interval& interval, double begin, double end, int halvings,
                       Displaced& sum, const Poll& poll) {
  if (poll) poll();
  const auto& rule = numeric::gauss_legendre(terms);
  const double half = 0.5 * (end - begin), length = interval.end - interval.begin;
  std::array<double, terms> normal{}, radial{};
  for (std::size_t i = 0; i < terms; ++i) {
    const double s = begin + half * (1.0 + rule.node[i]), sine = std::sin(half_turn * s);
    const double rate = length * half_turn * std::sin(2.0 * half_turn * s) * half;  // dτ over that of the panel
    const Displaced here = answer.at(interval.begin + length * sine * sine);
    const auto shapes = legendre<terms>(rule.node[i]);
    for (std::size_t k = 0; k < terms; ++k) {
      const double weight = (static_cast<double>(k) + 0.5) * rule.weight[i] * shapes[k] * rate;
      normal[k] += weight * here.normal;
      radial[k] += weight * here.radial;
    }
  }
  double last = 0.0;
  for (std::size_t k = terms - 3; k < terms; ++k) last = std::max({last, std::abs(normal[k]), std::abs(radial[k])});
  if (last > accuracy_ * length * half && halvings > 0) {
    const double middle = begin + half;
    add(answer, interval, begin, middle, halvings - 1, sum, poll);
    add(answer, interval, middle, end, halvings - 1, sum, poll);
    return;
  }
  // ∫P_k = (P_{k+1} − P_{k−1})/(2k + 1), from −1 on.
  Panel panel{begin, end, sum, {}, {}};
  const auto integrate = [](const std::array<double, terms>& of, std::array<double, terms + 1>& to) {
    to[0] = to[1] = of[0];
    for (std::size_t k = 1; k < terms; ++k) {
      const double part = of[k] / (2.0 * static_cast<double>(k) + 1.0);
      to[k + 1] += part;
      to[k - 1] -= part;
    }
    return 2.0 * of[0];
  };
  sum.normal += integrate(normal, panel.normal);
  sum.radial += integrate(radial, panel.radial);
  interval.panels.push_back(panel);
}

Displaced LastingForce::until(double time) const {
  const auto after = std::upper_bound(intervals_.begin(), intervals_.end(), time,
                                      [](double at, const Interval& its) { return at < its.begin; });
  if (after == intervals_.begin()) return {};
  const Interval& its = *(after - 1);
  const double share = std::clamp((time - its.begin) / (its.end - its.begin), 0.0, 1.0);
  const double s = std::asin(std::sqrt(share)) / half_turn;
  const auto next = std::upper_bound(its.panels.begin(), its.panels.end(), s,
                                     [](double at, const Panel& panel) { return at < panel.begin; });
  const Panel& panel = *(next - 1);
  const auto shapes = legendre<terms + 1>(2.0 * (s - panel.begin) / (panel.end - panel.begin) - 1.0);
  Displaced sum = panel.before;
  for (std::size_t k = 0; k <= terms; ++k) {
    sum.normal += panel.normal[k] * shapes[k];
    sum.radial += panel.radial[k] * shapes[k];
  }
  return sum;
}

Displaced LastingForce::twice(double begin, double end, const Displaced& before) const {
  const auto& rule = numeric::gauss_legendre(6);
  Displaced sum;
  const auto add = [&](double time, double weight) {
    const Displaced its = until(time);
    sum.normal += weight * (its.normal - before.normal), sum.radial += weight * (its.radial - before.radial);
  };
  const auto next = std::upper_bound(intervals_.begin(), intervals_.end(), begin,
                                     [](double at, const Interval& its) { return at < its.begin; });
  if (next == intervals_.end() || next->begin >= end) {
    const double half = 0.5 * (end - begin);
    for (std::size_t k = 0; k < rule.node.size(); ++k) add(begin + half * (1.0 + rule.node[k]), half * rule.weight[k]);
    return sum;
  }
  // To both sides of an arrival in the root of the time, in which its pole is smooth.
  for (const double side : {next->begin - begin, next->begin - end}) {
    for (std::size_t k = 0; k < rule.node.size(); ++k) {
      const double u = 0.5 * (1.0 + rule.node[k]);
      add(next->begin - side * u * u, std::abs(side) * u * rule.weight[k]);
    }
  }
  return sum;
}

std::vector<LastingForce::Step> LastingForce::over_steps(double step, std::size_t count) const {
  std::vector<Step> all(count);
  Displaced before;
  for (std::size_t i = 0; i < count; ++i) {
    const double begin = step * static_cast<double>(i), end = step * static_cast<double>(i + 1);
    if (intervals_.empty() || end <= intervals_.front().begin) continue;
    const Displaced now = until(end), twice_integrated = twice(begin, end, before);
    Step& its = all[i];
    its.whole = {now.normal - before.normal, now.radial - before.radial};
    its.moment = {0.5 * step * its.whole.normal - twice_integrated.normal,
                  0.5 * step * its.whole.radial - twice_integrated.radial};
    before = now;
  }
  return all;
}

}  // namespace stoss::bodies::half_space
