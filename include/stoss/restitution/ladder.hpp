#pragma once

#include <memory>

#include "stoss/contact/contact.hpp"

namespace stoss {

/// Whether only what moves along the normal has to be known, or also along the surface.
enum class Directions { normal, oblique };

/// The levels of a ladder of cutoffs that impacts can have.
struct Levels {
  int lowest;
  int highest;
};

/// A body at a wall, or two bodies, at any of a ladder of cutoffs. Each contact is made when it is first asked for
/// and kept. Copies share what is made; any number of threads may ask.
class RefinableContact {
 public:
  /// A body at a wall. @throws InvalidInput as validate(Wall)
  RefinableContact(BodyMaker body, const Wall& wall);

  /// At a hard wall.
  explicit RefinableContact(BodyMaker body);

  /// Two bodies. @throws InvalidInput as contact, and for bodies so unequal in size or wave speed that even a coarse
  /// contact would need more modes of the larger or slower one than are computed, unless it has a near side (disks)
  RefinableContact(BodyMaker first, const BodyMaker& second);

  /// 24 at a wall, less for two bodies of which one would need more modes than are computed.
  [[nodiscard]] int highest_level() const;

  /// The same of a half-space or a plate that lasts for a stretch.
  /// @throws NotConverged if not even the lowest cutoff is computed for so long, as where a ball stays on a thin plate
  [[nodiscard]] int highest_level(double stretch) const;

  /// The levels of impacts at a speed, with a half-space or a plate that lasts for longer · stretch(speed). Of a body
  /// of which only a point is known they end where its modes do, or where they do not move the contact as known any
  /// more, and begin not far below, perhaps at negative levels.
  /// @throws NotConverged as highest_level, and for a speed at which no cutoff is good for such a body
  [[nodiscard]] Levels levels(double speed, double longer, const Poll& poll = {},
                              Directions directions = Directions::normal) const;

  /// ω_c = 4√2 · 2^(level/4) c/R of the first body, 362 at level 24; for two bodies over their time_scale.
  [[nodiscard]] double cutoff(int level) const;

  /// Highest level at which both bodies are computed as wholes, without a near side (part), as impacts at an angle
  /// need.
  /// @throws InvalidInput for bodies so unequal in size or wave speed that there are not even three such levels
  [[nodiscard]] int highest_whole_level() const;

  /// The contact at the cutoff of a level.
  /// @throws what the makers and poll throw; InvalidInput for a level outside 0 … highest_level().
  [[nodiscard]] const Contact& at(int level, const Poll& poll = {}) const;

  /// Size of the part of a body that stands for it, over that of the whole (BodyPart); 1 where both are whole. A disk
  /// that is so much larger or slower than the other that no echo from its far side can be back in time, by a factor of
  /// about two, is computed by its near side.
  [[nodiscard]] double part() const;

  /// How much longer than the usual a half-space must be good for at this speed; 1 without one.
  [[nodiscard]] double stretch(double speed) const;

  /// The contact at any cutoff, with a part that is larger by a factor, where there is one; it ends with the whole. How
  /// the impact depends on it tells what the part leaves out. @throws as above
  [[nodiscard]] const Contact& at(double cutoff, double stretch, const Poll& poll) const;

 private:
  struct Ladder;
  std::shared_ptr<Ladder> ladder_;
};

/// Two bodies with one cutoff for both. Where RefinableContact takes the near side of one, so does this, with a part
/// down to half of that size if the cutoff is high; ε then lacks what `restitution` adds for the curvature, some 1e-3
/// to 1e-2.
/// @param cutoff  c/R of the first body
/// @param slowest speed that is to be computed, c: a half-space is made for contacts that last so long
/// @throws InvalidInput for a cutoff beyond that of the bodies
[[nodiscard]] Contact contact(const BodyMaker& first, const BodyMaker& second, double cutoff, double slowest = 1e-3,
                              const Poll& poll = {});

}  // namespace stoss
