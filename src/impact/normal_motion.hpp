#pragma once

namespace stoss {

/// The centres of two bodies along the normal under the force F between them, as one mass, mẌ = −F, by kick and drift.
///
/// Between two steps the velocity is that before the kick that is due, whose two halves end one step and begin the
/// next. What is read out has half of it.
class NormalMotion {
 public:
  NormalMotion(double mass, double step, double speed) : mass_(mass), step_(step), velocity_(speed) {}

  /// X at the start, as a compression: the approach since first touch, kept instead of X for its digits at small speed.
  void start(double compression) { compression_ = compression; }

  /// Makes this the force of the kick that is due.
  void load(double force) { force_ = force; }

  /// Takes half of the kick that is due out of the velocity: for the very first step, which has only the other half.
  void begin() { velocity_ += 0.5 * force_ * step_ / mass_; }

  /// Kicks and drifts by one step.
  void advance() {
    velocity_ -= force_ * step_ / mass_;
    compression_ += velocity_ * step_;
  }

  /// Drifts by any time at once, with no force due.
  void fly(double time) { compression_ += velocity_ * time; }

  [[nodiscard]] double compression() const { return compression_; }
  [[nodiscard]] double force() const { return force_; }
  [[nodiscard]] double velocity() const { return velocity_ - 0.5 * force_ * step_ / mass_; }
  [[nodiscard]] double energy() const { return 0.5 * mass_ * velocity() * velocity(); }

 private:
  double mass_, step_, velocity_;
  double compression_ = 0.0, force_ = 0.0;
};

}  // namespace stoss
