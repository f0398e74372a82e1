// Contacts of a row that sleep while their bodies fly freely.
#include <algorithm>

#include "row/flight.hpp"
#include "row/motion.hpp"

namespace stoss {

bool RowMotion::sleeps() const {
  return std::all_of(sleep_.begin(), sleep_.end(), [](const Sleep& each) { return each.until > 0; });
}

bool RowMotion::is_over() const {
  return std::all_of(sleep_.begin(), sleep_.end(), [](const Sleep& each) { return each.until == never; });
}

void RowMotion::fall_asleep(std::size_t k) {
  constexpr long pause = 8, worth_it = 32, margin = 2;  // steps
  Sleep& its = sleep_[k];
  const MadeRow::Joint& joint = row_.joints[k];
  RowSolid& one = *body(joint.one);
  RowSolid* const other = body(joint.other);
  const bool still = meetings_[k].is_still() && one.is_free() && (other == nullptr || other->is_free());
  const bool was_still = std::exchange(its.was_still, still);
  its.next_look = now_ + pause;
  if (!still || !was_still) return;
  const long apart = meetings_[k].steps_apart(one, joint.face, other, joint.resolution.step);
  if (apart < worth_it) {
    its.next_look += apart;
    return;
  }
  its.until = apart == never ? never : now_ + apart - margin;
  its.since = now_;
  its.was_still = false;
  meetings_[k].rest(0.0);
  for (const int each : {joint.one, joint.other}) {
    if (each < 0) continue;
    const auto b = static_cast<std::size_t>(each);
    if (--awake_joints_[b] == 0) known_at_[b] = now_;
  }
}

void RowMotion::wake(std::size_t k) {
  rest(k);
  sleep_[k] = {.next_look = now_};
  const MadeRow::Joint& joint = row_.joints[k];
  for (const int each : {joint.one, joint.other}) {
    if (each < 0) continue;
    const auto b = static_cast<std::size_t>(each);
    if (!is_awake(b)) solids_[b].fly(now_ - known_at_[b]);
    ++awake_joints_[b];
  }
}

/// Contacts that sleep of bodies that another one pushes.
void RowMotion::wake_pushed() {
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    if (sleep_[k].until == 0) continue;
    for (const int each : {row_.joints[k].one, row_.joints[k].other}) {
      if (each < 0 || !is_awake(static_cast<std::size_t>(each)) || body(each)->is_free()) continue;
      wake(k);
      break;
    }
  }
}

/// Lets a contact that sleeps rest until now.
void RowMotion::rest(std::size_t k) {
  const MadeRow::Joint& joint = row_.joints[k];
  meetings_[k].rest(static_cast<double>(now_ - sleep_[k].since) * joint.resolution.step);
  sleep_[k].since = now_;
}

void RowMotion::catch_up() {
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    if (sleep_[k].until > 0) rest(k);
  }
  for (std::size_t b = 0; b < solids_.size(); ++b) {
    if (is_awake(b)) continue;
    solids_[b].fly(now_ - known_at_[b]);
    known_at_[b] = now_;
  }
}

double RowMotion::known() const {
  const Meeting& last = meetings_.back();
  return last.touches > 0 ? last.first_touch + row_.known : std::numeric_limits<double>::infinity();
}

}  // namespace stoss
