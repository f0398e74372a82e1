#pragma once

#include <vector>

namespace stoss::bodies::plate {

/// A layer of a plate in the units of the plate.
struct Sheet {
  double thickness;         ///< finite
  double shear_modulus;     ///< μ
  double pressure_modulus;  ///< λ + 2μ
  double density;
  int kind = 0;  ///< layers of one kind lose energy alike

  friend bool operator==(const Sheet&, const Sheet&) = default;
};

/// What the lower face of sheets may do.
enum class Floor {
  free,          ///< of a whole plate
  symmetric,     ///< the middle of one that is the mirror image of itself, in motions that are: it moves along itself
  antisymmetric  ///< the same in the other motions: it moves along the depth
};

/// Layers from the top down.
struct Sheets {
  std::vector<Sheet> all;
  Floor floor = Floor::free;
  double share = 1.0;  ///< of a load on the upper face of the plate that acts on these, and of their answer in its
};

/// A plate, or, if it is its own mirror image, its upper half in the two kinds of motion: modes of the one hardly
/// differ from those of the other where waves run along each face by itself.
[[nodiscard]] std::vector<Sheets> parts_of(const std::vector<Sheet>& plate);

}  // namespace stoss::bodies::plate
