#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "stoss/body/body.hpp"
#include "stoss/contact/wall.hpp"

namespace stoss {

class ContactCache;

/// Who meets whom, as the one system that an impact needs.
///
/// A body meets a rigid or an exponential wall, or a second body. A pair is a single system in relative motion: with
/// X = X₁ − X₂ and the common force f at points of equal lateral distance
///
///   X + Σ(modes of 1) + Σ(modes of 2) − recess₁ − recess₂ ≤ 0,   f ≥ 0,   μ Ẍ = −Σ f,   μ = m₁m₂/(m₁ + m₂),
///
/// so its modes are those of both, with amplitudes times √(μ/m_k), W = W₁ + W₂, V = V₁ + V₂, 1/Z = 1/Z₁ + 1/Z₂
/// (docs/theory/pairs.md). Everything is in the units of the first body: R, c and, for forces, mc²/R.
struct Contact {
  std::shared_ptr<const Body> first;
  std::shared_ptr<const Body> second;   ///< null at a wall
  Wall wall;                            ///< for two bodies a HardWall
  double asperities = 0.0;              ///< u₀ between the faces, √(u₁² + u₂²), R; 0: smooth, no point passes
  Strength yield{};                     ///< of the weaker one, in units of the first; 0: none yields
  double strength = 1.0;                ///< V₀ of an exponential wall
  double mass = 0.0;                    ///< m of the first at a wall, else μ
  double whole_mass = 0.0;              ///< the same of whole bodies, where only a part of one is there (BodyPart)
  double extent = 0.0;                  ///< distance of the centres (or of centre and wall) at first touch
  double cutoff = 0.0;                  ///< all modes with ω ≤ cutoff are kept; of a lossy body fewer (kept_cutoff)
  double stable_step = 0.0;             ///< as Body::stable_step, and half the loss time more
  std::vector<ModeGroup> groups;        ///< of the first, then of the second, every modal mass `mass`
  std::size_t first_groups = 0;         ///< how many of them are of the first
  bool unbounded = false;               ///< the second is a half-space: its modes only carry waves away
  bool keeps_displacement = false;      ///< it is a plate, whose surface an impulse moves away for good
  double radius = 1.0;                  ///< of the circle of the contact points
  std::shared_ptr<ContactCache> cache;  ///< what impacts on the same grid share; may be null
};

/// A body at a wall. @throws InvalidInput for a body or a wall that is not valid
[[nodiscard]] Contact contact(std::shared_ptr<const Body> body, const Wall& wall = HardWall{});
[[nodiscard]] Contact contact(Body body, const Wall& wall = HardWall{});

/// Two colliding bodies.
/// @throws InvalidInput for bodies that are not valid, contours that do not meet in a contact of known kind, and ratios
///         of length, speed or mass beyond what is computed
[[nodiscard]] Contact contact(std::shared_ptr<const Body> first, std::shared_ptr<const Body> second);
[[nodiscard]] Contact contact(Body first, Body second);

/// Name of what meets, for provenance.
[[nodiscard]] std::string name(const Contact& contact);

/// Whether a single point on the axis represents the whole contact, as with flat ends.
[[nodiscard]] bool has_single_point(const Contact& contact);

/// One of the bodies, 0: the first, 1: the second; null where there is none, as at a wall.
[[nodiscard]] std::shared_ptr<const Body> body_of(const Contact& contact, int number);

/// Number of kept modes.
[[nodiscard]] std::size_t mode_count(const Contact& contact);

/// Number of the groups whose modes keep their energy; those behind them only carry waves away.
[[nodiscard]] std::size_t lasting_groups(const Contact& contact);

/// Modal mass of the modes of a group by themselves: the mass of their body.
[[nodiscard]] double modal_mass(const Contact& contact, std::size_t group);

/// Loss time η of the body that the modes of a group belong to, at its surface, R/c of the first.
[[nodiscard]] double loss_time(const Contact& contact, std::size_t group);

/// Relaxation of the body that the modes of a group belong to, at its surface, times in R/c of the first.
[[nodiscard]] Relaxation relaxation(const Contact& contact, std::size_t group);

/// Free motion of a mode by itself long after it was struck, Q̈ + 2γ Q̇ + w² Q = 0.
struct FreeMode {
  double gamma, frequency;
};

/// That of a mode of a group, 1/(R/c of the first).
[[nodiscard]] FreeMode free_mode(const Contact& contact, std::size_t group, std::size_t index);

/// Whether a material of the bodies takes energy: one has a loss time or relaxes.
[[nodiscard]] bool loses(const Contact& contact);

/// Longest loss time of the bodies, R/c of the first; 0 if none has one.
[[nodiscard]] double longest_loss_time(const Contact& contact);

/// Highest wave number of the kept modes along the contact, 1/R.
[[nodiscard]] double highest_wave_number(const Contact& contact);

/// The larger of the two bodies' speeds towards their common plane of contact, each in its own wave speed: it says how
/// fast an impact is. At a wall it is `speed`, for two equal bodies half of it.
[[nodiscard]] double mach_number(const Contact& contact, double speed);

/// Compression of the more compressed body in its own radius; the approach δ (in R of the first) is the sum of both.
[[nodiscard]] double own_compression(const Contact& contact, double approach);

/// Longest R/c of the bodies, or of the part that is there, in that of the first; with a half-space, time_scale.
[[nodiscard]] double longest_time(const Contact& contact);

/// Share of the first body in the energy that the modes above the cutoff absorb: the force is common, and a plane wave
/// takes f²/Z.
[[nodiscard]] double unresolved_share(const Contact& contact);

/// Time until the first echo from where a part of a body ends, R/c of the first; infinite where all are whole.
[[nodiscard]] double echo_time(const Contact& contact);

/// Time of a contact over R/c of the first body: both bodies as springs of stiffness mc²/R² under the reduced mass, a
/// half-space as one of the size of the first; for flat ends, the shorter transit time. It is 1 at a wall, and the same
/// whoever is called the first.
[[nodiscard]] double time_scale(const Contact& contact);

}  // namespace stoss
