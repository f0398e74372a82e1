#pragma once

#include <Eigen/Sparse>
#include <array>
#include <limits>
#include <vector>

#include "plasticity.hpp"

namespace yield_study {

/// A displacement of a node, number 2·node of r and 2·node + 1 of z: `factor` times an unknown, or 0.
struct Freedom {
  int unknown = -1;  ///< -1: held
  double factor = 1.0;
};

struct Mesh {
  std::vector<Eigen::Vector2d> nodes;        ///< (r, z)
  std::vector<std::array<int, 4>> elements;  ///< corners, counter-clockwise in the (r, z) plane
};

/// Energies since the start, lengths³ times stresses. What hardening keeps counts as dissipated.
struct Energies {
  double stored, dissipated;
};

/// An axisymmetric body of bilinear quadrilaterals at small strain, whose dilatation is the mean over each element (the
/// B-bar method of Hughes), so that plastic flow without change of volume does not lock.
class Body {
 public:
  /// @param freedoms of the displacements; several of them may share an unknown
  Body(Mesh mesh, const Material& material, std::vector<Freedom> freedoms);

  /// Adds k to the stiffness of one unknown: a spring.
  void add_spring(int unknown, double k);

  /// Internal forces and tangent for these unknowns, from the state that was kept last.
  void assemble(const Eigen::VectorXd& unknowns);
  /// Keeps the state that was assembled last.
  void keep();
  /// Goes on to these unknowns: keeps the state, and has the internal forces, but not the tangent.
  void follow(const Eigen::VectorXd& unknowns);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const Freedom& freedom(int node, int direction) const {
    return freedoms_[static_cast<std::size_t>(2 * node + direction)];
  }
  [[nodiscard]] const Eigen::VectorXd& forces() const { return forces_; }
  /// Lower triangle of the tangent.
  [[nodiscard]] Eigen::SparseMatrix<double>& tangent() { return tangent_; }
  [[nodiscard]] Energies energies() const;
  /// The volume by unknown, ∫N dV of its shape function: the mass, lumped, at a density of 1.
  [[nodiscard]] const Eigen::VectorXd& volumes() const { return volumes_; }
  /// The kept stress at a Gauss point, 0 to 3, of an element, and the sum of the plastic strain there.
  [[nodiscard]] const Stress& stress(int element, int point) const { return point_(element, point).kept; }
  [[nodiscard]] double slip(int element, int point) const { return point_(element, point).slip; }
  [[nodiscard]] Eigen::Vector2d place(int element, int point) const { return point_(element, point).place; }
  /// Of a node, 0 along r or 1 along z.
  [[nodiscard]] double displacement(const Eigen::VectorXd& unknowns, int node, int direction) const;

 private:
  struct Point {
    Eigen::Matrix<double, 4, 8> strain;  ///< strains by the displacements of the corners
    Eigen::Vector2d place;
    double volume;
    Stress kept, now;
    double slip, slip_now;
  };
  [[nodiscard]] const Point& point_(int element, int point) const {
    return points_[static_cast<std::size_t>(4 * element + point)];
  }
  void prepare();
  void prepare_pattern();
  [[nodiscard]] Eigen::Matrix<double, 8, 1> of_element(std::size_t element, const Eigen::VectorXd& unknowns) const;

  Mesh mesh_;
  Material material_;
  std::vector<Freedom> freedoms_;
  int size_ = 0;
  std::vector<Point> points_;
  std::vector<std::array<Freedom, 8>> of_elements_;
  std::vector<std::array<int, 64>> places_;  ///< where in the tangent's values an element's stiffness goes, or -1
  std::vector<std::pair<int, double>> springs_;
  Eigen::SparseMatrix<double> tangent_;
  Eigen::VectorXd kept_, now_, forces_, volumes_;
};

}  // namespace yield_study
