#include "contact/edge/edge_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "contact/faces/coats.hpp"
#include "contact/faces/projected_areas.hpp"
#include "contact/touch.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {
namespace {

// Constants of the law for which the force follows the envelope, to 2 % from 12 touching nodes on.
constexpr double force_constant = 0.7145;  // of two edges of unit length, those of a node and its mirror image
constexpr double gap_constant = 0.6177;
constexpr double least = 1e-6;  // that a law is scaled by
constexpr double outrun = 0.5;  // fit: the edge, which moves at v/(y/R), opens a smaller gap above the wave speed

/// Half of what a coat that bodies flatten but for the length ℓ = C E* opens over a spacing at its edge: the slope
/// there is that of Hertz' gap at the distance ℓ.
double coat_gap(const Touch& met, double length, double at, double spacing) {
  return 0.5 * met.curvature * at * std::sqrt(length / (length + at)) * spacing;
}

/// Makes it the law of a coat where that is as soft as the bodies over a spacing. A coat alone, whose closure falls
/// with the slope s from the middle of a node's width h on, has the law f = f*(…)² exactly, with g* = sh/2 and f* = A
/// g*/C.
void add_coats(const Contact& contact, const ContactGrid& grid, EdgeLaw& law) {
  const double compliance = coat_compliance(contact);
  if (compliance == 0.0) return;
  const Touch met = touch(contact);
  const double length = compliance / met.softness, spacing = grid.points.spacing * grid.points.radius;
  const std::vector<double> area = projected_areas(contact, grid.points);
  for (std::size_t i = 0; i < law.gap.size(); ++i) {
    const double of_bodies = law.gap[i] / law.force[i];
    law.gap[i] = std::hypot(law.gap[i], coat_gap(met, length, grid.coordinate[i], spacing));
    law.force[i] = law.gap[i] / (of_bodies + compliance / area[i]);
  }
}

/// What stands before √a s^{3/2}/R in the gap at a distance s from the edge of a Hertzian contact.
double opening_constant(bool circle) {
  const double line = 2.0 * std::numbers::sqrt2 / 3.0;
  return circle ? line * 4.0 / std::numbers::pi : line;
}

/// The same of this contact, in which the edge, at a place, may outrun the waves.
double opening_at(const Touch& met, double at, double speed) {
  const double mach = outrun * speed * met.slowness / (met.curvature * at);
  return opening_constant(met.circle) * met.curvature * std::sqrt(at) / (1.0 + mach * mach);
}

/// Share of the gap of an edge that asperities do not smear out.
double left_by(double asperities, double gap) {
  constexpr double smears = 3.0;  // fit: impacts on 24 to 256 rings agree best, to 1e-4 of what they lose on 32
  const double square = gap * gap, smeared = smears * asperities;
  return square == 0.0 ? 0.0 : square / (square + smeared * smeared);
}

EdgeLaw law_of_smooth_faces(const Contact& contact, const ContactGrid& grid, double speed) {
  EdgeLaw law;
  if (has_single_point(contact)) return law;
  const Touch met = touch(contact);
  law.loss_time = met.loss_time;
  law.relaxing = relaxing_bodies(contact);
  const double spacing = grid.points.spacing * grid.points.radius;
  for (std::size_t i = 0; i < grid.coordinate.size(); ++i) {
    const double opening = opening_at(met, grid.coordinate[i], speed);
    const double edges =
        met.circle ? std::numbers::pi * grid.points.radius * std::sin(grid.points.angle(i)) : 1.0;  // pairs
    law.force.push_back(force_constant * edges * opening * spacing * std::sqrt(spacing) / met.softness);
    law.gap.push_back(gap_constant * opening * spacing * std::sqrt(spacing));
  }
  return law;
}

/// Puts asperities in series with the law of smooth faces.
void add_asperities(const Contact& contact, const ContactGrid& grid, double speed, EdgeLaw& law) {
  constexpr double negligible = 1e-12;   // of the energy, and of the force that stops the body in the time of a wave
  constexpr double as_if_smooth = 1e-6;  // of the gap of an edge: 1e-6 of what is lost
  const double length = contact.asperities;
  if (!law.gap.empty() && length < as_if_smooth * law.gap.back()) return;
  law.asperities = length;
  law.loss_time = 0.0, law.relaxing.clear();     // a node of asperities has no edge that would have to be followed
  const bool point = has_single_point(contact);  // which has no edge
  law.edge_force = point ? std::vector{1.0} : law.force;
  law.edge_gap = point ? std::vector{0.0} : law.gap;
  for (double& each : law.edge_gap) each *= left_by(length, each);
  law.force = projected_areas(contact, grid.points);
  const double area = std::accumulate(law.force.begin(), law.force.end(), 0.0);
  const double pressure = negligible * contact.mass * speed * std::min(0.5 * speed / length, contact.cutoff) / area;
  for (double& each : law.force) each *= pressure;
  law.gap.assign(law.force.size(), length * (std::log(contact.strength / length) - std::log(pressure)));
  for (std::size_t i = 0; i < law.edge_gap.size(); ++i) {
    const double open = 1.0 - std::min(1.0, std::sqrt(law.force[i] / law.edge_force[i]));
    law.edge_open.push_back(open * open);
    law.gap[i] += law.edge_gap[i] * law.edge_open[i];
  }
}

}  // namespace

