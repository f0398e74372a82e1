#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "contact/coupled/coupled_contact.hpp"
#include "contact/residual/residuals.hpp"
#include "impact/kept_modes.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss {

/// All modes of a contact in which forces along x and along y each move the other: those that are kept, and what
/// answers for those that are not. Points on both sides of the axis have two blocks of them, of forces that are even in
/// y along x, and along y (Body::along); rings around it have one, whose y points outward.
class CoupledModes {
 public:
  /// @param along one contact for each block (contacts_along, contact_outward)
  CoupledModes(const std::vector<Contact>& along, const ContactPoints& points, const FixedResolution& resolution,
               const Poll& poll);

  /// How many values a direction has: points on both sides, or rings.
  [[nodiscard]] std::size_t size() const { return blocks_.size() * points_; }

  /// The displacements at all points by forces of a step.
  [[nodiscard]] CoupledCompliance compliance(const Poll& poll) const;

  void set(const State& state) { blocks_.front().modes.set(state.coordinate, state.momentum); }
  void begin();
  void advance();

  /// Adds where the kept modes put the points.
  void add_places(Eigen::VectorXd& x, Eigen::VectorXd& y);

  /// Begins a step of the others: adds how they are displaced without force, into the body and against y.
  void add_free_displacement(Eigen::VectorXd& x, Eigen::VectorXd& y);

  /// Ends it with the forces and displacements of all points, and makes these the forces of the kick that is due.
  void load(const Eigen::VectorXd& force, const Eigen::VectorXd& friction, const Eigen::VectorXd& moved_x,
            const Eigen::VectorXd& moved_y);

  void accumulate_energy();

  /// Upper bound of the displacement along x in free vibration.
  [[nodiscard]] double reach() const;

  /// Energies of the kept modes, of both bodies and of one; what its material has taken from all, and from those that
  /// are not kept; and what their springs hold.
  [[nodiscard]] double energy() const;
  [[nodiscard]] double vibration(int body) const;
  [[nodiscard]] double dissipated(int body) const;
  [[nodiscard]] double dissipated_above_cutoff() const;
  [[nodiscard]] double stored() const;

  [[nodiscard]] const KeptModes& first_block() const { return blocks_.front().modes; }

  /// Each mode, with energies as shares of the initial one. @param before of those of the first block; empty: at rest
  [[nodiscard]] std::vector<ModeEnergy> ledger(const std::vector<double>& before, double samples, double initial) const;

 private:
  struct Block {
    Block(const Contact& along, const ContactGrid& grid, const FixedResolution& resolution, const Poll& poll);
    [[nodiscard]] std::size_t begin(int body) const { return body == 0 ? 0 : contact.first_groups; }
    [[nodiscard]] std::size_t end(int body) const { return body == 0 ? contact.first_groups : contact.groups.size(); }

    Contact contact;
    KeptModes modes;
    Residuals residuals;
    std::vector<double> force, displacement;  // of both directions at all points
  };

  std::size_t points_;
  std::vector<Block> blocks_;
};

}  // namespace stoss
