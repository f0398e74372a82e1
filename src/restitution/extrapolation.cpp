// The paper's two extrapolations:  1 − ε² = A_N + B/α  (figure 7),  A_N = A + C/√N  (figure 8).
//
// 1/α: at closest approach the wall holds an energy F/α. 1/√N: the modes above ω_c ∝ √N, which are left out here, would
// let the edge yield by a further 2p/(πZω_c) under a pressure p (docs/numerics.md).
#include "stoss/restitution/extrapolation.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string_view>

#include "check.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/modes.hpp"

namespace stoss {
namespace {

/// Usual values of αv/c, even in 1/α. The softest holds 4 % of the energy at closest approach, the
/// hardest 1 %. On harder ones an edge that lacks its high modes begins to bounce, because it
/// cannot answer within 1/(αv), and 1 − ε² leaves the line: from αv ≈ 100 with 300 modes, αv ≈ 200
/// with 940.
constexpr std::array<double, 4> usual_walls{25.0, 100.0 / 3.0, 50.0, 100.0};

constexpr std::array<std::size_t, 4> usual_mode_numbers{300, 400, 600, 940};

/// Neighbours closer than this do not support a line.
constexpr double least_ratio = 1.01;

std::vector<double> usual_hardnesses(double speed) {
  std::vector<double> hardnesses(usual_walls.begin(), usual_walls.end());
  for (double& hardness : hardnesses) hardness /= speed;
  return hardnesses;
}

/// Cutoffs midway between the last mode kept and the next.
std::vector<double> usual_cutoffs(double poisson, const Poll& poll) {
  // Weyl's law N = (1 + ν)(3 − ν) ω²/8 for the symmetric modes; the free edge adds some.
  const double enough = std::sqrt(8.0 * 1000.0 / ((1.0 + poisson) * (3.0 - poisson)));
  const std::vector<bodies::disk::Mode> modes = bodies::disk::modes(poisson, enough, poll);
  std::vector<double> omega(modes.size());
  std::transform(modes.begin(), modes.end(), omega.begin(), [](const bodies::disk::Mode& mode) { return mode.omega; });
  std::sort(omega.begin(), omega.end());
  assert(omega.size() > usual_mode_numbers.back());
  std::vector<double> cutoffs;
  cutoffs.reserve(usual_mode_numbers.size());
  for (const std::size_t n : usual_mode_numbers) cutoffs.push_back(0.5 * (omega[n - 1] + omega[n]));
  return cutoffs;
}

/// Checks that there are enough numbers, ascending, for a line and its error.
void require_series(std::string_view name, std::string_view number_name, const std::vector<double>& values) {
  require(number_name, static_cast<long>(values.size()), 3, 1000, "a line and its error need three points");
  double least = 0.0;
  for (const double value : values) {
    require(name, value,
            {least, std::numeric_limits<double>::max(), false, true,
             "positive numbers, each at least 1 % above the one before"},
            "give them in ascending order");
    least = least_ratio * value;
  }
}

std::vector<Body> make_bodies(double poisson, const std::vector<double>& cutoffs, const Poll& poll) {
  std::vector<Body> bodies;
  for (const double cutoff : cutoffs) {
    bodies.push_back(disk(poisson, cutoff, poll));
    if (bodies.size() < 2) continue;
    const auto before = static_cast<double>(mode_count(bodies[bodies.size() - 2]));
    require("modes", static_cast<double>(mode_count(bodies.back())),
            {before, std::numeric_limits<double>::max(), false, true, "more than the cutoff before keeps"},
            "number of modes that a cutoff keeps; spread the cutoffs");
  }
  return bodies;
}

/// Two-sided 95 % quantile of Student's t. Its fall beyond two degrees of freedom is not used: most
/// of what deviates from these lines is curvature, and further points on a curve add no independent
/// information.
double student(std::size_t degrees_of_freedom) { return degrees_of_freedom == 1 ? 12.706 : 4.303; }

/// A line through points of equal weight, at x = 0.
struct Intercept {
  Estimate at_zero;
  std::vector<double> weight;  ///< at_zero.value = Σ weight_i y_i
};

Intercept extrapolate(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  const auto count = static_cast<double>(n);
  const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / count;
  const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / count;
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  const double slope = xy / xx;
  Intercept line;
  line.at_zero.value = mean_y - slope * mean_x;
  double residual = 0.0, gain = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double deviation = y[i] - mean_y - slope * (x[i] - mean_x);
    residual += deviation * deviation;
    line.weight.push_back(1.0 / count - mean_x * (x[i] - mean_x) / xx);
    gain += line.weight[i] * line.weight[i];
  }
  line.at_zero.error = student(n - 2) * std::sqrt(residual / (count - 2.0) * gain);
  return line;
}

/// Limit of 1 − ε² for α → ∞, from the impacts of one body.
Estimate hard_limit(const std::vector<SoftImpact>& impacts, std::size_t first) {
  std::vector<double> x, y;
  for (std::size_t i = first; i < impacts.size(); ++i) {
    x.push_back(1.0 / impacts[i].hardness);
    y.push_back(impacts[i].lost_fraction);
  }
  return extrapolate(x, y).at_zero;
}

/// Limit of 1 − ε² for N → ∞. The points weigh the same: errors with two degrees of freedom are
/// themselves known to a factor of three, and 1/error² would let chance choose the points. Their
/// errors are carried into that of the intercept, in addition to its own: curvature in 1/α shifts all
/// points alike, which the scatter about the second line does not show.
Estimate complete_limit(const std::vector<Body>& bodies, const std::vector<Estimate>& hard_wall) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    x.push_back(1.0 / std::sqrt(static_cast<double>(mode_count(bodies[i]))));
    y.push_back(hard_wall[i].value);
  }
  const Intercept line = extrapolate(x, y);
  Estimate result = line.at_zero;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    result.error = std::hypot(result.error, line.weight[i] * hard_wall[i].error);
  }
  return result;
}

}  // namespace

