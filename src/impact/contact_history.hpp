#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss {

/// Maximum value of a smooth quantity that is sampled at equal times: the top of the parabola through the maximum
/// sample and its neighbours.
class Peak {
 public:
  void add(double sample) {
    if (before_ <= last_ && last_ > sample) {
      const double bend = before_ - 2.0 * last_ + sample, slope = sample - before_;
      top_ = std::max(top_, last_ - slope * slope / (8.0 * bend));
    }
    top_ = std::max(top_, sample);
    before_ = last_;
    last_ = sample;
  }

  /// `otherwise` if there was no sample.
  [[nodiscard]] double value(double otherwise) const { return top_ > lowest ? top_ : otherwise; }

 private:
  static constexpr double lowest = std::numeric_limits<double>::lowest();
  double before_ = std::numeric_limits<double>::infinity();  // so that a first sample is no top
  double last_ = std::numeric_limits<double>::infinity();
  double top_ = lowest;
};

/// What an impact was like, as its steps add up: when bodies touched, how hard and how far.
class ContactHistory {
 public:
  explicit ContactHistory(double step) : step_(step) {}

  /// Adds the mean force of a step.
  void add_force(double mean_force);

  /// Adds the instant after it.
  /// @param touching    whether there is contact
  /// @param since_touch steps since the touch, if contact is first noticed at this instant
  void add(bool touching, double since_touch);

  /// Adds an instant in contact.
  void add_extent(double compression, double half_width);

  /// Whether the modes' energies are to be sampled at this instant: they change slowly between steps.
  [[nodiscard]] bool samples_energy() const { return in_contact_ && (contact_steps_ - 1) % sampling == 0; }

  [[nodiscard]] bool in_contact() const { return in_contact_; }
  [[nodiscard]] bool has_touched() const { return contacts_ > 0; }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] long steps_apart() const { return steps_ - last_step_; }  ///< since the last contact
  [[nodiscard]] double time() const { return static_cast<double>(steps_) * step_; }
  [[nodiscard]] double impulse() const { return impulse_; }

  /// Number of samples of the modes' energies, at least 1.
  [[nodiscard]] double samples() const;

  /// Fills times, contacts, maxima and the error of the momentum.
  /// @param velocity_before, velocity_after of the motion along the normal
  void fill(const Contact& contact, double velocity_before, double velocity_after, Impact& impact) const;

  /// Every fourth step is enough for the mean of the modes' energies, and for what is left of a vibration that decays.
  static constexpr long sampling = 4;

 private:
  [[nodiscard]] double impulse_time() const;

  double step_;
  long steps_ = 0;
  bool in_contact_ = false;
  int contacts_ = 0;
  double first_contact_ = 0.0;  // times
  double last_contact_ = 0.0;
  long contact_steps_ = 0;
  long last_step_ = 0;   // of the last contact
  long first_step_ = 0;  // of the first force
  double impulse_ = 0.0;
  std::vector<double> impulse_history_;  // after each step since the first force
  Peak force_peak_, compression_peak_, half_width_peak_;
};

}  // namespace stoss
