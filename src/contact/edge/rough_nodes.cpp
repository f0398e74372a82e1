#include "contact/edge/rough_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "numeric/kernels.hpp"

namespace stoss {
namespace {

constexpr double enough = 1e-12;  // of all forces, to which they are found
constexpr double begins = -1.0;   // t from which on a node belongs to those that push
constexpr double hardly = 0.01;   // change of d, over d and what is left of W, with which rows are kept
constexpr std::size_t usual = 2;  // loose nodes, when rows have been added

double sum_of(const std::vector<double>& x, std::size_t count) {
  return std::accumulate(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(count), 0.0);
}

/// Compliance of a node alone.
double own_of(const FactoredCompliance& compliance, std::size_t i) {
  return compliance.matrix().data()[i * (compliance.size() + 1)];
}

}  // namespace

RoughNodes::RoughNodes(std::shared_ptr<const FactoredCompliance> compliance)
    : compliance_(std::move(compliance)), factor_(compliance_), state_(compliance_->size()) {
  constexpr std::size_t lanes = numeric::kernels::lanes;
  const std::size_t whole = (compliance_->size() + lanes - 1) / lanes * lanes;
  for (auto* each : {&before_, &change_, &bend_, &jerk_, &displacement_, &rest_, &reduced_, &pushed_}) {
    each->resize(whole);
  }
}

/// @return the number of nodes that may push, as also from `predict`
std::size_t RoughNodes::begin(const EdgeLaw& law, const std::vector<double>& q) {
  std::size_t end = 1;
  for (std::size_t i = 0; i < q.size(); ++i) {
    state_.closure[i] = law.first_closure(i, -q[i], own_of(*compliance_, 0));
    change_[i] = bend_[i] = jerk_[i] = 0.0;
    if (state_.closure[i] > begins) end = i + 1;
  }
  for (std::size_t i = 0; i < end; ++i) state_.set(law, i, state_.closure[i]);
  return end;
}

/// Goes on as in the last three steps.
std::size_t RoughNodes::predict(const EdgeLaw& law) {
  constexpr double most = 1.0;  // of t
  const std::vector<double>& t = state_.closure;
  const double own = own_of(*compliance_, 0);
  std::size_t end = 1;
  for (std::size_t i = 0; i < t.size(); ++i) {
    before_[i] = t[i];
    pushed_[i] = change_[i] + bend_[i] + jerk_[i];
    if (t[i] + pushed_[i] > begins) end = i + 1;
  }
  const auto goes_on = [&](std::size_t i) {
    return before_[i] > 0.0 && std::abs(pushed_[i]) <= numeric::kernels::most_of_closure;
  };
  for (std::size_t i = 0; i < end; ++i) rest_[i] = goes_on(i) ? pushed_[i] : 0.0;
  state_.close(law, 0, end, rest_.data());
  for (std::size_t i = 0; i < end; ++i) {
    if (goes_on(i)) continue;
    const double next = before_[i] + pushed_[i];
    state_.set(law, i,
               before_[i] > 0.0 ? std::min(next, before_[i] + most)
                                : law.first_closure(i, law.gap[i] - law.asperities * next, own));
  }
  return end;
}

/// Gives up rows of nodes that have changed, and adds those of nodes that need not be loose.
bool RoughNodes::arrange(std::size_t end) {
  const std::vector<double>& d = state_.stiffness;
  std::size_t kept = std::min(factor_.kept(), end);
  for (std::size_t i = 0; i < kept; ++i) {
    const double off = std::abs(d[i] - factor_.diagonal()[i]);
    if (!(off <= hardly * (factor_.left()[i] + d[i]))) kept = i;
  }
  bool same = kept == factor_.kept() && end == end_;
  factor_.give_up(kept);
  if (end - kept > loosest) {
    same = false;
    while (end - factor_.kept() > usual) {
      if (!factor_.add(d[factor_.kept()])) return false;
    }
  }
  loose_ = end - factor_.kept(), end_ = end;
  if (!same) factor_.remainder(end, remainder_);
  return true;
}

/// Solves (S + diag(d)) x = x in place, S + D = L C Lᵀ by columns.
bool RoughNodes::solve_loose(Loose& x) {
  const double* const d = state_.stiffness.data() + factor_.kept();
  Loose share{};
  for (std::size_t a = 0; a < loose_; ++a) std::copy_n(remainder_.data() + a * loose_, a + 1, block_[a].data());
  for (std::size_t c = 0; c < loose_; ++c) {
    left_[c] = block_[c][c];
    const double pivot = left_[c] + d[c];
    if (!(pivot > 0.0)) return false;
    const double reciprocal = 1.0 / pivot;
    for (std::size_t a = c + 1; a < loose_; ++a) share[a] = block_[a][c] * reciprocal;
    for (std::size_t a = c + 1; a < loose_; ++a) {
      for (std::size_t b = c + 1; b <= a; ++b) block_[a][b] -= share[a] * block_[b][c];
      x[a] -= share[a] * x[c];
    }
    for (std::size_t a = c + 1; a < loose_; ++a) block_[a][c] = share[a];
    x[c] *= reciprocal;
  }
  for (std::size_t a = loose_; a-- > 1;) {
    for (std::size_t b = 0; b < a; ++b) x[b] -= block_[a][b] * x[a];
  }
  return true;
}

/// Lets the loose nodes obey their law while the others follow: S (f − f₀) − (g − g₀) = −r.
bool RoughNodes::press_loose(const EdgeLaw& law, std::size_t end) {
  constexpr int most = 40;
  constexpr double nearly = 0.1;  // change of t that is left to the next round over all nodes
  const std::size_t first = factor_.kept();
  Loose gap_before{}, change{};
  std::copy_n(state_.force.data() + first, loose_, force_before_.data());
  std::copy_n(state_.gap.data() + first, loose_, gap_before.data());
  for (int round = 0; round < most; ++round) {
    for (std::size_t a = 0; a < loose_; ++a) {
      double sum = -reduced_[first + a] + (state_.gap[first + a] - gap_before[a]);
      for (std::size_t b = 0; b < loose_; ++b) {
        sum -= remainder_[std::max(a, b) * loose_ + std::min(a, b)] * (state_.force[first + b] - force_before_[b]);
      }
      change[a] = sum;
    }
    if (!solve_loose(change)) return false;
    Loose force{}, closure{};
    std::copy_n(state_.force.data() + first, loose_, force.data());
    std::copy_n(state_.closure.data() + first, loose_, closure.data());
    state_.push(law, first, loose_, change.data(), left_.data());
    double moved = 0.0, largest = 0.0;
    for (std::size_t a = 0; a < loose_; ++a) {
      moved += std::abs(state_.force[first + a] - force[a]);
      if (state_.closure[first + a] > begins) {
        largest = std::max(largest, std::abs(state_.closure[first + a] - closure[a]));
      }
    }
    if (!std::isfinite(moved)) return false;
    open_ = moved * std::min(largest, 1.0);
    if (largest <= nearly || open_ <= 0.1 * enough * sum_of(state_.force, end)) return true;
  }
  return false;
}

/// Rounds over the first nodes. @return whether their forces were found
bool RoughNodes::find(const EdgeLaw& law, const std::vector<double>& q, std::size_t end) {
  constexpr int most = 30;
  for (int round = 0; round < most; ++round) {
    compliance_->multiply(0, end, end, state_.force, displacement_);
    if (!arrange(end)) return false;
    const std::size_t kept = factor_.kept();
    for (std::size_t i = 0; i < end; ++i) rest_[i] = displacement_[i] - q[i] - state_.gap[i];
    factor_.forward(end, rest_, reduced_);
    if (!press_loose(law, end)) return false;
    for (std::size_t a = 0; a < loose_; ++a) pushed_[kept + a] = state_.force[kept + a] - force_before_[a];
    for (std::size_t i = 0; i < kept; ++i) reduced_[i] = -reduced_[i];
    factor_.backward(end, reduced_, pushed_);
    const double largest = state_.push(law, 0, kept, pushed_.data(), factor_.left().data());
    double moved = 0.0, off = 0.0;
    for (std::size_t i = 0; i < end; ++i) moved += std::abs(pushed_[i]);
    for (std::size_t i = 0; i < kept; ++i) {
      const double d = state_.stiffness[i];
      off = std::max(off, std::abs(d - factor_.diagonal()[i]) / (factor_.left()[i] + d));
    }
    if (!std::isfinite(moved)) return false;
    // The next round would change as much.
    if (moved * (off + largest) + open_ <= enough * sum_of(state_.force, end)) return true;
  }
  return false;
}

void RoughNodes::remember() {
  constexpr double longest = 1e3, most_bend = 0.5, most_jerk = 0.05;  // of t
  for (std::size_t i = 0; known_ && i < state_.closure.size(); ++i) {
    const double change = std::clamp(state_.closure[i] - before_[i], -longest, longest);
    const double bend = change_[i] == 0.0 ? 0.0 : std::clamp(change - change_[i], -most_bend, most_bend);
    jerk_[i] = bend_[i] == 0.0 ? 0.0 : std::clamp(bend - bend_[i], -most_jerk, most_jerk);
    bend_[i] = bend, change_[i] = change;
  }
  known_ = true;
}

bool RoughNodes::solve(const EdgeLaw& law, const std::vector<double>& q, std::vector<double>& closure,
                       std::vector<double>& force, std::vector<double>& displacement) {
  const std::size_t n = q.size();
  std::size_t end = known_ ? predict(law) : begin(law, q);
  for (std::size_t joined = 0; joined != end;) {
    if (joined > 0) end = joined;
    if (!find(law, q, end)) return known_ = false;
    if (end < n) compliance_->multiply(end, end, n, state_.force, displacement_);
    joined = end;
    for (std::size_t i = end; i < n; ++i) {
      state_.closure[i] = law.free_closure(i, displacement_[i] - q[i]);
      if (state_.closure[i] > 0.0) joined = i + 1;
    }
    for (std::size_t i = end; i < joined; ++i) {
      state_.set(law, i, law.first_closure(i, displacement_[i] - q[i], own_of(*compliance_, i)));
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    force[i] = i < end && state_.closure[i] > 0.0 ? state_.force[i] : 0.0;
    displacement[i] = i < end ? q[i] + state_.gap[i] : displacement_[i];
  }
  closure = state_.closure;
  remember();
  return true;
}

}  // namespace stoss
