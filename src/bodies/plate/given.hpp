#pragma once

#include <cstddef>
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
  std::vector<MaterialLoss> losses{};  ///< of each layer, where these differ

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

/// How layers lose energy that do so in different ways.
struct LayerKinds {
  std::vector<MaterialLoss> all;    ///< different ones, first that of the uppermost layer, in the plate's own time
  std::vector<std::size_t> of;      ///< number of that of each layer
  std::vector<double> stiffness{};  ///< of each, |M(iω)| over that of the uppermost

  [[nodiscard]] bool differ() const { return all.size() > 1; }
};

/// π over a contact, of plates that are made for contacts of about twice the time, in steps of a quarter of an octave:
/// it is the same where a duration differs by what it is estimated with.
[[nodiscard]] double turning_frequency(const Given& given, double duration);

/// Those of a plate at the turning frequency of a duration. Without losses of its layers one kind.
[[nodiscard]] LayerKinds kinds_of(const Given& given, double duration);

/// With its parameters.
[[nodiscard]] std::string name_of(const Given& given);

/// In units of c and ρ of the uppermost layer, with the moduli of E(0) times the stiffness of their kinds: where layers
/// relax in different ways, waves have the shapes of those which they have in the contact. Of a layer from whose lower
/// face no echo is back in contacts of a duration, only so much is there as that takes, and nothing below it.
[[nodiscard]] std::vector<Sheet> sheets_of(const Given& given, const LayerKinds& kinds, double duration);

/// Whether waves are not back from the other face of a plate of one material before a contact ends.
[[nodiscard]] bool is_thick(const Given& given, double duration);

}  // namespace stoss::bodies::plate
