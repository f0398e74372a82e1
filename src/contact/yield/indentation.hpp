#pragma once

#include "contact/yield/relaxing_springs.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/elastic_plastic.hpp"

namespace stoss {

/// Length, force and radius of a contact at the onset of yield, in the units of the first body: δ_y = R (πp₀/2E*)²,
/// F_y = (4/3) E*√R δ_y^{3/2}, a_y = √(R δ_y), p₀ = 1.6 Y. Y is that at the rate of strain of an impact, which reaches
/// 0.2 a/R (Tabor) in the time δ/v. Of a material that relaxes all is that of its modulus at once, E(0), and Y larger
/// by as much as this is above the modulus at half a period in a contact: the pressure is then Y's.
struct Onset {
  double depth = 0.0, force = 0.0, radius = 0.0;
  double deepest = 0.0;  ///< compression of an impact with nothing but the contact, over that of the onset
};

[[nodiscard]] Onset onset_of(const Contact& contact, double speed);

/// What two bodies do to each other at a point where one of them yields: the force against the compression δ, with its
/// history (elastic_plastic.hpp), and what their materials take of it.
///
/// Of the force P that materials without loss would have, one that relaxes leaves the share that it leaves to a contact
/// of springs (RelaxingSprings) on the dent: of the depth δ − δ_r and the radius R_p, which elastic–plastic contact at
/// present would return to and with. It is exact for an elastic contact, and a model where one yields.
class Indentation {
 public:
  /// @param compliance of what else gives way, by so much times the force; below 0 where modes that move by themselves
  /// have a
  ///                   part of the indentation too
  /// @param speed of an impact with all the energy there is
  Indentation(const Contact& contact, double compliance, double speed, double step);

  /// Begins with a dent of an earlier impact. @param deepest compression then, over that at the onset
  void press_before(double deepest);

  /// Goes on by a step to a place, δ and what else has given way. @throws NotConverged where no force is in balance
  void move(double place);

  [[nodiscard]] double force() const { return force_; }

  /// Whether it remembers nothing but its dent, and nothing pushes.
  [[nodiscard]] bool is_still() const { return force_ == 0.0 && !answers_.relaxes(); }

  /// Half-width of the contact, R.
  [[nodiscard]] double radius() const;

  /// Deepest compression so far, over that at the onset.
  [[nodiscard]] double deepest() const { return deepest_; }

  /// Depth of the dent that will remain, R.
  [[nodiscard]] double dent() const;

  /// Energy that the contact gives back, and what plastic flow and the material have taken of this impact.
  [[nodiscard]] double stored() const;
  [[nodiscard]] double flow() const;
  [[nodiscard]] double heat() const { return answers_.relaxes() ? work_ - flow() - stored() : 0.0; }

 private:
  [[nodiscard]] double force_at(double depth) const;
  [[nodiscard]] double stiffness_at(double depth) const;
  [[nodiscard]] double returned(double depth) const;  // share of the way back that is left
  [[nodiscard]] double root(double target, double compliance, double low, double high) const;
  void press(double target, double compliance);
  [[nodiscard]] double flow_down_to(double depth) const;
  const Unloading& back();

  Onset onset_;
  double hardening_;   // H/E
  double compliance_;  // in the units of the onset
  RelaxingStep answers_;
  RelaxingSprings springs_;
  RelaxingStep::Memory rest_;                // of the force that acts on what else gives way
  double flow_ = 0.0;                        // of a material that relaxes
  double share_ = 1.0, share_before_ = 1.0;  // that the springs leave
  double depth_ = 0.0, deepest_ = 0.0, before_ = 0.0;
  double most_ = 0.0;       // f at the deepest
  Unloading back_{};        // from
  double back_from_ = 0.0;  // this depth
  double force_ = 0.0, place_ = 0.0, work_ = 0.0;
};

}  // namespace stoss
