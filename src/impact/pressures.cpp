#include "impact/pressures.hpp"

#include <algorithm>

#include "contact/friction.hpp"

namespace stoss {

void Pressures::add(const std::vector<double>& force, const ContactResponse& response, const NormalMotion& center) {
  const bool first = force_before_.empty();
  nodes_ = force.size();
  force_before_.resize(nodes_);
  gap_before_.resize(nodes_);
  const bool pushes = response.extent() > 0;
  const bool kept = pushes || steps() > 0;
  for (std::size_t i = 0; i < nodes_; ++i) {
    const double now = i < response.extent() ? force[i] : 0.0, gap = response.gap(i);
    if (kept) {
      force_.push_back(now);
      give_.push_back(first ? 0.0 : edge_compliance_along(1.0, gap, gap_before_[i], now, force_before_[i]));
    }
    force_before_[i] = now;
    gap_before_[i] = gap;
  }
  if (kept) {
    extent_.push_back(response.extent());
    compression_.push_back(center.compression());
    velocity_.push_back(center.velocity());
  } else {
    ++first_;
  }
  if (pushes) last_ = steps();
}

void Pressures::end_with_contact() {
  const std::size_t end = std::min(last_ + 1, steps());
  extent_.resize(end);
  force_.resize(end * nodes_);
  give_.resize(end * nodes_);
}

}  // namespace stoss
