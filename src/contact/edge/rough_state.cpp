#include "contact/edge/rough_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stoss {

namespace kernels = numeric::kernels;

kernels::RoughNodes RoughState::view(const EdgeLaw& law, std::size_t first) {
  for (std::size_t i = reach_.size(); i < law.gap.size(); ++i) {
    reach_.push_back(law.gap[i] - law.edge_gap[i] * law.edge_open[i]);
  }
  return {closure.data() + first,   force.data() + first,  root.data() + first,         gap.data() + first,
          stiffness.data() + first, reach_.data() + first, law.edge_gap.data() + first, law.asperities};
}

void RoughState::set(const EdgeLaw& law, std::size_t i, double closure_of_it) {
  constexpr double none = 0.0, least = -300.0;  // so that there is a force to be changed
  closure[i] = closure_of_it;
  force[i] = law.force[i] * std::exp(std::max(closure_of_it, least));
  root[i] = std::sqrt(force[i] / law.edge_force[i]);
  kernels::add_forces(view(law, i), 1, &none);
}

void RoughState::close(const EdgeLaw& law, std::size_t first, std::size_t count, const double* change) {
  kernels::add_closures(view(law, first), count, change);
}

double RoughState::push(const EdgeLaw& law, std::size_t first, std::size_t count, const double* change,
                        const double* own) {
  const double largest = kernels::largest_share(change, force.data() + first, count);
  if (largest <= kernels::most_of_force) {
    kernels::add_forces(view(law, first), count, change);
    return largest;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (std::abs(change[i]) <= kernels::most_of_force * force[first + i]) {
      kernels::add_forces(view(law, first + i), 1, change + i);
    } else {
      settle(law, first + i, change[i], own[i]);
    }
  }
  return largest;
}

void RoughState::settle(const EdgeLaw& law, std::size_t i, double change, double own) {
  constexpr int most = 60;
  constexpr double precise = 1e-3;  // of t: the next round sees what is left
  const double aim = own * force[i] - gap[i] + (own + stiffness[i]) * change, share = change / force[i];
  // Gaps fall as t grows, so f is at most what closes that of t = 0; from far above it the method would take each e.
  const double most_push = (aim + law.gap[i]) / (own * law.force[i]);
  double low = -std::numeric_limits<double>::infinity(), high = most_push > 1.0 ? std::log(most_push) : 0.0;
  double t = std::min(high, closure[i] + (share > -0.9 ? std::log1p(share) : share));
  if (!std::isfinite(t)) t = std::min(high, closure[i]);
  for (int round = 0; round < most; ++round) {
    set(law, i, t);
    const double beyond = own * force[i] - gap[i] - aim;
    (beyond > 0.0 ? high : low) = t;
    double next = t - beyond / ((own + stiffness[i]) * force[i]);
    if (!(next <= high)) next = std::isfinite(low) ? 0.5 * (low + high) : high;
    if (!(next >= low)) next = 0.5 * (low + high);
    if (!(std::abs(next - t) >= precise)) return set(law, i, std::isfinite(next) ? next : t);
    t = next;
  }
}

}  // namespace stoss
