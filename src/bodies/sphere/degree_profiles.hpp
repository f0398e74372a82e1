#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "bodies/sphere/radial_field.hpp"
#include "stoss/body/body.hpp"

namespace stoss::bodies::sphere {

/// Displacement and stress of every degree n of a sphere at given radii,
///
///   w_n u_static[p_n, t_n] + Σ_kept (Q − w_n Q_static) u_l,   Q_static = (g_U U + g_V V)/ω²,
///
/// with the generalised loads of the ring forces F_i (in units mc²/R)
///
///   g_U = −Σ_i F_i cos θ_i P_n,   g_V = Σ_i F_i sin θ_i dP_n/dθ,
///
/// p = (2n+1) g_U/3 and t = (2n+1) g_V/(3L), L = n(n+1), and w_n = 1 below the Nyquist degree π/h of the rings, ½ at it
/// and 0 beyond, as in Residual.
class DegreeProfiles {
 public:
  static constexpr std::size_t components = 6;  // those of RadialField, in its order
  static constexpr int block = 32;              // of degrees
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using Profile = std::array<Matrix, components>;  // radii × block
  /// w_n g_U and w_n g_V of all degrees up to Nyquist and of all kept ones.
  struct Loads {
    std::vector<double> radial, tangential;
  };

  /// @throws InvalidInput if the modes of the body are not those of a sphere of this Poisson's ratio
  DegreeProfiles(double poisson, const Body& body, const ContactPoints& contact, std::vector<double> radius,
                 const Poll& poll);

  /// Number of kept modes, in the order of Body::groups.
  [[nodiscard]] Eigen::Index modes() const { return modes_; }
  [[nodiscard]] Eigen::Index rings() const { return ring_.size(); }

  /// Number of degrees that count at each radius; the others are smaller by 1e-20.
  [[nodiscard]] const std::vector<int>& degrees() const { return degrees_; }

  [[nodiscard]] Loads loads(const Eigen::ArrayXd& ring_force, const Poll& poll) const;

  /// Fills radii × block values of each component for the degrees from `first`.
  void evaluate(const Eigen::VectorXd& coordinate, const Loads& loads, int first, const Poll& poll,
                Profile& profile) const;

 private:
  /// The kept modes of one degree: U/ω² and V/ω², and their fields in rows of components × radii.
  struct KeptDegree {
    int degree;
    Eigen::Index first;  // of its modes in the coordinates
    Eigen::VectorXd radial, tangential;
    Eigen::MatrixXd field;
  };

  void keep(const Body& body, const ModeGroup& group, const Poll& poll);
  void add_static(const Loads& loads, int first, const Poll& poll, Profile& profile) const;
  void add_kept(const Eigen::VectorXd& coordinate, const Loads& loads, int first, Profile& profile) const;

  double poisson_;
  Eigen::ArrayXd ring_;  // θ_i
  int nyquist_;
  std::vector<double> radius_;
  std::vector<int> degrees_;
  std::vector<KeptDegree> kept_;
  Eigen::Index modes_ = 0;
};

}  // namespace stoss::bodies::sphere
