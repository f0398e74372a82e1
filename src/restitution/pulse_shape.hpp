#pragma once

#include <vector>

#include "stoss/contact/contact.hpp"

namespace stoss {

/// The force of one impact at its steps, R/c after first touch.
struct ForceHistory {
  double step = 0.0;
  std::vector<double> time, force;

  /// Between steps, on a line; 0 before and after.
  [[nodiscard]] double at(double instant) const;

  /// Its mean over a window around each step.
  [[nodiscard]] ForceHistory smoothed(double window) const;

  /// First and last instant at which it is above a force; both 0 if there is none.
  struct Interval {
    double begin = 0.0, end = 0.0;
    [[nodiscard]] double length() const { return end - begin; }
  };
  [[nodiscard]] Interval above(double least) const;

  [[nodiscard]] double peak_time() const;
  [[nodiscard]] double impulse(double until) const;

  /// |∫ F e^{−iωt} dt|
  [[nodiscard]] double amplitude(double omega) const;
};

/// ω at which the amplitude falls to 1/√2 of that at 0, and its first minimum, refined between grid points.
struct SpectrumMarks {
  double corner = 0.0, null = 0.0;
};
[[nodiscard]] SpectrumMarks marks(const ForceHistory& history, double duration);

/// Hertz' pulse of these bodies, from first touch on; without instants where they do not touch on a circle.
[[nodiscard]] ForceHistory hertz_pulse(const Contact& contact, double speed);

/// Greatest difference of the first at the instants of the second, over the maximum of the second; NaN if it has none.
[[nodiscard]] double difference(const ForceHistory& history, const ForceHistory& model);

/// The same from sin^{3/2} of the same maximum and duration.
[[nodiscard]] double difference_from_sine(const ForceHistory& history, const ForceHistory::Interval& contact);

}  // namespace stoss
