#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <vector>

#include "law.hpp"
#include "stoss/body/body.hpp"

namespace adhesion_study {

/// The modes that are not kept, W, and the law on each ring: gap = rest + W f, f = A p(gap).
class Faces {
 public:
  Faces(Law law, Eigen::VectorXd area, Eigen::MatrixXd compliance, double tolerance);

  /// Forces at these gaps without them, from the last ones on, after steps of one length.
  /// @throws std::runtime_error where Newton's iteration fails
  const Eigen::VectorXd& force(const Eigen::VectorXd& rest);
  /// Energy of the law and of the modes that are not kept, at the last forces.
  [[nodiscard]] double energy() const;
  [[nodiscard]] const Eigen::VectorXd& gap() const { return gap_; }
  /// Largest compliance of an area: below 1 over the softening of the law there is one solution for any rest.
  [[nodiscard]] double largest_compliance() const;
  [[nodiscard]] long iterations() const { return iterations_; }
  [[nodiscard]] long factors() const { return factors_made_; }

 private:
  void factor();

  double tolerance_;  ///< of the gaps
  Law law_;
  Eigen::VectorXd area_, gap_, before_, earlier_, force_, slope_;
  Eigen::MatrixXd compliance_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
  bool factored_ = false;
  int known_ = 0;
  long iterations_ = 0, factors_made_ = 0;
};

/// The kept modes of a body at its rings: each group moves the rings in two shapes.
class Modes {
 public:
  Modes(const stoss::Body& body, const stoss::Surface& surface, double step);

  /// Displacement of the rings towards the wall.
  [[nodiscard]] Eigen::VectorXd place() const { return shape_.transpose() * amount_; }
  /// Forces on the rings, away from the wall, act for a time.
  void kick(const Eigen::VectorXd& force, double time);
  void rotate();
  [[nodiscard]] double energy() const;
  [[nodiscard]] Eigen::Index count() const { return omega_.size(); }

 private:
  struct Group {
    Eigen::Index begin, end, upper, lower;
  };
  double mass_;
  std::vector<Group> groups_;
  Eigen::ArrayXd omega_, cosine_, sine_, upper_, lower_, upper_over_, lower_over_;  ///< weights, and over ω
  Eigen::ArrayXd coordinate_, velocity_, next_;                                     ///< velocity over ω
  Eigen::MatrixXd shape_;                                                           ///< rows × rings
  Eigen::VectorXd amount_;
};

/// How an impact is computed.
struct Numerics {
  double width = 0.01;       ///< of a ring, radians
  double reach = 0.3;        ///< angle up to which there are rings
  double step = 0.002;       ///< R/c
  double far = 0.2;          ///< distance at which it starts and ends, R
  double tolerance = 1e-10;  ///< of the gaps, R
  double longest = 1000.0;   ///< R/c
  int returns = 1;           ///< after so many turns back to the wall the ball counts as caught
};

/// What became of an impact, energies as shares of ½mv².
struct Result {
  double restitution = 0.0;       ///< 0: caught
  double ringing = 0.0;           ///< of the modes, at the end
  double imbalance = 0.0;         ///< of the energy, at the end
  double largest = 0.0;           ///< imbalance at any time
  double push = 0.0, pull = 0.0;  ///< greatest forces, ER²
  double time = 0.0;              ///< as long as the force is above 10⁻³ of its greatest value, R/c
  double deepest = 0.0;           ///< way of the centre beyond the touch, R
  double compliance = 0.0;        ///< largest of the modes that are not kept, per area
  long steps = 0, iterations = 0, factors = 0;
  Eigen::Index rings = 0, modes = 0;
};

/// A sphere with its kept modes that meets a rigid wall under a law between the faces, in its R, c and ρ.
/// @param body a sphere, R = c = ρ = E = 1. @throws std::runtime_error where no forces are found
[[nodiscard]] Result meet(const stoss::Body& body, const Law& law, double speed, const Numerics& numerics);

/// The exponential law for a Tabor number and a work of adhesion w in ER, and numerics that resolve it.
struct Grain {
  double poisson = 0.2, tabor = 1.0, work = 1e-4, ratio = 0.5;
  double modes = 1.0;  ///< cutoff over the usual one
  double rings = 1.0;  ///< their number
  double steps = 1.0;  ///< their number at this cutoff

  [[nodiscard]] double modulus() const { return 1.0 / (1.0 - poisson * poisson); }
  [[nodiscard]] double range() const { return range_of(tabor, work, modulus(), ratio); }
  /// Sticking speed of Johnson, Kendall and Roberts.
  [[nodiscard]] double jkr_speed() const;
  [[nodiscard]] double cutoff() const;
  /// Largest slope at which the law softens.
  [[nodiscard]] double softening() const;
  [[nodiscard]] Numerics numerics(double speed) const;
};

}  // namespace adhesion_study
