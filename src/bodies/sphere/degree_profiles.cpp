#include "bodies/sphere/degree_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

#include "bodies/sphere/legendre.hpp"
#include "bodies/sphere/mode_field.hpp"
#include "bodies/sphere/static_field.hpp"
#include "bodies/sphere/surface_points.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::sphere {
namespace {

using Eigen::Index;

std::array<double, DegreeProfiles::components> values(const RadialField& field) {
  return {field.radial, field.tangential, field.stress_rr, field.stress_rt, field.hoop, field.bend};
}

RadialPowers powers(double radius, int degree) {
  const double ring = (1.0 - radius) * (1.0 + radius);  // r^{n−2} − r^n = r^{n−2}(1 − r²)
  const double lowest = degree >= 2 ? std::pow(radius, degree - 2) : 0.0;
  const double low = degree >= 2 ? lowest * radius : (degree == 1 ? 1.0 : 0.0);
  const double here = degree >= 1 ? low * radius : 1.0;
  return {lowest * ring, low, here, here * radius};
}

/// Number of degrees whose static field is felt at a radius: r^n falls to 1e-20.
int static_degrees(double radius, int nyquist) {
  if (radius == 1.0) return nyquist + 1;
  const double last = 3.0 - 46.0 / std::log(std::max(radius, 1e-30));
  return 1 + (last < nyquist ? static_cast<int>(last) : nyquist);
}

/// Checks the Poisson's ratio: only with its own does a mode have these amplitudes at a free surface.
void require_free_surface(double poisson, const Body& body, const Mode& mode, const RadialField& edge) {
  const double root = std::sqrt(mode.order * (mode.order + 1.0));
  const double amplitude = std::hypot(mode.radial, root * mode.tangential);
  const double mismatch = std::hypot(edge.radial - mode.radial, root * (edge.tangential - mode.tangential));
  const double traction = std::hypot(edge.stress_rr, root * edge.stress_rt);
  if (mismatch < 1e-6 * amplitude && traction < 1e-6 * amplitude * (mode.order + mode.omega)) return;
  std::ostringstream line;
  line.precision(10);
  line << "poisson: got " << poisson << ", allowed only that of the body, which is '" << body.name
       << "' (a sphere; with another number its modes would not leave the surface free)";
  throw InvalidInput(line.str());
}

}  // namespace

DegreeProfiles::DegreeProfiles(double poisson, const Body& body, const ContactPoints& contact,
                               std::vector<double> radius, const Poll& poll)
    : poisson_(poisson),
      ring_(static_cast<Index>(contact.count)),
      nyquist_(static_cast<int>(std::lround(std::numbers::pi / (contact.spacing * contact.radius)))),
      radius_(std::move(radius)) {
  for (Index i = 0; i < ring_.size(); ++i) ring_(i) = ring_angle(contact, static_cast<std::size_t>(i));
  int kept_degrees = 0;
  for (const ModeGroup& group : body.groups) {
    keep(body, group, poll);
    kept_degrees = std::max(kept_degrees, group.order + 1);
  }
  for (const double r : radius_) degrees_.push_back(std::max(kept_degrees, static_degrees(r, nyquist_)));
}

void DegreeProfiles::keep(const Body& body, const ModeGroup& group, const Poll& poll) {
  const auto radii = static_cast<Index>(radius_.size());
  const auto size = static_cast<Index>(group.omega.size());
  KeptDegree kept{group.order, modes_, Eigen::VectorXd(size), Eigen::VectorXd(size),
                  Eigen::MatrixXd(static_cast<Index>(components) * radii, size)};
  std::vector<double> with_surface = radius_;
  with_surface.push_back(1.0);
  const double n = group.order;
  for (std::size_t l = 0; l < group.omega.size(); ++l) {
    const double upper = group.upper[l], lower = group.lower[l];
    const Mode mode{group.order, static_cast<int>(l), group.omega[l], upper + lower,
                    group.order > 0 ? lower / n - upper / (n + 1.0) : 0.0};
    const std::vector<RadialField> field = mode_field(poisson_, mode, with_surface, poll);
    require_free_surface(poisson_, body, mode, field.back());
    const auto column = static_cast<Index>(l);
    kept.radial[column] = mode.radial / (mode.omega * mode.omega);
    kept.tangential[column] = mode.tangential / (mode.omega * mode.omega);
    for (Index r = 0; r < radii; ++r) {
      Index row = r;
      for (const double value : values(field[static_cast<std::size_t>(r)])) {
        kept.field(row, column) = value;
        row += radii;
      }
    }
  }
  kept_.push_back(std::move(kept));
  modes_ += size;
}

DegreeProfiles::Loads DegreeProfiles::loads(const Eigen::ArrayXd& ring_force, const Poll& poll) const {
  const int end = *std::max_element(degrees_.begin(), degrees_.end());
  const Eigen::ArrayXd along = ring_force * ring_.cos(), across = ring_force * ring_.sin().square();
  LegendreSequence sequence(ring_);
  Loads loads;
  for (int n = 0; n < end; ++n, sequence.advance()) {
    if (poll && n % 64 == 0) poll();
    const double weight = n < nyquist_ ? 1.0 : (n == nyquist_ ? 0.5 : 0.0);
    loads.radial.push_back(-weight * (along * sequence.value()).sum());
    loads.tangential.push_back(-weight * (across * sequence.slope()).sum());
  }
  return loads;
}

void DegreeProfiles::add_static(const Loads& loads, int first, const Poll& poll, Profile& profile) const {
  for (int k = 0; k < block && first + k < static_cast<int>(loads.radial.size()); ++k) {
    if (poll) poll();
    const int n = first + k;
    const auto at = static_cast<std::size_t>(n);
    const double unit = (2.0 * n + 1.0) / 3.0;
    const double shear = n > 0 ? unit * loads.tangential[at] / (n * (n + 1.0)) : 0.0;
    const StaticField field = static_field(poisson_, n, unit * loads.radial[at], shear);
    for (std::size_t r = 0; r < radius_.size(); ++r) {
      if (degrees_[r] <= n) continue;
      const auto value = values(field.at(powers(radius_[r], n)));
      for (std::size_t i = 0; i < components; ++i) profile[i](static_cast<Index>(r), k) += value[i];
    }
  }
}

void DegreeProfiles::add_kept(const Eigen::VectorXd& coordinate, const Loads& loads, int first,
                              Profile& profile) const {
  const auto radii = static_cast<Index>(radius_.size());
  for (const KeptDegree& kept : kept_) {
    const int k = kept.degree - first;
    if (k < 0 || k >= block) continue;
    const auto n = static_cast<std::size_t>(kept.degree);
    const Eigen::VectorXd excess = coordinate.segment(kept.first, kept.radial.size()) - loads.radial[n] * kept.radial -
                                   loads.tangential[n] * kept.tangential;
    const Eigen::VectorXd sum = kept.field * excess;
    for (std::size_t i = 0; i < components; ++i) {
      profile[i].col(k) += sum.segment(static_cast<Index>(i) * radii, radii);
    }
  }
}

void DegreeProfiles::evaluate(const Eigen::VectorXd& coordinate, const Loads& loads, int first, const Poll& poll,
                              Profile& profile) const {
  for (Matrix& component : profile) component.setZero(static_cast<Index>(radius_.size()), block);
  add_static(loads, first, poll, profile);
  add_kept(coordinate, loads, first, profile);
}

}  // namespace stoss::bodies::sphere
