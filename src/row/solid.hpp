#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "contact/unit_ratios.hpp"
#include "impact/kept_modes.hpp"
#include "impact/normal_motion.hpp"
#include "relaxation/creep.hpp"
#include "row/face_modes.hpp"
#include "stoss/body/body.hpp"
#include "stoss/impact/vibration.hpp"

namespace stoss {

/// The two faces of a body in a row.
enum class Face { left, right };

constexpr Face opposite(Face face) { return face == Face::right ? Face::left : Face::right; }

/// One body of a row: its centre and its modes, under the forces at its faces.
///
/// A mode that moves the right face towards what meets it by Q s_i moves the left one by ±Q s_i (opposite_share), so
/// the points of both faces are those of one contact of all modes, and the bodies are the same as in a pair. What the
/// modes that are not kept do at their own face belongs to the contact there; across the body they follow at once,
/// u = W_x f, by forces that go on as in the last step: W_x is a hundredth of W. In a material that loses energy they
/// creep, u = J(s) W_x f, and what the kicks of the kept modes leave out follows at once, as at their own face.
class RowSolid {
 public:
  /// @param units of the body in those of the first in the row @param step, speed in those of the first
  /// @throws InvalidInput for a body with two neighbours whose opposite face is not known
  RowSolid(std::shared_ptr<const Body> body, const UnitRatios& units, const FacePoints& points, double step,
           double speed);

  /// Another body that meets the same at the same points, as neither has moved.
  [[nodiscard]] RowSolid alike(double speed) const;
  [[nodiscard]] bool is_alike(const Body& body, const FacePoints& points) const;

  /// Takes the forces of a contact at a face, the first `count` of which may be other than 0, and their sum.
  void load(Face face, const std::vector<double>& force, std::size_t count, double sum);

  /// Makes them those of the kick that is due.
  void respond();

  /// Lets a mode vibrate before it begins. @param energy in units of the first body
  /// @throws InvalidInput for a mode that is not kept
  void vibrate(const Oscillation& mode, double energy);

  /// Sets all modes. @throws InvalidInput for another number of them
  void set(const std::vector<double>& coordinate, const std::vector<double>& momentum);

  [[nodiscard]] std::vector<double> coordinate() const;
  [[nodiscard]] std::vector<double> momentum() const;

  void begin();
  void advance();

  /// Whether no force moves it, but for what its material remembers of those before.
  [[nodiscard]] bool is_free() const;

  /// Goes on freely for some steps at once.
  void fly(long steps);

  /// Whether its flight can be looked at ahead: it loses nothing, and no waves run away.
  [[nodiscard]] bool is_foreseen() const { return moves_ && creep_.empty() && !loses(*body_); }

  /// Its modes as they are, to be looked at in steps 4 times as long; null without modes. Of one that is foreseen.
  [[nodiscard]] std::optional<KeptModes> in_flight() const;
  static constexpr long look = 4;  ///< steps

  /// The points of both faces, and the place of a face among them.
  [[nodiscard]] std::size_t points() const { return force_.size(); }
  [[nodiscard]] std::size_t first_point(Face face) const { return side(face).begin; }

  /// Where the points of a face are beyond those of the body at rest, R of the body; its centre is left out.
  [[nodiscard]] double displacement(Face face, std::size_t point) const;

  /// Upper bound of it in free vibration, R of the body.
  [[nodiscard]] double reach(Face face) const;

  /// To the right, since the start, R and c of the first body.
  [[nodiscard]] double position() const { return center_.compression(); }
  [[nodiscard]] double velocity() const { return moves_ ? center_.velocity() : 0.0; }

  [[nodiscard]] double mass() const { return mass_; }
  [[nodiscard]] bool moves() const { return moves_; }
  [[nodiscard]] const UnitRatios& units() const { return units_; }

  /// Energies, in units of the first body. What is stored across the body belongs to what its contacts hold.
  [[nodiscard]] double translation() const { return moves_ ? center_.energy() : 0.0; }
  [[nodiscard]] double vibration() const { return modes_ ? modes_->energy() * energy_ : 0.0; }
  [[nodiscard]] double dissipated() const;
  [[nodiscard]] double stored_across() const;

 private:
  struct Side {
    std::size_t begin = 0, count = 0;             // in what is common to both
    std::vector<double> force, before;            // on its points, and a step before
    std::vector<double> across;                   // displacement by the force on the other
    double sum = 0.0;                             // of the forces
    std::size_t pressed = 0, pressed_before = 0;  // points
    bool moved_across = false;
  };

  /// What creeps at a face of a material that loses energy, after the force at the other.
  struct CreepAcross {
    CreepMemory stress, strain;   // of the force on the points of the other face; of W_x times it here
    std::vector<double> at_once;  // what the kicks leave out, points there × here
    std::vector<double> crept;    // u of the step before
  };

  void begin_creep(const Contact& contact, const ContactGrid& grid, double step);
  void add_across(std::size_t face);
  void creep_across(std::size_t face);
  [[nodiscard]] double stored_in_creep() const;
  [[nodiscard]] const Side& side(Face face) const { return sides_[static_cast<std::size_t>(face)]; }

  using Across = std::array<std::vector<double>, 2>;

  std::shared_ptr<const Body> body_;
  FacePoints points_;
  UnitRatios units_;
  double step_;  // R/c of the body
  double mass_, energy_;
  bool moves_;
  std::array<Side, 2> sides_;
  // What is shared by copies.
  std::shared_ptr<const std::vector<ModeGroup>> groups_;
  std::shared_ptr<const ModeTables> looks_;
  std::shared_ptr<const Across> across_;  // W_x, points there × here; empty where one face alone meets something
  std::optional<KeptModes> modes_;
  NormalMotion center_;
  std::vector<CreepAcross> creep_;     // at both faces; empty without losses
  double work_across_ = 0.0;           // of the forces on what creeps across
  std::vector<double> force_, moved_;  // of all points
  std::vector<double> next_;
  double greatest_ = 0.0;  // force on a face
  double lag_ = 1.0;  // share of the force that follows in a step: where steps are much shorter than modes that are not
                      // kept, the face would else follow them at once and drive the contact there
  std::array<std::vector<double>, 2> late_;  // those forces
};

}  // namespace stoss
