#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "contact/residual/residual_motion.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

/// The modes of all bodies that are not kept, part by part in series under one force, u = Σ u_k, u_k = W′_k f + h_k. In
/// lossy bodies what the kicks leave out of the kept modes is a further part, A f, which loses nothing; and so are
/// coats.
class Residuals {
 public:
  Residuals(const Contact& contact, const ContactGrid& grid, ResidualMotion::Inertia inertia, double step,
            const Poll& poll);

  /// Σ W′_k + A
  [[nodiscard]] std::vector<double> compliance(const Poll& poll) const;

  /// Begins a step: h = Σ h_k, the displacement without force.
  const std::vector<double>& predict();

  /// Ends it with the force f, of which the first `count` may be other than 0, and the displacement u.
  void move(const std::vector<double>& displacement, const std::vector<double>& force, std::size_t count);

  /// Whether all parts are, at the displacement u, and their rest after it (ResidualMotion).
  [[nodiscard]] bool is_still(const std::vector<double>& displacement, double negligible) const;
  void rest(double time);

  /// Of a lossy contact: the force that would displace the modes of one body at once as they are; empty of a rigid one.
  [[nodiscard]] std::vector<double> crept_force(std::size_t body) const;

  /// What the material of the first and of the second body has taken.
  [[nodiscard]] std::array<double, 2> dissipated() const;

  /// Energy of the springs of the first and of the second lossy body; 0 of others.
  [[nodiscard]] std::array<double, 2> stored() const;

 private:
  std::vector<ResidualMotion> parts_;
  std::vector<std::size_t> bodies_;  // of each
  std::size_t coats_ = 0;            // the last of them
  bool lossy_;
  bool joined_ = false;                            // one part, which has all there is
  std::vector<double> kicks_;                      // A, nodes × nodes; in lossy bodies, empty if it is 0
  std::vector<double> free_;                       // of lossy bodies
  std::vector<std::vector<double>> displacement_;  // of each part
};

}  // namespace stoss
