#include "vibration/rod_wave.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// How far the displacement φ is off at most when two pieces become one of their mean.
double shift_by_merging(const RodWave::Piece& a, const RodWave::Piece& b) {
  return a.duration * b.duration / (a.duration + b.duration) * std::abs(a.velocity - b.velocity);
}

}  // namespace

RodWave::RodWave(double transit, double impedance)
    : transit_(transit), impedance_(impedance), pieces_{{2.0 * transit, 0.0}} {}

void RodWave::set(std::vector<Piece> pieces) {
  double sum = 0.0;
  for (const Piece& piece : pieces) sum += piece.duration;
  constexpr double rounding = 1e-9;
  if (!(std::abs(sum - 2.0 * transit_) <= rounding * transit_)) {
    throw InvalidInput::out_of_range("pieces", "a period of " + shown(sum), shown(2.0 * transit_));
  }
  pieces_ = std::move(pieces);
  head_ = 0;
  tidy();
}

void RodWave::tidy() {
  pieces_.erase(pieces_.begin(), pieces_.begin() + static_cast<std::ptrdiff_t>(head_));
  head_ = 0;
  double sum = 0.0;
  for (const Piece& piece : pieces_) sum += piece.duration;
  for (Piece& piece : pieces_) piece.duration *= 2.0 * transit_ / sum;  // rounding would add up over many collisions
}

void RodWave::rotate(double time) {
  double rest = std::fmod(time, 2.0 * transit_);
  if (rest < 0.0) rest += 2.0 * transit_;
  while (rest > 0.0) {
    const Piece first = front();
    const double part = std::min(rest, first.duration);
    reflect(part, first.velocity);
    rest -= part;
  }
  tidy();
}

void RodWave::reflect(double time, double velocity) {
  Piece& first = pieces_[head_];
  if (time >= first.duration) {
    ++head_;
  } else {
    first.duration -= time;
  }
  if (head_ < pieces_.size() && pieces_.back().velocity == velocity) {
    pieces_.back().duration += time;
  } else if (time > 0.0) {
    pieces_.push_back({time, velocity});
  }
  constexpr std::size_t many = 1024;
  if (head_ > many && head_ > 2 * size()) {
    pieces_.erase(pieces_.begin(), pieces_.begin() + static_cast<std::ptrdiff_t>(head_));
    head_ = 0;
  }
}

void RodWave::shift(double velocity) {
  for (std::size_t i = head_; i < pieces_.size(); ++i) pieces_[i].velocity += velocity;
}

void RodWave::scale(double factor) {
  for (std::size_t i = head_; i < pieces_.size(); ++i) pieces_[i].velocity *= factor;
  if (factor == 0.0) pieces_ = {{2.0 * transit_, 0.0}};
}

void RodWave::reverse() {
  // w(−t), and of the other sign.
  tidy();
  std::reverse(pieces_.begin(), pieces_.end());
  scale(-1.0);
}

double RodWave::mean() const {
  double sum = 0.0;
  for (std::size_t i = head_; i < pieces_.size(); ++i) sum += pieces_[i].duration * pieces_[i].velocity;
  return sum / (2.0 * transit_);
}

double RodWave::energy() const {
  double sum = 0.0;
  for (std::size_t i = head_; i < pieces_.size(); ++i) {
    sum += pieces_[i].duration * pieces_[i].velocity * pieces_[i].velocity;
  }
  return impedance_ * sum;
}

RodWave::Swing RodWave::swing() const {
  const double average = mean();
  double phi = 0.0, least = 0.0, greatest = 0.0, integral = 0.0;
  for (std::size_t i = head_; i < pieces_.size(); ++i) {
    const double change = (pieces_[i].velocity - average) * pieces_[i].duration;
    integral += (phi + 0.5 * change) * pieces_[i].duration;
    phi += change;
    least = std::min(least, phi);
    greatest = std::max(greatest, phi);
  }
  const double middle = integral / (2.0 * transit_);
  return {-2.0 * middle, 2.0 * (least - middle), 2.0 * (greatest - middle)};
}

double RodWave::merge(std::size_t most) {
  tidy();
  double lost = 0.0;
  std::vector<double> cost, sorted;
  while (pieces_.size() > most) {
    cost.clear();
    for (std::size_t i = 0; i + 1 < pieces_.size(); ++i) cost.push_back(shift_by_merging(pieces_[i], pieces_[i + 1]));
    sorted = cost;
    const std::size_t surplus = pieces_.size() - most;
    const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(surplus - 1);
    std::nth_element(sorted.begin(), at, sorted.end());
    const double limit = *at;
    std::vector<Piece> merged;
    std::size_t done = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      Piece piece = pieces_[i];
      if (i < cost.size() && cost[i] <= limit && done < surplus) {
        const Piece& next = pieces_[i + 1];
        const double duration = piece.duration + next.duration;
        lost += impedance_ * cost[i] * std::abs(piece.velocity - next.velocity);
        piece = {duration, (piece.duration * piece.velocity + next.duration * next.velocity) / duration};
        ++done;
        ++i;
      }
      merged.push_back(piece);
    }
    pieces_ = std::move(merged);
  }
  return lost;
}

}  // namespace stoss
