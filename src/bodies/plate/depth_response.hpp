#pragma once

#include <cstddef>
#include <vector>

#include "bodies/plate/pair_number.hpp"
#include "bodies/plate/sheet.hpp"
#include "bodies/plate/small_matrix.hpp"

namespace stoss::bodies::plate {

/// Displacement (u, w) at some depths by that of the upper face, q(d) = T(d) q(0), at one wave number and one z = ω²
/// while the lower face is free; u along the wave number, w into the depth.
template <typename T>
struct Depths {
  using Matrix = SmallMatrix<T, 2>;
  Matrix stiffness;              ///< of the upper face
  std::vector<Matrix> transfer;  ///< T of each depth
};

/// Finds them for one of the parts of a plate.
///
/// From the lower face up the stiffness S of all that lies below is known, and a thin slab on it moves its lower face
/// by
///
///   q_lower = (1 + G S)⁻¹ F q_upper
///
/// (ThinSlab). So nothing that decays into the depth, or grows there, is found as a difference, and no digits are lost
/// in bending.
class DepthResponse {
 public:
  /// @param depths below the upper face of the whole plate, in any order
  DepthResponse(const Sheets& part, const std::vector<double>& depths);

  /// @param deepest below this depth nothing moves
  template <typename T>
  [[nodiscard]] Depths<T> at(double wave_number, T z, double deepest) const;

 private:
  struct Piece {
    std::size_t sheet;
    double thickness;
  };
  struct Place {
    std::size_t pieces;  ///< that lie above it
    double along, into;  ///< signs of u and w there
  };
  Sheets part_;
  std::vector<Piece> pieces_;  ///< from the top down
  std::vector<Place> places_;  ///< of the depths
};

}  // namespace stoss::bodies::plate
