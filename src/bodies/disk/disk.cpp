// A disk as a body: its modes by order, the shapes of the orders on a contact grid, and the response of the other
// modes.
#include "stoss/bodies/disk.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <sstream>

#include "bodies/disk/residual.hpp"
#include "check.hpp"
#include "stoss/bodies/disk/modes.hpp"

namespace stoss {
namespace {

/// Number of node spacings in a half circle for about `nodes` nodes within half_width.
int spacings(double half_width, int nodes) {
  require("half_width", half_width, {0.0, std::numbers::pi, false, true, "above 0 and up to pi"},
          "half-width of the contact grid in R");
  const double wanted = std::numbers::pi * nodes / half_width;
  require("nodes", static_cast<long>(std::min(wanted, 1e9)), 4, 5'000'000,
          "nodes in a half circle: nodes * pi / half_width");
  return static_cast<int>(wanted * (1.0 + 4.0 * std::numeric_limits<double>::epsilon()));  // 2.999… means 3
}

ContactGrid make_grid(double poisson, int highest_order, double half_width, int nodes) {
  const double h = std::numbers::pi / spacings(half_width, nodes);
  const double pressure_speed = 1.0 / std::sqrt(1.0 - poisson * poisson);
  const double shear_speed = 1.0 / std::sqrt(2.0 * (1.0 + poisson));
  const auto count = static_cast<std::size_t>(nodes);
  ContactGrid grid;
  std::vector<double> cosine(count), sine(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double phi = (static_cast<double>(i) + 0.5) * h;
    cosine[i] = std::cos(phi);
    sine[i] = std::sin(phi);
    grid.coordinate.push_back(phi);
    grid.recess.push_back(2.0 * std::sin(0.5 * phi) * std::sin(0.5 * phi));
    grid.measure.push_back(2.0 * h);
    grid.impedance.push_back(2.0 * h / (cosine[i] * cosine[i] / pressure_speed + sine[i] * sine[i] / shear_speed));
  }
  // cos mφ for m = 0 … n + 1, by rotation from one order to the next.
  std::vector<double> cosine_m(count, 1.0), sine_m(count, 0.0);
  for (int m = 0; m <= highest_order + 1; ++m) {
    grid.shape.insert(grid.shape.end(), cosine_m.begin(), cosine_m.end());
    for (std::size_t i = 0; i < count; ++i) {
      const double next = cosine_m[i] * cosine[i] - sine_m[i] * sine[i];
      sine_m[i] = sine_m[i] * cosine[i] + cosine_m[i] * sine[i];
      cosine_m[i] = next;
    }
  }
  return grid;
}

}  // namespace

Body disk(double poisson, double cutoff, const Poll& poll) {
  const std::vector<Mode> modes = disk_modes(poisson, cutoff, poll);
  Body body;
  for (const Mode& mode : modes) {
    if (body.groups.empty() || body.groups.back().order != mode.order) {
      const auto n = static_cast<std::size_t>(mode.order);
      body.groups.push_back({mode.order, {}, {}, {}, n + 1, n > 0 ? n - 1 : 1});
    }
    ModeGroup& group = body.groups.back();
    group.omega.push_back(mode.omega);
    group.radial.push_back(mode.radial);
    group.tangential.push_back(mode.tangential);
  }

  std::ostringstream name;
  name.precision(17);
  name << "disk poisson=" << poisson;
  body.name = name.str();
  body.mass = std::numbers::pi;
  body.extent = 1.0;
  body.cutoff = cutoff;
  body.max_half_width = std::numbers::pi;
  // Hertz in the plane, a = 2√F, with a fit of the greatest force to the impacts in tests/data/contact_hard_wall.csv.
  body.expected_half_width = [](double speed) {
    return 2.0 * std::sqrt(speed / std::sqrt(1.0 + std::log1p(1.0 / speed)));
  };
  const int highest_order = modes.empty() ? 0 : modes.back().order;
  body.grid = [poisson, highest_order](double half_width, int nodes) {
    return make_grid(poisson, highest_order, half_width, nodes);
  };
  const auto residual = std::make_shared<const DiskResidual>(poisson, cutoff, modes);
  body.stable_step = residual->stable_step();
  body.residual_compliance = [residual](const ContactGrid& grid, const Poll& heed) {
    return residual->compliance(grid, heed);
  };
  body.residual_second_moment = [residual](const ContactGrid& grid, const Poll& heed) {
    return residual->second_moment(grid, heed);
  };
  return body;
}

BodyMaker disk(double poisson) {
  require_poisson(poisson);
  return [poisson](double cutoff, const Poll& poll) { return disk(poisson, cutoff, poll); };
}

}  // namespace stoss
