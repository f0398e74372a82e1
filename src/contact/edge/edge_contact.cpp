#include "contact/edge/edge_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/kernels.hpp"
#include "stoss/errors.hpp"

namespace stoss {

EdgeContact::EdgeContact(std::vector<double> matrix, EdgeLaw law, std::size_t size, const Poll& poll)
    : EdgeContact(std::make_shared<const FactoredCompliance>(std::move(matrix), size, poll), std::move(law), poll) {}

EdgeContact::EdgeContact(std::shared_ptr<const FactoredCompliance> compliance, EdgeLaw law, Poll poll)
    : compliance_(std::move(compliance)),
      law_(std::move(law)),
      poll_(std::move(poll)),
      inner_(compliance_->size()),
      closure_(compliance_->size()) {
  if (law_.asperities > 0.0) rough_.emplace(compliance_);
}

double EdgeContact::half_width() const {
  // By as much the closures of a zone exceed, on average over its place, what lies within the edge.
  constexpr double excess = 0.18;
  if (law_.asperities > 0.0) return EdgeLaw::pressed(closure_);
  double sum = 0.0;
  for (std::size_t i = 0; i < extent_; ++i) sum += std::clamp(closure_[i], 0.0, 1.0);
  return std::max(0.0, sum - excess);
}

bool EdgeContact::overflows() const {
  return law_.asperities == 0.0 ? extent_ == closure_.size() : EdgeLaw::pushes_at(closure_, closure_.size() - 1);
}

double EdgeContact::energy(const std::vector<double>& force, const std::vector<double>& displacement) const {
  double sum = 0.0;
  if (rough_) {  // in a form that is stationary in f, as that is known to the accuracy of the iteration
    std::vector<double> moved(force.size());
    compliance_->multiply(0, extent_, force, moved);
    for (std::size_t i = 0; i < extent_; ++i) {
      const double q = displacement[i] - law_.gap_at(i, closure_[i]);
      sum += force[i] * (q - 0.5 * moved[i]) + law_.energy_at(i, closure_[i]);
    }
    return sum;
  }
  for (std::size_t i = 0; i < extent_; ++i) {
    sum += 0.5 * force[i] * displacement[i];
    if (!law_.gap.empty()) sum += law_.energy_at(i, closure_[i]) - force[i] * law_.gap_at(i, closure_[i]);
  }
  return sum;
}

double EdgeContact::law_energy(const std::vector<double>& force) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < extent_ && !law_.gap.empty(); ++i) {
    sum += law_.energy_at(i, closure_[i]) - force[i] * law_.gap_at(i, closure_[i]);
  }
  return sum;
}

void EdgeContact::follow(double before, double now, double step) {
  if (law_.follows()) law_.follow(before, now, half_width(), step);
}

double EdgeContact::closeness(const std::vector<double>& q) const {
  const double largest = law_.gap.empty()
                             ? std::max(0.0, q[0]) + 0.0 * q[0]
                             : numeric::kernels::largest_within(q.data(), law_.gap.data(), law_.opening, q.size());
  if (!std::isfinite(largest)) {
    throw NotConverged("contact: the position of a node is not a finite number", "step", "use a smaller step");
  }
  return largest;
}

void EdgeContact::solve(const std::vector<double>& q, std::vector<double>& force, std::vector<double>& displacement) {
  const double scale = closeness(q);
  if (scale == 0.0) {
    std::fill(force.begin(), force.end(), 0.0);
    std::fill(displacement.begin(), displacement.end(), 0.0);
    extent_ = rigid_ = 0;
    if (rough_) rough_->forget();
    return;
  }
  if (law_.gap.empty()) return solve_point(q, force, displacement);
  if (constexpr double rounding = 1e-13;
      !(rough_ ? solve_rough(q, force, displacement) : solve_edge(q, rounding * scale, force, displacement))) {
    solve_generally(q, scale, force, displacement);
  }
}

void EdgeContact::solve_point(const std::vector<double>& q, std::vector<double>& force,
                              std::vector<double>& displacement) {
  force[0] = q[0] / compliance_->matrix()(0, 0);
  displacement[0] = q[0];
  closure_[0] = 1.0;
  extent_ = 1;
}

void EdgeContact::find_zone(std::size_t rigid) {
  // In most steps the edge stays between the same nodes, and moves on as before.
  const bool same = in_zone_ && zone_.first == rigid;
  for (std::size_t a = 0; a < zone_.closure.size(); ++a) {
    const double now = zone_.closure[a];
    if (same) zone_.closure[a] += std::clamp(now - closure_before_[a], -0.25, 0.25);
    closure_before_[a] = now;
  }
  if (!same) {
    zone_.closure.fill(0.5);
    closure_before_.fill(0.5);
  }
  zone_.first = rigid;
  zone_.count = std::min<std::size_t>(3, compliance_->size() - rigid);
  zone_.position = {};
  zone_.compliance = {};
  for (std::size_t a = 0; a < zone_.count; ++a) {
    for (std::size_t c = 0; c <= a; ++c) {
      zone_.position[a] += compliance_->lower(rigid + a, rigid + c) * inner_[rigid + c];
    }
    for (std::size_t b = 0; b <= a; ++b) {
      double sum = 0.0;
      for (std::size_t c = 0; c <= b; ++c) {
        sum += compliance_->lower(rigid + a, rigid + c) * compliance_->lower(rigid + b, rigid + c);
      }
      zone_.compliance[a][b] = zone_.compliance[b][a] = sum;
    }
  }
}

