#include "stoss/quasistatic/static_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

#include "bodies/disk/order_sums.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "bodies/sphere/surface_points.hpp"
#include "check.hpp"
#include "contact/edge/compliance.hpp"
#include "stoss/errors.hpp"

namespace stoss::quasistatic {
namespace {

/// A body without inertia of its own: what a static contact needs to know of it.
struct Pressed {
  double poisson;
  double mass;
  std::function<std::vector<double>(const ContactPoints&)> compliance;  ///< of all modes
  std::function<double(const ContactPoints&, std::size_t)> measure;     ///< length of edge or area of a node
  double usual_error;                                                   ///< of the force, in 1/nodes²
};

Pressed pressed_disk(double poisson, const Poll& poll) {
  // No mode is kept: all of them answer statically.
  const bodies::disk::Residual disk(poisson, 1.0, {});
  return {poisson, std::numbers::pi,
          [disk, poll](const ContactPoints& points) { return disk.compliance(points, poll); },
          [](const ContactPoints& points, std::size_t) { return 2.0 * points.spacing; }, 0.2};
}

Pressed pressed_sphere(double poisson, const Poll& poll) {
  const bodies::sphere::Residual sphere(poisson, 1.0, {});
  return {poisson, 4.0 / 3.0 * std::numbers::pi,
          [sphere, poll](const ContactPoints& points) { return sphere.compliance(points, poll); },
          bodies::sphere::ring_area, 0.25};
}

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

/// Solves f ≥ 0, g = W f − q ≥ 0, fᵀ g = 0 where round bodies touch on the first nodes, as many as are returned: the
/// factor of a leading block of W is the leading block of that of W.
/// @throws NotConverged where they touch otherwise
std::size_t press(const FactoredCompliance& compliance, const std::vector<double>& q, std::vector<double>& force,
                  std::vector<double>& displacement) {
  const double tolerance = 1e-13 * *std::max_element(q.begin(), q.end());
  const auto at = [](std::vector<double>& values, std::size_t i) {
    return values.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::vector<double> inner(q.size());
  std::size_t count = 1;
  constexpr int max_trials = 100;
  for (int trial = 0; trial < max_trials; ++trial) {
    compliance.forward(count, q, inner);
    compliance.backward(count, inner, force);
    const auto pulls = [](double f) { return f < 0.0; };
    std::size_t pressed = count;
    while (pressed > 0 && pulls(force[pressed - 1])) --pressed;
    if (pressed == 0 || std::any_of(force.begin(), at(force, pressed), pulls)) break;
    if (pressed < count) {
      count = pressed;
      continue;
    }
    std::copy_n(q.begin(), count, displacement.begin());
    compliance.multiply(count, count, force, displacement);
    const auto passes = [&](std::size_t i) { return displacement[i] - q[i] < -tolerance; };
    const std::size_t before = count;
    while (count < q.size() && passes(count)) ++count;
    for (std::size_t i = count; i < q.size(); ++i) {
      if (passes(i)) throw NotConverged("static contact: the contact is not an interval", "nodes", "use fewer nodes");
    }
    if (count > before) continue;
    std::fill(at(force, count), force.end(), 0.0);
    return count;
  }
  throw NotConverged("static contact: no number of nodes satisfies the conditions", "nodes", "use fewer nodes");
}

/// The contact on nodes of a given spacing that cover a half-width.
StaticContact on_nodes(const Pressed& body, double compression, double spacing, int nodes, const Poll& poll) {
  StaticContact result;
  result.poisson = body.poisson;
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
  const FactoredCompliance compliance(body.compliance(points), count, poll);
  std::vector<double> force(count), displacement(count);
  const std::size_t touching = press(compliance, approach, force, displacement);
  if (touching == count) throw NotConverged("static contact: the contact outgrew its grid", "nodes", "use fewer nodes");
  for (std::size_t i = 0; i < count; ++i) {
    result.force += force[i] / body.mass;
    result.energy += 0.5 * force[i] * displacement[i] / body.mass;
    result.pressure.push_back(force[i] / body.measure(points, i));
  }
  result.contact_nodes = static_cast<int>(touching);
  result.half_width = end_of_contact(result);
  return result;
}

StaticContact pressed(const Pressed& body, double compression, const StaticContactOptions& options) {
  require("compression", compression, {1e-12, 0.5, true, true, "1e-12 to 0.5"},
          "R + x0 in R; small-strain elasticity means little from about 0.1 on");
  require("nodes", static_cast<long>(options.nodes), 16, 1024, "on half of the contact; 160 is usual");
  // The undeformed edge would pass the wall as far as √(2δ). From there the grid closes in on the contact.
  constexpr int first_nodes = 64;
  constexpr double margin = 1.25;
  double half_width = std::sqrt(2.0 * compression);
  half_width =
      on_nodes(body, compression, half_width / first_nodes, static_cast<int>(margin * first_nodes), options.poll)
          .half_width;
  const auto refined = [&](int nodes) {
    const int covering = static_cast<int>(std::lround(margin * nodes)) + 2;
    return on_nodes(body, compression, half_width / nodes, covering, options.poll);
  };
  const StaticContact coarse = refined(options.nodes / 2);
  half_width = coarse.half_width;
  StaticContact result = refined(options.nodes);
  // The error depends a little on where the contact ends between two nodes: the change can be small by chance.
  const double usual = body.usual_error * result.force / (static_cast<double>(options.nodes) * options.nodes);
  result.force_error = std::max(std::abs(result.force - coarse.force), usual);
  return result;
}

}  // namespace

StaticContact static_contact(double poisson, double compression, const StaticContactOptions& options) {
  require_poisson(poisson);
  return pressed(pressed_disk(poisson, options.poll), compression, options);
}

StaticContact static_contact(const Sphere& sphere, double compression, const StaticContactOptions& options) {
  bodies::sphere::require_poisson(sphere.poisson);
  return pressed(pressed_sphere(sphere.poisson, options.poll), compression, options);
}

}  // namespace stoss::quasistatic
