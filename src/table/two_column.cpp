// Rows as far apart as a chord in v stays near the function. How far it is off is looked at in points of each cubic.
#include "stoss/table/two_column.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "table/arguments.hpp"

namespace stoss {
namespace {

constexpr int points = 16;            // of each cubic, or of its part between two rows
constexpr double share = 0.99;        // of the error: between the points a chord is off by up to 0.4 % more
constexpr double least_error = 1.01;  // of the error of the function, to leave something for the interpolation

/// Chords in v of a function, by ln v.
class Chords {
 public:
  Chords(const RestitutionFunction& function, double error) : function_(function), error_(share * error) {
    for (const double each : function.values().speeds) knots_.push_back(std::log(each));
  }

  [[nodiscard]] double begin() const { return knots_.front(); }
  [[nodiscard]] double end() const { return knots_.back(); }

  /// The ends of the range are exact.
  [[nodiscard]] double speed(double logarithm) const {
    if (logarithm >= end()) return function_.fastest();
    return logarithm <= begin() ? function_.slowest() : std::exp(logarithm);
  }

  [[nodiscard]] double value(double logarithm) const { return function_.value(inside(speed(logarithm))); }

  /// The furthest end of a chord that begins here and stays near enough.
  [[nodiscard]] double next(double left, double step) const {
    if (near(left, end())) return end();
    double far = std::min(left + step, end());
    while (!near(left, far)) far = left + 0.5 * (far - left);
    // Doubled until it is not near enough, then halved between.
    double width = far - left;
    while (far + width < end() && near(left, far + width)) {
      far += width;
      width *= 2.0;
    }
    double beyond = std::min(far + width, end());
    for (int i = 0; i < 12; ++i) {
      const double middle = 0.5 * (far + beyond);
      (near(left, middle) ? far : beyond) = middle;
    }
    return far;
  }

 private:
  [[nodiscard]] double inside(double speed) const {
    return std::clamp(speed, function_.slowest(), function_.fastest());
  }

  [[nodiscard]] bool near(double left, double right) const {
    const double from = speed(left), to = speed(right), low = value(left), high = value(right);
    const auto near_at = [&](double logarithm) {
      const double v = inside(speed(logarithm));
      const Estimate here = function_(v);
      const double chord = low + (high - low) * (v - from) / (to - from);
      return std::abs(chord - here.value) + here.error <= error_ + (1.0 - share) * here.error;
    };
    auto knot = std::upper_bound(knots_.begin(), knots_.end(), left);
    for (double begin = left; begin < right; ++knot) {
      const double end = knot == knots_.end() ? right : std::min(*knot, right);
      for (int i = 0; i <= points; ++i) {
        if (!near_at(begin + (end - begin) * (i + 0.5) / (points + 1))) return false;
      }
      begin = end;
    }
    return true;
  }

  const RestitutionFunction& function_;
  double error_;
  std::vector<double> knots_{};
};

}  // namespace

std::string two_column(const RestitutionFunction& function, double error, double scale) {
  const auto [slowest, fastest] = table::speed_range(function.slowest(), function.fastest(), scale);
  const double allowed = least_error * function.greatest_error();
  if (!(error >= allowed) || !std::isfinite(error)) {
    throw InvalidInput::out_of_range("error", shown(error), shown(allowed) + " or more",
                                     "1.01 of the maximum error of the function");
  }
  const Chords chords(function, error);
  const auto row = [](double speed, double value) { return shown(speed) + " " + shown(value) + "\n"; };
  std::string text = row(slowest, chords.value(chords.begin()));
  double step = 0.1 * (chords.end() - chords.begin());
  for (double at = chords.begin(); at < chords.end();) {
    const double next = chords.next(at, step);
    step = next - at;
    at = next;
    text += row(at < chords.end() ? chords.speed(at) * scale : fastest, chords.value(at));
  }
  return text;
}

}  // namespace stoss
