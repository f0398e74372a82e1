#include "vibration/rod_vibrations.hpp"

#include <algorithm>
#include <cmath>

#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Two rods whose ends meet, in the frame of their centre of mass.
class Encounter {
 public:
  /// Starts when the ends cannot touch yet. @param left, right the waves, as they arrive at the ends that meet when the
  /// undeformed ends touch
  Encounter(const RodWave& left, const RodWave& right, double speed) : left_(left), right_(right) {
    const double mass = mass_of(left), other = mass_of(right);
    rate_ = {speed * other / (mass + other), -speed * mass / (mass + other)};
    const double time = -reach() / speed;
    left_.rotate(time);
    right_.rotate(time);
    overlap_ = speed * time;
    gap_ = std::max(0.0, -(overlap_ + left_.swing().now - right_.swing().now));
    left_.shift(0.5 * rate_.left);
    right_.shift(0.5 * rate_.right);
  }

  /// Moves on to the next change of the incoming waves, or of contact.
  void advance() {
    const double difference = left_.front().velocity - right_.front().velocity;
    double time = std::min(left_.front().duration, right_.front().duration), force = 0.0;
    bool closes = false;
    if (gap_ > 0.0 || difference < 0.0) {
      closes = difference > 0.0 && gap_ <= 2.0 * difference * time;
      if (closes) time = std::min(time, gap_ / (2.0 * difference));
      gap_ = closes ? 0.0 : std::max(0.0, gap_ - 2.0 * difference * time);
    } else {
      force = 2.0 * difference * left_.impedance() * right_.impedance() / (left_.impedance() + right_.impedance());
      safe_ = 1.0;
    }
    const double slowing = force * (1.0 / mass_of(left_) + 1.0 / mass_of(right_));
    overlap_ += (rate_.left - rate_.right - 0.5 * slowing * time) * time;
    rate_.left -= force / mass_of(left_) * time;
    rate_.right += force / mass_of(right_) * time;
    left_.reflect(time, left_.front().velocity - force / left_.impedance());
    right_.reflect(time, right_.front().velocity + force / right_.impedance());
  }

  /// The rods part and cannot touch any more.
  [[nodiscard]] bool over() {
    if (gap_ <= 0.0 || rate_.left >= rate_.right) return false;
    if (safe_ > 0.0) safe_ = -reach();
    return overlap_ < safe_;
  }

  /// ε. Sets the waves back to when the undeformed ends parted.
  double finish(double speed) {
    rate_ = {2.0 * left_.mean(), 2.0 * right_.mean()};
    left_.shift(-0.5 * rate_.left);
    right_.shift(-0.5 * rate_.right);
    const double receding = rate_.right - rate_.left, time = overlap_ / receding;
    left_.rotate(time);
    right_.rotate(time);
    return receding / speed;
  }

  [[nodiscard]] RodWave& left() { return left_; }
  [[nodiscard]] RodWave& right() { return right_; }

 private:
  static double mass_of(const RodWave& wave) { return wave.transit() * wave.impedance(); }

  /// How far the ends can swing towards each other.
  [[nodiscard]] double reach() const { return left_.swing().greatest - right_.swing().least; }

  struct Rates {
    double left = 0.0, right = 0.0;
  };
  RodWave left_, right_;
  Rates rate_;            // of the centres
  double overlap_ = 0.0;  // that the undeformed rods would have
  double gap_ = 0.0;      // between the ends
  double safe_ = 1.0;     // overlap below which they cannot touch; positive: not known
};

}  // namespace

RodWaves::RodWaves(const std::vector<Rod>& rods, const RodChainOptions& options)
    : most_(static_cast<std::size_t>(options.pieces)), poll_(options.poll) {
  for (const Rod& rod : rods) {
    const RodMeasures measures(rod);
    waves_.emplace_back(measures.transit, measures.impedance);
  }
}

void RodWaves::age(std::size_t rod, double time, double kept) {
  waves_[rod].rotate(time);
  waves_[rod].scale(std::sqrt(kept));
}

RodMeeting RodWaves::meet(std::size_t left, std::size_t right, double speed) {
  RodWave other = waves_[right];
  other.rotate(other.transit());  // to its left end
  Encounter encounter(waves_[left], other, speed);
  constexpr long most_changes = 20'000'000, patience = 1000;
  for (long changes = 0; !encounter.over(); ++changes) {
    if (changes == most_changes) {
      throw NotConverged("rod_chain: two rods are still close after " + std::to_string(changes) +
                         " changes of the waves at their ends (they vibrate much faster than they move)");
    }
    if (poll_ && changes % patience == 0) poll_();
    encounter.advance();
  }
  RodMeeting result;
  result.restitution = encounter.finish(speed);
  encounter.right().rotate(other.transit());
  for (RodWave* wave : {&encounter.left(), &encounter.right()}) result.unresolved += wave->merge(most_);
  waves_[left] = encounter.left();
  waves_[right] = encounter.right();
  return result;
}

}  // namespace stoss