bool EdgeContact::solve_edge(const std::vector<double>& q, double tolerance, std::vector<double>& force,
                             std::vector<double>& displacement) {
  constexpr int max_trials = 12;
  const std::size_t size = compliance_->size();
  std::size_t rigid = std::min(rigid_, size);
  for (int trial = 0; trial < max_trials; ++trial) {
    const std::size_t count = std::min(rigid + 3, size);
    compliance_->forward(count, q, inner_);
    find_zone(rigid);
    const bool known = in_zone_;
    in_zone_ = solve_zone(law_, zone_);
    if (!in_zone_ && known) {
      zone_.closure.fill(0.5);
      in_zone_ = solve_zone(law_, zone_);
    }
    if (!in_zone_) return false;
    // On nodes without force behind the zone Lᵀ f vanishes, and on the zone it is L_zzᵀ f_z.
    for (std::size_t a = 0; a < zone_.count; ++a) {
      double sum = 0.0;
      for (std::size_t b = a; b < zone_.count; ++b) {
        sum += compliance_->lower(rigid + b, rigid + a) * law_.force_at(rigid + b, zone_.closure[b]);
      }
      inner_[rigid + a] = sum;
    }
    compliance_->backward(count, inner_, force);
    std::size_t keep = rigid;
    while (keep > 0 && force[keep - 1] < law_.full_force(keep - 1)) --keep;
    for (std::size_t i = 0; i < keep; ++i) {
      if (force[i] < law_.full_force(i)) return false;
    }
    if (keep < rigid) {
      rigid = keep;
      continue;
    }
    compliance_->multiply(count, count, force, displacement);
    std::size_t grown = count;
    while (grown < size && displacement[grown] - q[grown] < law_.full_gap(grown) - tolerance) ++grown;
    for (std::size_t i = grown; i < size; ++i) {
      if (displacement[i] - q[i] < law_.full_gap(i) - tolerance) return false;
    }
    if (grown > count) {
      // What is closed in front of the zone's end becomes rigid; if nothing is, the zone is wider than three nodes.
      std::size_t closed = 0;
      while (closed < zone_.count && zone_.closure[closed] >= 1.0) ++closed;
      if (closed == 0) return false;
      rigid += closed;
      continue;
    }
    std::copy_n(q.begin(), rigid, displacement.begin());
    std::fill_n(closure_.begin(), rigid, 1.0);
    extent_ = rigid_ = rigid;
    for (std::size_t a = 0; a < zone_.count; ++a) {
      const std::size_t i = rigid + a;
      closure_[i] = zone_.closure[a];
      force[i] = law_.force_at(i, closure_[i]);
      if (closure_[i] > 0.0) extent_ = i + 1;
      if (closure_[i] >= 1.0 && rigid_ == i) ++rigid_;
      displacement[i] = q[i] + law_.gap_at(i, closure_[i]);
    }
    std::fill(force.begin() + static_cast<std::ptrdiff_t>(count), force.end(), 0.0);
    return true;
  }
  return false;
}

bool EdgeContact::solve_rough(const std::vector<double>& q, std::vector<double>& force,
                              std::vector<double>& displacement) {
  if (!rough_->solve(law_, q, closure_, force, displacement)) return false;
  extent_ = rigid_ = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (force[i] > 0.0) extent_ = i + 1;
  }
  return true;
}

/// As if each node carried about half of what makes it rigid, if it is not clear of the law by itself.
void EdgeContact::reset_closures(const std::vector<double>& q) {
  const double own = compliance_->matrix()(0, 0);
  for (std::size_t i = 0; i < q.size(); ++i) closure_[i] = law_.first_closure(i, -q[i], own);
}

void EdgeContact::solve_generally(const std::vector<double>& q, double scale, std::vector<double>& force,
                                  std::vector<double>& displacement) {
  const std::size_t size = compliance_->size();
  // From the last solution, whose far nodes may never have been asked for.
  const double own = compliance_->matrix()(0, 0);
  for (std::size_t i = extent_; i < size; ++i) {
    const double behind = -q[i];
    closure_[i] = law_.asperities > 0.0 ? law_.first_closure(i, behind, own) : law_.free_closure(i, behind);
  }
  const auto solved = [&] { return solve_all(*compliance_, law_, q, scale, poll_, closure_); };
  if (!solved() && !(reset_closures(q), solved())) {
    throw NotConverged(
        "contact: no forces at the nodes obey the law of contact (another resolution may do; please report the input)");
  }
  extent_ = rigid_ = 0;
  for (std::size_t i = 0; i < size; ++i) {
    force[i] = law_.force_at(i, closure_[i]);
    if (force[i] > 0.0) extent_ = i + 1;
    if (closure_[i] >= 1.0 && rigid_ == i) ++rigid_;
  }
  compliance_->multiply(0, extent_, force, displacement);
}

}  // namespace stoss