double EdgeLaw::energy_at(std::size_t i, double closure) const {
  const auto of_edge = [](double full, double closing, double t) {
    return full * closing * t * t * (1.0 - t * (4.0 / 3.0 - 0.5 * t));
  };
  if (asperities == 0.0) return of_edge(full_force(i), full_gap(i), std::clamp(closure, 0.0, 1.0));
  const double its = force_at(i, closure);
  if (!(its > 0.0)) return 0.0;
  const double alone = gap[i] - edge_gap[i] * edge_open[i] - asperities * closure;
  const double of_asperities = its * alone + asperities * (its - force[i]);
  return of_asperities + of_edge(edge_force[i], edge_gap[i], edge_closure(i, closure));
}

double EdgeLaw::moved(std::size_t i, double closure, double change, double own) const {
  constexpr double small = 0.05;
  constexpr int rounds = 8;
  if (asperities == 0.0 || std::abs(change) < small) return closure + change;
  // a eᵗ + t = s, from above: convex.
  const double a = own * force[i] / asperities, f = closure > 0.0 ? a * std::exp(closure) : 0.0;
  const double s = closure + change + f * (1.0 + change);
  double t = s > 0.0 ? std::min(s, std::max(0.0, std::log(s / a))) : s;
  for (int round = 0; round < rounds; ++round) {
    const double its = a * std::exp(t);
    t -= (its + t - s) / (its + 1.0);
  }
  return t;
}

bool EdgeLaw::pushes_at(const std::vector<double>& closure, std::size_t i) {
  constexpr double share = 1e-6;
  return closure[i] > std::max(0.0, *std::max_element(closure.begin(), closure.end()) + std::log(share));
}

double EdgeLaw::pressed(const std::vector<double>& closure) {
  constexpr double share = 1e-3, middle = 0.5;
  const double least = std::max(0.0, *std::max_element(closure.begin(), closure.end()) + std::log(share));
  std::size_t count = closure.size();
  while (count > 0 && closure[count - 1] <= least) --count;
  if (count == 0 || count == closure.size()) return static_cast<double>(count);
  const double last = closure[count - 1], next = std::min(closure[count], least);
  return static_cast<double>(count) - middle + (last - least) / (last - next);
}

double EdgeLaw::modulus_at(double time) const {
  double compliance = 1.0;
  for (const RelaxingBody& each : relaxing) {
    compliance += each.share * (1.0 / std::max(modulus_after(each.relaxation, time), least) - 1.0);
  }
  return 1.0 / compliance;
}

void EdgeLaw::follow(double before, double now, double half_width, double step) {
  // Half-widths go with the root of the compression, nearly so along a line; the last node to leave has one of ½.
  const double left = std::max(now, least * std::abs(before));
  const double rate = 0.5 * std::max(half_width, 0.5) * (now - before) / (left * step);  // of spacings
  if (rate >= 0.0) {
    shrinking = 0.0;
    opening = 1.0;
    firmness = rate > 0.0 ? modulus_at(1.0 / rate) : 1.0;
    return;
  }
  constexpr double constant = 24.0;
  const double passing = constant * loss_time * rate;
  shrinking += step;
  firmness = modulus_at(2.0 * shrinking);
  opening = std::max(least, std::min(1.0, firmness / modulus_at(-1.0 / rate)) / (1.0 + passing * passing));
}

double EdgeLaw::range(const std::vector<double>& recess) const {
  double range = 0.0;
  for (std::size_t i = 0; i < gap.size(); ++i) range = std::max(range, gap[i] - recess[i]);
  return range;
}

double edge_left(const Contact& contact, const ContactGrid& grid, double speed) {
  if (contact.asperities == 0.0 || has_single_point(contact)) return 1.0;
  const double spacing = grid.points.spacing * grid.points.radius;
  const Touch met = touch(contact);
  const double at = expected_half_width(contact, speed), length = coat_compliance(contact) / met.softness;
  const double gap = gap_constant * opening_at(met, at, speed) * spacing * std::sqrt(spacing);
  return left_by(contact.asperities, std::hypot(gap, coat_gap(met, length, at, spacing)));
}

EdgeLaw edge_law(const Contact& contact, const ContactGrid& grid, double speed) {
  EdgeLaw law = law_of_smooth_faces(contact, grid, speed);
  add_coats(contact, grid, law);
  if (contact.asperities > 0.0) add_asperities(contact, grid, speed, law);
  return law;
}

}  // namespace stoss