ExtrapolatedRestitution extrapolated_restitution(double poisson, double speed, const ExtrapolationOptions& options) {
  require("speed", speed, {1e-3, 0.5, true, true, "0.001 to 0.5"},
          "speed of the centre of mass, in units of c; slower, the walls would have to be too hard");
  const auto hardnesses = options.hardnesses.empty() ? usual_hardnesses(speed) : options.hardnesses;
  require_series("hardnesses", "number of hardnesses", hardnesses);
  for (const double hardness : hardnesses) validate(ExponentialWall{hardness});
  const auto cutoffs = options.cutoffs.empty() ? usual_cutoffs(poisson, options.poll) : options.cutoffs;
  require_series("cutoffs", "number of cutoffs", cutoffs);
  const std::vector<Body> bodies = make_bodies(poisson, cutoffs, options.poll);

  const ImpactOptions impact_options{.poll = options.poll};
  ExtrapolatedRestitution result;
  for (const Body& body : bodies) {
    const std::size_t first = result.impacts.size();
    for (const double hardness : hardnesses) {
      const Impact impact = stoss::impact(body, ExponentialWall{hardness}, speed, impact_options);
      result.impacts.push_back(
          {body.cutoff, static_cast<long>(mode_count(body)), hardness, impact.lost_fraction, impact.steps});
      result.steps += impact.steps;
    }
    result.hard_wall.push_back(hard_limit(result.impacts, first));
  }
  result.lost_fraction = complete_limit(bodies, result.hard_wall);
  // Few modes and soft walls may extrapolate to more than all of the energy.
  const double value = std::sqrt(std::max(0.0, 1.0 - result.lost_fraction.value));
  const double error = result.lost_fraction.error;
  result.restitution = {value, error / (std::sqrt(value * value + error) + value)};
  return result;
}

}  // namespace stoss
