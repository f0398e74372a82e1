#pragma once

#include <string>
#include <vector>

#include "bodies/plate/sheet.hpp"
#include "check.hpp"
#include "stoss/bodies/plate.hpp"

namespace stoss::bodies::plate {

/// A plate or a strip.
struct Given {
  Contour contour;
  std::vector<Layer> layers;  ///< from the top down
  double loss_time;

  [[nodiscard]] double speed() const;

  /// η in its own unit of time.
  [[nodiscard]] double own_loss_time() const { return in_own_time(loss_time, speed()); }

  /// "plate" or "strip"
  [[nodiscard]] const char* kind() const { return contour == Contour::ball ? "plate" : "strip"; }
};

[[nodiscard]] Given given_of(const Plate& plate);
[[nodiscard]] Given given_of(const Strip& strip);

/// Throws InvalidInput for one that there cannot be.
void require_given(const Given& given);

/// With its parameters.
[[nodiscard]] std::string name_of(const Given& given);

/// In units of c and ρ of the uppermost layer. Of a layer from whose lower face no echo is back in contacts of a
/// duration, only so much is there as that takes, and nothing below it.
[[nodiscard]] std::vector<Sheet> sheets_of(const Given& given, double duration);

/// Whether waves are not back from the other face of a plate of one material before a contact ends.
[[nodiscard]] bool is_thick(const Given& given, double duration);

}  // namespace stoss::bodies::plate
