// A disk as a body: its modes by order, the shapes of the orders on its edge, and the response of the other modes.
//
// A mode moves the point at angle φ towards the wall by Q (C cos nφ cos φ − S sin nφ sin φ)   (paper, the displacement
// of the edge), which is Q [½(C + S) cos(n + 1)φ + ½(C − S) cos(n − 1)φ].
#include "stoss/bodies/disk.hpp"

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <string>

#include "bodies/disk/edge_points.hpp"
#include "bodies/disk/mode_search.hpp"
#include "bodies/disk/near_side.hpp"
#include "bodies/disk/order_sums.hpp"
#include "bodies/disk/parity/bodies_along.hpp"
#include "bodies/round_body.hpp"
#include "check.hpp"
#include "stoss/bodies/disk/modes.hpp"

namespace stoss {
namespace {

using namespace bodies::disk;

// The lowest mode lies between these for every ν.
constexpr double no_mode_below = 1.0;
constexpr double highest_lowest_mode = 2.0;

Surface make_surface(double poisson, std::size_t rows, const ContactPoints& points) {
  const double pressure_speed = 1.0 / std::sqrt(1.0 - poisson * poisson);
  const double shear_speed = 1.0 / std::sqrt(2.0 * (1.0 + poisson));
  const std::size_t count = points.count;
  Surface surface;
  std::vector<double> cosine(count), sine(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double phi = edge_angle(points, i);
    cosine[i] = std::cos(phi);
    sine[i] = std::sin(phi);
    const double length = 2.0 * points.spacing * edge_stretch(points, i);
    surface.recess.push_back(2.0 * std::sin(0.5 * phi) * std::sin(0.5 * phi));
    surface.measure.push_back(length);
    surface.impedance.push_back(length / (cosine[i] * cosine[i] / pressure_speed + sine[i] * sine[i] / shear_speed));
  }
  // cos mφ, by rotation from one order to the next.
  std::vector<double> cosine_m(count, 1.0), sine_m(count, 0.0);
  for (std::size_t m = 0; m < rows; ++m) {
    surface.shape.insert(surface.shape.end(), cosine_m.begin(), cosine_m.end());
    for (std::size_t i = 0; i < count; ++i) {
      const double next = cosine_m[i] * cosine[i] - sine_m[i] * sine[i];
      sine_m[i] = sine_m[i] * cosine[i] + cosine_m[i] * sine[i];
      cosine_m[i] = next;
    }
  }
  return surface;
}

std::vector<ModeGroup> group_by_order(const std::vector<Mode>& modes) {
  std::vector<ModeGroup> groups;
  for (const Mode& mode : modes) {
    if (groups.empty() || groups.back().order != mode.order) {
      const auto n = static_cast<std::size_t>(mode.order);
      groups.push_back({mode.order, {}, {}, {}, n + 1, n > 0 ? n - 1 : 1, {}, 1.0 * mode.order});
    }
    groups.back().omega.push_back(mode.omega);
    groups.back().upper.push_back(0.5 * (mode.radial + mode.tangential));
    groups.back().lower.push_back(0.5 * (mode.radial - mode.tangential));
  }
  return groups;
}

void require_disk(const Disk& disk) {
  require_poisson(disk.poisson);
  bodies::require_size_and_material("disk", disk);
}

/// Chosen so that steps, contact points and modes are refined together (docs/developer/numerics.md, section 5).
constexpr Sampling sampling{.points = 24.0, .cutoff = 32.0, .power = 0.65, .along_edge = 0.7, .fewest = 32};

}  // namespace

Body disk(const Disk& disk, double cutoff, const Poll& poll) {
  require_disk(disk);
  const double poisson = disk.poisson;
  constexpr Range allowed{0.0, max_cutoff, false, true, "above 0 to 1000"};
  require("cutoff", cutoff, allowed, "highest frequency in c/R of this disk; 25 to 100 is usual");
  const double loss_time = bodies::own_loss_time(disk), highest = kept_cutoff(cutoff, loss_time);
  const auto kept = std::make_shared<const std::vector<Mode>>(
      highest <= no_mode_below ? std::vector<Mode>{} : checked_modes(poisson, highest, poll));
  const std::vector<Mode>& modes = *kept;
  Body body;
  body.name = bodies::name_of("disk", disk);
  body.scale = {disk.radius, bodies::wave_speed(disk), std::numbers::pi * disk.density * disk.radius * disk.radius};
  body.contour = Contour::cylinder;
  body.mass = std::numbers::pi;
  body.extent = 1.0;
  body.inertia = 0.5 * body.mass;
  body.loss_time = loss_time;
  body.cutoff = cutoff;
  body.highest_cutoff = max_cutoff;
  body.sampling = sampling;
  body.along = [like = body, poisson, kept](const Poll& heed) { return bodies_along(like, poisson, kept, heed); };
  body.groups = group_by_order(modes);
  const std::size_t rows = modes.empty() ? 0 : static_cast<std::size_t>(modes.back().order) + 2;
  body.surface = [poisson, rows](const ContactPoints& points) { return make_surface(poisson, rows, points); };
  bodies::set_residual(body, std::make_shared<const Residual>(poisson, cutoff, modes));
  body.near_side = [disk, name = body.name](double size, double up_to, const Poll& heed) {
    Body part = near_side(disk, size, up_to, heed);
    part.name = name + " (near side)";
    return part;
  };
  return body;
}

Body disk(double poisson, double cutoff, const Poll& poll) {
  // By itself, a disk without modes is a mistake.
  if (cutoff < highest_lowest_mode) (void)bodies::disk::modes(poisson, cutoff);
  return disk(Disk{poisson}, cutoff, poll);
}

BodyMaker disk(const Disk& disk) {
  require_disk(disk);
  return [disk](double cutoff, const Poll& poll) { return stoss::disk(disk, cutoff, poll); };
}

BodyMaker disk(double poisson) { return disk(Disk{poisson}); }

}  // namespace stoss
