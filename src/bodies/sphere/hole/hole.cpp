// Which degrees of a sphere see a hole in it, and what it changes of them.
#include "bodies/sphere/hole/hole.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <mutex>

#include "bodies/mode_search.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "bodies/sphere/hole/radial_shell.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "check.hpp"
#include "stoss/bodies/hollow_sphere.hpp"

namespace stoss::bodies::sphere {
namespace {

/// How far a wave of the wave number κ′ and a degree falls from where it begins to fall inward to a radius: the
/// logarithm of j_n by its turning point (WKB), that of r^(n−½) for κ′ = 0.
double fall(double degree, double wave_number, double radius) {
  const double order = std::max(1.5, degree - 0.5);
  const auto from_turning = [order](double x) {
    return x < order ? order * std::acosh(order / x) - std::sqrt(order * order - x * x) : 0.0;
  };
  if (wave_number < 1e-9 * order) return -order * std::log(radius);
  return from_turning(wave_number * radius) - from_turning(wave_number);
}

/// Whether the square of that is below rounding.
bool is_hidden(double degree, double wave_number, double radius) {
  constexpr double rounding = 20.0;
  return fall(degree, wave_number, radius) > rounding;
}

/// The first degree that does not see the hole.
int first_hidden(double wave_number, double radius) {
  int degree = 0;
  while (!is_hidden(degree, wave_number, radius)) ++degree;
  return degree;
}

/// Modes of the degrees from `first` on: of those that see the hole by `shell`, of all others by `solid`. Above the
/// degrees of surface waves of a solid sphere the frequencies of a shell rise with the degree, so that one without
/// modes ends the list.
template <typename ShellModes, typename SolidModes>
auto modes_with_hole(int first, int solid_degrees, int hidden, const Poll& poll, ShellModes shell, SolidModes solid) {
  auto modes = shell(first);
  for (int n = first + 1; n < hidden; ++n) {
    if (poll) poll();
    const auto found = shell(n);
    if (found.empty() && n > solid_degrees) return modes;
    modes.insert(modes.end(), found.begin(), found.end());
  }
  if (hidden > solid_degrees) return modes;
  for (const auto& mode : solid()) {
    if (mode.order >= hidden) modes.push_back(mode);
  }
  return modes;
}

}  // namespace

struct Hole::Answers {
  double poisson;
  std::once_flag once, toroidal_once;
  OrderExcess excess;
  Toroidal toroidal;
};

Hole::Hole(double poisson, double inner) : inner_(inner) {
  if (!is_hidden(0, 0.0, inner)) answers_ = std::make_shared<Answers>(), answers_->poisson = poisson;
}

std::vector<Mode> Hole::modes(double poisson, double cutoff, const Poll& poll) const {
  if (!answers_) return checked_modes(poisson, cutoff, poll);
  const double wave_number = cutoff / wave_speeds(poisson).shear;
  const int hidden = first_hidden(wave_number, inner_), solid = degrees_below(poisson, cutoff);
  const RadialShell shell(poisson, inner_, cutoff, std::min(hidden, 2 * solid));
  return modes_with_hole(
      0, solid, hidden, poll, [&](int n) { return shell.modes(n, cutoff); },
      [&] { return checked_modes(poisson, cutoff, poll); });
}

std::vector<ToroidalMode> Hole::toroidal_modes(double poisson, double cutoff, const Poll& poll) const {
  if (!answers_) return sphere::toroidal_modes(poisson, cutoff, poll);
  const double wave_number = cutoff / wave_speeds(poisson).shear;
  const int hidden = first_hidden(wave_number, inner_), solid = static_cast<int>(std::ceil(wave_number)) + 2;
  const RadialShell shell(poisson, inner_, cutoff, std::min(hidden, solid));
  return modes_with_hole(
      1, solid, hidden, poll, [&](int n) { return shell.toroidal_modes(n, cutoff); },
      [&] { return sphere::toroidal_modes(poisson, cutoff, poll); });
}

std::vector<Mode> hollow_modes(double poisson, double inner, double cutoff, const Poll& poll) {
  require_poisson(poisson);
  require_inner(inner);
  if (inner == 0.0) return sphere::modes(poisson, cutoff, poll);
  constexpr Range allowed{0.0, max_hollow_cutoff, false, true, "above 0 to 400"};
  require("cutoff", cutoff, allowed, "highest frequency in c/R; 25 to 100 is usual");
  const Hole hole(poisson, inner);
  auto modes = hole.modes(poisson, cutoff, poll);
  constexpr double above_the_lowest = 3.0;
  if (modes.empty()) refuse_low_cutoff(hole.modes(poisson, above_the_lowest, poll), cutoff, max_hollow_cutoff);
  return modes;
}

const OrderExcess& Hole::excess(const Poll& poll) const {
  static const OrderExcess none;
  if (!answers_) return none;
  std::call_once(answers_->once, [&] {
    const double poisson = answers_->poisson;
    const int hidden = first_hidden(0.0, inner_);
    const RadialShell shell(poisson, inner_, 0.0, hidden);
    OrderExcess found;
    for (int n = 0; n < hidden; ++n) {
      if (poll) poll();
      const RadialShell::Response its = shell.response(n);
      found.compliance.push_back(its.compliance - static_flexibility(poisson, n));
      found.second_moment.push_back(its.second_moment - static_second_moment(poisson, n));
    }
    answers_->excess = std::move(found);
  });
  return answers_->excess;
}

const Hole::Toroidal& Hole::toroidal_excess(const Poll& poll) const {
  static const Toroidal none;
  if (!answers_) return none;
  std::call_once(answers_->toroidal_once, [&] {
    const double poisson = answers_->poisson;
    const int hidden = first_hidden(0.0, inner_);
    const RadialShell shell(poisson, inner_, 0.0, hidden);
    Toroidal found{{0.0}, {0.0}};
    for (int n = 1; n < hidden; ++n) {
      if (poll) poll();
      const RadialShell::ToroidalResponse its = shell.toroidal_response(n);
      found.compliance.push_back(its.compliance - toroidal_flexibility(poisson, n));
      found.second_moment.push_back(its.second_moment - toroidal_second_moment(poisson, n));
    }
    answers_->toroidal = std::move(found);
  });
  return answers_->toroidal;
}

}  // namespace stoss::bodies::sphere
