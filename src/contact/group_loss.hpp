#pragma once

#include <cstddef>
#include <optional>

#include "relaxation/oscillator.hpp"
#include "stoss/contact/contact.hpp"

namespace stoss {

/// How the modes of a group of a contact lose energy, in the time of the contact: all alike, or of layers that lose it
/// in different ways each by its own rates. Refers to the contact.
class GroupLoss {
 public:
  GroupLoss(const Contact& contact, std::size_t group);

  /// Whether they have rates; else a loss time, or none.
  [[nodiscard]] bool relaxes() const { return layers_ || !same_.rate.empty(); }

  /// Whether each mode has rates of its own.
  [[nodiscard]] bool is_of_layers() const { return layers_.has_value(); }

  /// The most rates of a mode.
  [[nodiscard]] std::size_t terms() const { return layers_ ? layers_->terms() : same_.rate.size(); }

  [[nodiscard]] Rates rates(std::size_t index) const;
  [[nodiscard]] double loss_time() const { return loss_time_; }

  /// Frequency and damping with which the kicks of a mode are weakened where a body of the contact has a loss time
  /// (numeric::stable_kicks): γ is that of dashpots alone. @param step Δt
  [[nodiscard]] FreeMode dashpot(std::size_t index, double step) const;

 private:
  const ModeGroup& group_;
  double loss_time_;
  Rates same_;
  std::optional<MixedRates> layers_;
};

}  // namespace stoss
