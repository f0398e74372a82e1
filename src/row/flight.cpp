// How long neighbours in free flight stay apart.
#include "row/flight.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace stoss {
namespace {

constexpr long most_looks = 1000;

/// The modes of a body ahead of time, at the points of one face, R of the first of two.
class Ahead {
 public:
  Ahead(const RowSolid& solid, Face face, double length)
      : modes_(solid.in_flight()), moved_(solid.points()), first_(solid.first_point(face)), length_(length) {}

  /// What may lie beyond the places at two looks in between.
  [[nodiscard]] double between() const {
    if (!modes_) return 0.0;
    return 0.125 * modes_->step() * modes_->step() * modes_->greatest_acceleration() * length_;
  }

  void add_to(std::vector<double>& place) {
    if (!modes_) return;
    std::fill(moved_.begin(), moved_.end(), 0.0);
    modes_->add_displacement(moved_);
    for (std::size_t i = 0; i < place.size(); ++i) place[i] += moved_[first_ + i] * length_;
  }

  void advance() {
    if (modes_) modes_->advance();
  }

 private:
  std::optional<KeptModes> modes_;
  std::vector<double> moved_;
  std::size_t first_;
  double length_;
};

/// By looks, each a few steps after the last. @param end after which they are clear
long steps_seen(const Flight& flight, double end) {
  Ahead one(flight.one, flight.face, 1.0);
  std::optional<Ahead> other;
  if (flight.other != nullptr) other.emplace(*flight.other, opposite(flight.face), flight.length);
  const double between = one.between() + (other ? other->between() : 0.0);
  constexpr long look = RowSolid::look;
  std::vector<double> place(flight.recess.size());
  for (long number = 0; number < most_looks; ++number) {
    const auto now = static_cast<double>(look * number);
    if (now > end) return never;
    for (std::size_t i = 0; i < place.size(); ++i) place[i] = -flight.recess[i];
    one.add_to(place);
    if (other) other->add_to(place);
    const double foremost = *std::max_element(place.begin(), place.end());
    if (flight.place + flight.stride * now + foremost + between >= 0.0) return look * std::max(0L, number - 1);
    one.advance();
    if (other) other->advance();
  }
  return look * (most_looks - 1);
}

}  // namespace

long steps_apart(const Flight& flight) {
  constexpr double far = 1e15, worth_it = 64.0;  // steps
  const auto& [one, face, other, length, recess, place, stride] = flight;
  const double reach = one.reach(face) + (other == nullptr ? 0.0 : other->reach(opposite(face)) * length);
  const double worst = place + reach;
  if (worst < 0.0 && stride <= 0.0) return never;
  const double apart = worst < 0.0 ? std::min(far, -worst / stride) : 0.0;
  if (apart > worth_it || !one.is_foreseen() || (other != nullptr && !other->is_foreseen())) {
    return static_cast<long>(apart);
  }
  return steps_seen(flight, stride < 0.0 ? worst / -stride : far);
}

}  // namespace stoss
