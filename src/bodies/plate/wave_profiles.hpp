#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "bodies/plate/plate_waves.hpp"
#include "bodies/plate/sheet.hpp"
#include "bodies/plate/small_algebra.hpp"

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

  /// Of depths on the upper face, or its mirror image, transfers alone, which are the same at all z.
  [[nodiscard]] bool are_on_faces() const;
  [[nodiscard]] Depths<double> on_faces() const;

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

/// kz at which e^{−kz} is below 1e-17.
inline constexpr double deepest_phase = 40.0;

/// How one wave number of a quadrature moves a plate at some depths: u_r and u_z of each, with the shapes J₁(kr) and
/// J₀(kr), sin kx and cos kx.
struct WaveProfiles {
  double wave_number;
  Eigen::MatrixXd kept;    ///< per coordinate of each kept wave
  Eigen::VectorXd others;  ///< per load, by the slow answer of the waves that are not kept
};

/// A wave on the surface.
struct Amplitude {
  double omega;
  double normal, along;  ///< as in PlaneWaves
};

/// Makes them.
///
/// The profile of a wave is the displacement at its frequency by that of the surface. What the others add is the mean
/// value over a circle z = ρe^{iα} of the answer to a load less that of the kept waves,
///
///   T(z) Q⁻¹(z) − Σ_kept T(ω_l²) φφᵀ/(ω_l² − z),
///
/// in which low frequencies, where answers are as good as infinite, are none (Branches).
class ProfileMaker {
 public:
  ProfileMaker(const Lamina& plate, const std::vector<double>& depths);

  /// @param waves  the kept ones of all parts, of each part those below the cutoff, as plane_waves has them
  [[nodiscard]] WaveProfiles of(const WaveNumber& number, const std::vector<Amplitude>& waves, double cutoff) const;

  /// Of a wave number of which none are kept.
  [[nodiscard]] WaveProfiles of(const WaveNumber& number) const;

 private:
  [[nodiscard]] const std::vector<DepthResponse>& responses(double wave_number) const;

  Lamina plate_;
  Eigen::Index rows_;
  std::vector<DepthResponse> whole_, halves_;  ///< of the parts of the plate
};

}  // namespace stoss::bodies::plate
