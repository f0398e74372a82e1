#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>

#include "bodies/surface/medium_surface.hpp"
#include "stoss/bodies/half_space/field.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies {

/// Amplitudes of a displacement at a depth: u_z goes with the shape along the surface, cos kx or J₀(kr), and u_x, u_r
/// with sin kx or J₁(kr).
struct DepthProfile {
  double lateral;
  double normal;
};

/// Throws InvalidInput for points that are not below a surface, or not of a depth that is there.
void require_points(const half_space::PlaneGrid& points, const ContactPoints& contact, double deepest);

/// Σ over wave numbers of (profile in the depth) × (shape along the surface): products of matrices, depths × wave
/// numbers by wave numbers × distances, a block of wave numbers at a time.
class ProfileSum {
 public:
  /// All three must live as long as the sum.
  ProfileSum(const MediumSurface& medium, const half_space::PlaneGrid& points, const Poll& poll);

  /// Goes on with the next wave number.
  void start(double wave_number);

  /// @param profile DepthProfile of the depth of a number
  template <typename Profile>
  void add(double amplitude, const Profile& profile) {
    for (Index i = 0; i < depths(); ++i) {
      const DepthProfile at = profile(static_cast<std::size_t>(i));
      if (at.normal == 0.0 && at.lateral == 0.0) continue;
      reached_ = std::max(reached_, i + 1);
      lateral_profile_(i, row_) += amplitude * at.lateral;
      normal_profile_(i, row_) += amplitude * at.normal;
    }
  }

  /// Of all of them; once.
  [[nodiscard]] half_space::Field field();

 private:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using Index = Eigen::Index;
  static constexpr Index block = 64;
  [[nodiscard]] Index depths() const { return static_cast<Index>(points_.depth.size()); }
  [[nodiscard]] Index distances() const { return static_cast<Index>(points_.distance.size()); }
  void flush();

  const MediumSurface& medium_;
  const half_space::PlaneGrid& points_;
  const Poll& poll_;
  Matrix lateral_, normal_, lateral_profile_, normal_profile_, lateral_shape_, normal_shape_;
  Index row_ = -1;
  Index reached_ = 0;  // depths with a profile
};

}  // namespace stoss::bodies
