#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "contact/ending.hpp"
#include "contact/response.hpp"
#include "contact/zener.hpp"
#include "impact/contact_history.hpp"
#include "impact/kept_modes.hpp"
#include "impact/normal_motion.hpp"
#include "impact/pressures.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss {

/// The relative motion of a contact with the node forces f_i,
///
///   m Ẍ = −Σ_i f_i,   m Q̈ = −m ω² Q − Σ_i f_i s_i   (at a wall, paper eqs. (44) and (41) with E2),
///
/// with s_i what the mode moves node i, and for two bodies m their reduced mass,
///
/// by kick–rotate–kick: half a kick by the force, exact rotation of every mode and drift of the centre, half a kick. A
/// mode of a lossy body has −m η ω² Q̇ besides, and its exact free motion for the rotation. Second order, exact between
/// contacts; reversible in time at an exponential wall and with the quasistatic tail, not with the radiating tail,
/// which takes energy for good, and not in a lossy material.
class Collision {
 public:
  /// Starts just out of reach of what is met, at a hard contact with the first touch at the best phase within a step;
  /// or from `start`.
  /// @param pressures receives what the nodes feel in every step; null: nothing does
  Collision(const Contact& contact, const FixedResolution& resolution, const ContactGrid& grid, double speed,
            const std::optional<State>& start, const Poll& poll, Pressures* pressures = nullptr);

  /// Moves on by one step.
  void advance();

  /// The contact has reached the end of the grid, so that the result is void.
  [[nodiscard]] bool overflows() const { return !has_single_point(contact_) && response_->overflows(); }

  /// The body recedes and can touch the wall no more.
  [[nodiscard]] bool over();

  [[nodiscard]] double time() const { return history_.time(); }
  [[nodiscard]] double compression() const { return center_.compression(); }
  [[nodiscard]] double velocity() const { return center_.velocity(); }

  /// Energies.
  [[nodiscard]] double translation() const { return center_.energy(); }
  [[nodiscard]] double vibration() const { return modes_.energy(); }

  /// The motion along the normal at present.
  [[nodiscard]] Slowing slowing() const;

  /// Distance from the wall that the free body must keep so as not to touch it, in its present vibration.
  [[nodiscard]] double clearance() const { return modes_.reach() + std::max(response_->range(), 0.0); }

  /// The instant, with energies as shares of the initial energy.
  [[nodiscard]] Snapshot snapshot() const;

  /// The impact so far; body, wall and resolution are left to the caller.
  [[nodiscard]] Impact result() const;

  [[nodiscard]] State state() const;

  /// Share of each node in the force.
  [[nodiscard]] std::vector<double> node_force() const;

  /// Snapshot::crept_force
  [[nodiscard]] std::array<std::vector<double>, 2> crept_force() const;

 private:
  void respond();
  void record();
  [[nodiscard]] double since_touch() const;  // in steps, at the first notice of a contact
  [[nodiscard]] double half_width() const;
  [[nodiscard]] bool clears_waves();
  [[nodiscard]] bool has_parted();
  [[nodiscard]] std::array<double, 2> dissipated() const;  // in the first and in the second body

  const Contact& contact_;
  Ending ending_;
  const ContactGrid& grid_;
  double speed_;
  double step_;
  KeptModes modes_;
  std::unique_ptr<ContactResponse> response_;
  Pressures* pressures_;
  std::vector<double> position_;  // x_dyn of the nodes
  double foremost_ = 0.0;         // largest of them
  double foremost_before_ = 0.0;

  double touch_ = 0.0;  // compression at which the contact begins to push
  NormalMotion center_;
  const std::vector<double>* node_force_ = nullptr;  // of response_
  double initial_energy_;
  std::vector<double> energy_before_;  // of each mode, if any moves
  double initial_velocity_;
  ContactHistory history_;
  bool lossy_;
  double reach_ = -1.0;     // of the free vibration; < 0: not known
  double parted_ = -1.0;    // time from which they stay clear in free flight; < 0: not known
  double next_look_ = 0.0;  // time at which waves ahead are looked at again
};

}  // namespace stoss
