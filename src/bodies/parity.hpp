#pragma once

namespace stoss::bodies {

/// Which of two blocks of displacements at points on both sides of the axis, and of the forces that drive them.
enum class Parity {
  normal_even,  ///< (x even | y odd)
  along_even    ///< (y even | x odd)
};

}  // namespace stoss::bodies
