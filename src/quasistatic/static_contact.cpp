#include "stoss/quasistatic/static_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "bodies/disk/residual.hpp"
#include "check.hpp"
#include "contact/complementarity.hpp"
#include "stoss/errors.hpp"

namespace stoss::quasistatic {
namespace {

constexpr double mass = std::numbers::pi;

/// Angle at which the pressure vanishes. Over the inner part of the contact its square is nearly a
/// parabola in φ²; the last nodes, whose distance from the end is comparable with h, are left out.
double end_of_contact(const StaticContact& contact) {
  const auto count = static_cast<std::size_t>(contact.contact_nodes);
  const double outermost = static_cast<double>(count) * contact.spacing;
  if (count < 8) return outermost;
  const std::size_t left_out = count / 16 + 2;
  const std::size_t last = count - left_out;
  const std::array<std::size_t, 3> samples{last - last / 3, last - last / 6, last};
  std::array<double, 3> t{}, s{};
  for (std::size_t k = 0; k < 3; ++k) {
    t[k] = contact.position[samples[k]] * contact.position[samples[k]];
    s[k] = contact.pressure[samples[k]] * contact.pressure[samples[k]];
  }
  // Newton's form through the samples, from the outermost: s₂ + (t − t₂)(b + c(t − t₁)) = 0.
  const double b = (s[2] - s[1]) / (t[2] - t[1]);
  const double c = (b - (s[1] - s[0]) / (t[1] - t[0])) / (t[2] - t[0]);
  double root = outermost * outermost;
  for (int step = 0; step < 8; ++step) {
    const double value = s[2] + (root - t[2]) * (b + c * (root - t[1]));
    const double slope = b + c * (2.0 * root - t[1] - t[2]);
    root -= value / slope;
  }
  const double end = std::sqrt(root);
  return std::abs(end - outermost) < contact.spacing ? end : outermost;
}

/// The contact on nodes of a given spacing that cover a half-width.
StaticContact on_nodes(const bodies::disk::Residual& disk, double poisson, double compression, double spacing,
                       int nodes, const Poll& poll) {
  StaticContact result;
  result.poisson = poisson;
  result.compression = compression;
  // A whole number of spacings in the half circle: the compliance of the grid is a sum of harmonics.
  result.spacing = std::numbers::pi / std::round(std::numbers::pi / spacing);
  const auto count = static_cast<std::size_t>(nodes);
  const ContactPoints points{1.0, result.spacing, count};
  std::vector<double> approach(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double phi = points.angle(i);
    result.position.push_back(phi);
    approach[i] = compression - 2.0 * std::sin(0.5 * phi) * std::sin(0.5 * phi);
  }
  Complementarity problem(disk.compliance(points, poll), count, poll);
  std::vector<double> force(count), displacement(count);
  problem.solve(approach, force, displacement);
  if (problem.extent() == count) throw NotConverged("static contact: the contact outgrew its grid (use fewer nodes)");
  for (std::size_t i = 0; i < count; ++i) {
    result.force += force[i] / mass;
    result.energy += 0.5 * force[i] * displacement[i] / mass;
    result.pressure.push_back(0.5 * force[i] / result.spacing);
  }
  result.contact_nodes = static_cast<int>(problem.extent());
  result.half_width = end_of_contact(result);
  return result;
}

}  // namespace

StaticContact static_contact(double poisson, double compression, const StaticContactOptions& options) {
  require_poisson(poisson);
  require("compression", compression, {1e-12, 0.5, true, true, "1e-12 to 0.5"},
          "R + x0 in R; small-strain elasticity means little from about 0.1 on");
  require("nodes", static_cast<long>(options.nodes), 16, 1024, "on half of the contact; 160 is usual");
  // No mode is kept: all of them answer statically.
  const bodies::disk::Residual disk(poisson, 1.0, {});
  // The undeformed edge would pass the wall as far as √(2δ). From there the grid closes in on the contact.
  constexpr int first_nodes = 64;
  constexpr double margin = 1.25;
  double half_width = std::sqrt(2.0 * compression);
  half_width = on_nodes(disk, poisson, compression, half_width / first_nodes, static_cast<int>(margin * first_nodes),
                        options.poll)
                   .half_width;
  const auto refined = [&](int nodes) {
    const int covering = static_cast<int>(std::lround(margin * nodes)) + 2;
    return on_nodes(disk, poisson, compression, half_width / nodes, covering, options.poll);
  };
  const StaticContact coarse = refined(options.nodes / 2);
  half_width = coarse.half_width;
  StaticContact result = refined(options.nodes);
  // The error depends a little on where the contact ends between two nodes: the change can be small by chance.
  const double usual = 0.2 * result.force / (static_cast<double>(options.nodes) * options.nodes);
  result.force_error = std::max(std::abs(result.force - coarse.force), usual);
  return result;
}

}  // namespace stoss::quasistatic
