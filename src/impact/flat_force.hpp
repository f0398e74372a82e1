#pragma once

#include <vector>

#include "stoss/contact/contact.hpp"

namespace stoss {

/// Period of the highest modes that are kept, in which their sum swings about a force that jumps; at most the
/// time in which a wave runs through the shorter body.
[[nodiscard]] double ripple_time(const Contact& contact);

/// The force between flat ends, which jumps: no sum of modes follows a jump, and swings about it by 9 % of it at any
/// cutoff (Gibbs). Two means over one period of the swing, one after the other, leave 0.5 % of it.
class FlatForce {
 public:
  /// @param impulse after each step since the first force
  FlatForce(const std::vector<double>& impulse, double step, double ripple_time);

  /// Greatest of the means.
  [[nodiscard]] double greatest() const { return greatest_; }

  /// Step of the last force of more than 2 % of the greatest: below, ends may touch, and only the modes swing.
  [[nodiscard]] long last() const { return last_; }

  /// Separate periods of such forces.
  [[nodiscard]] int contacts() const { return contacts_; }

 private:
  double greatest_ = 0.0;
  long last_ = 0;
  int contacts_ = 0;
};

}  // namespace stoss
