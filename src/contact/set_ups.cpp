#include "contact/set_ups.hpp"

#include <algorithm>

namespace stoss {

SetUp make_set_up(const Contact& contact, const ContactGrid& grid, ResidualMotion::Inertia inertia, double step,
                  const Poll& poll) {
  Residuals residuals(contact, grid, inertia, step, poll);
  auto compliance = std::make_shared<const FactoredCompliance>(residuals.compliance(), grid.recess.size(), poll);
  return {std::move(residuals), std::move(compliance)};
}

std::shared_ptr<const SetUp> SetUps::of(const Contact& contact, const ContactGrid& grid,
                                        ResidualMotion::Inertia inertia, double step, const Poll& poll) {
  // Some eight matrices between the nodes each: 16 MB are 60 set-ups of 64 nodes.
  constexpr std::size_t most_entries = std::size_t{16} << 20U, entry = 8 * sizeof(double);
  const Key key{contact.first.get(), contact.second.get(), contact.cutoff, contact.radius,
                grid.points.spacing, grid.points.count,    inertia,        step};
  const auto find = [&] {
    return std::find_if(kept_.begin(), kept_.end(), [&](auto& each) { return each.first == key; });
  };
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = find(); known != kept_.end()) return known->second;
  }
  auto made = std::make_shared<const SetUp>(make_set_up(contact, grid, inertia, step, poll));
  const std::lock_guard lock(mutex_);
  if (const auto known = find(); known != kept_.end()) return known->second;
  kept_.emplace_back(key, made);
  const auto size = [](const Key& each) { return entry * each.count * each.count; };
  std::size_t all = 0;
  for (const auto& each : kept_) all += size(each.first);
  for (; all > most_entries; kept_.pop_front()) all -= size(kept_.front().first);
  return made;
}

}  // namespace stoss
