#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/contact/wall.hpp"

namespace stoss {

class RadiatingTail;

/// What a body meets, as the force on each contact node, given where the kept modes alone would put the nodes.
class ContactResponse {
 public:
  virtual ~ContactResponse() = default;

  /// Advances by one step to the given positions x_dyn (beyond the wall where positive) and returns the node forces,
  /// pushing back where positive, each with that on its mirror image. Called once with the initial positions, then once
  /// a step. The forces of what stores energy must be the exact gradient of stored_energy.
  virtual const std::vector<double>& advance(const std::vector<double>& position) = 0;

  /// The same forces as friction feels them: where a law acts on all of a contact as one, as its pressure is spread.
  [[nodiscard]] virtual const std::vector<double>& spread(const std::vector<double>& force) { return force; }

  /// Number of leading nodes beyond which the last force vanishes.
  [[nodiscard]] virtual std::size_t extent() const = 0;

  /// Gap of a node at the last positions: exactly 0 where it is rigid, and as far as it is open where nothing touches.
  /// Hard contacts have one.
  [[nodiscard]] virtual double gap(std::size_t /*node*/) const { return 0.0; }

  /// Half-width of the contact in spacings of the nodes; with a soft wall, of the nodes with a noticeable share of the
  /// force.
  [[nodiscard]] virtual double half_width() const = 0;

  /// Whether the contact reaches the end of the grid, which is then too small.
  [[nodiscard]] virtual bool overflows() const = 0;

  /// Energy in the wall's potential or in the quasistatic tail at the last positions, given back when contact ends; and
  /// in the strain of the modes above the cutoff of lossy bodies, what the material has not yet taken.
  [[nodiscard]] virtual double stored_energy() const { return 0.0; }

  /// The latter in the first and in the second body.
  [[nodiscard]] virtual std::array<double, 2> relaxing_energy() const { return {}; }

  /// Node forces that would displace the modes above the cutoff of one body at once as its material has let them creep;
  /// empty where none creep: the last forces.
  [[nodiscard]] virtual std::vector<double> crept_force(std::size_t /*body*/) const { return {}; }

  /// Energy that the modes above the cutoff have taken so far.
  [[nodiscard]] virtual double unresolved_energy() const { return 0.0; }

  /// Energy that the material of the first and of the second body has taken so far from the modes above the cutoff.
  [[nodiscard]] virtual std::array<double, 2> dissipated_energy() const { return {}; }

  /// The deepest compression so far of a contact that yields, over that at the onset, and what it was before the
  /// impact.
  [[nodiscard]] virtual double pressed() const { return 0.0; }
  virtual void press(double /*before*/) {}

  /// Energy that plastic flow of the first and of the second body has taken so far, and the dent that it leaves, R.
  [[nodiscard]] virtual std::array<double, 2> flow_energy() const { return {}; }
  [[nodiscard]] virtual double dent() const { return 0.0; }

  /// Largest distance by which a free node may at present lie in front of its x_dyn.
  [[nodiscard]] virtual double protrusion() const { return 0.0; }

  /// Contact is counted while the total force exceeds this.
  [[nodiscard]] virtual double contact_threshold() const { return 0.0; }

  /// Itself if its tail radiates, which moves by itself (rest.hpp); else null.
  [[nodiscard]] virtual RadiatingTail* radiating() { return nullptr; }

  /// Whether it remembers nothing of forces that are over, but for a dent.
  [[nodiscard]] virtual bool has_forgotten() const { return false; }

  /// Distance in front of first contact beyond which no force acts that counts.
  [[nodiscard]] virtual double range() const = 0;

  /// Whether it pushes at any distance, on all of the edge that there is, and before an impact.
  [[nodiscard]] virtual bool is_long_range() const { return false; }

  /// Compression at which it begins, from which compression is measured.
  [[nodiscard]] virtual double touch() const = 0;

  /// Compression at which an unexcited body starts, out of range. @param stride by which it moves in a step
  [[nodiscard]] virtual double start(double stride) const = 0;
};

/// @param speed of an impact with all the energy there is: it sets what force counts as contact with a soft wall, and
///              how fast the edge of a hard contact moves
/// @param step  time between two calls of advance
[[nodiscard]] std::unique_ptr<ContactResponse> make_response(const Contact& contact, Tail tail, const ContactGrid& grid,
                                                             double speed, double step, const Poll& poll = {});

/// Whether the response follows forces at once in place of the kept modes, which are then kicked less.
[[nodiscard]] bool follows_at_once(const Contact& contact, Tail tail);

}  // namespace stoss
