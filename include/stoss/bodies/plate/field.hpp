#pragma once

#include <memory>
#include <span>

#include "stoss/bodies/half_space/field.hpp"
#include "stoss/bodies/plate.hpp"
#include "stoss/body/body.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::plate {

using half_space::Field;
using half_space::PlaneGrid;

/// Displacement inside a plate or a strip during an impact, from the upper face, depth 0, to the lower one: the kept
/// waves as they move, and all others in their static answer to the forces,
///
///   u = Σ_kept Q u_l + Σ_others Q_static[F] u_l,   u_z = −A_l g_z(z) J₀(kr), u_r = −A_l g_r(z) J₁(kr)
///
/// (in a strip cos kx and sin kx) for the wave l of wave number k, whose g follow from the layers
/// (docs/theory/plates.md). It is good where the time since the first force and that of a shear wave from the axis to
/// the point are together shorter than the contact that the plate was made for.
class PlateField {
 public:
  /// @param body    the plate or strip that was made of `plate` or `strip`
  /// @param contact the contact points of the impact, in the unit of length of the plate
  /// @throws InvalidInput for points outside it, empty or not finite arrays, a body that is not that plate, and where
  ///         waves times depths are more than are computed
  PlateField(const Plate& plate, const Body& body, const ContactPoints& contact, PlaneGrid points,
             const Poll& poll = {});
  PlateField(const Strip& strip, const Body& body, const ContactPoints& contact, PlaneGrid points,
             const Poll& poll = {});

  /// The field at one instant, from Snapshot::coordinate and Snapshot::node_force; with their rates of change, its
  /// velocity.
  /// @throws InvalidInput for arrays of other lengths than the body's modes and the grid's nodes, or not finite
  [[nodiscard]] Field at(std::span<const double> coordinate, std::span<const double> node_force,
                         const Poll& poll = {}) const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace stoss::bodies::plate
