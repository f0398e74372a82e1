#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "stoss/body/mode_group.hpp"
#include "stoss/body/surface.hpp"
#include "stoss/poll.hpp"
#include "stoss/relaxation.hpp"

namespace stoss {

/// How much of a body is modelled: all of it, or only its near side, which answers as the whole does until waves are
/// back from where it ends (docs/theory/pairs.md).
struct BodyPart {
  double size = 1.0;  ///< of the part, over that of the body
  double mass_not_modelled =
      0.0;  ///< mass of the body that does not belong to the part: Body::mass and this are its whole mass;
            ///< infinite for a half-space, which has no translation: its modes alone move it
  double echo = std::numeric_limits<double>::infinity();  ///< after which the part is no longer like the body, R/c
  bool keeps_displacement = false;  ///< an impulse moves its surface away for good, as that of a plate
  double mobility = 0.0;  ///< speed over a force that acts for long, where that has a limit: 1/(8√(Dρh)) of a plate
  double giving = 0.0;  ///< speed times √time over an impulse, long after it: 1/(2ρh √(2π√(D/ρh))) of a strip
};

/// What presses on a body in an impact, at most, in the units of the body.
struct Load {
  double force = 0.0;        ///< F
  double half_width = 0.0;   ///< a of the contact
  double compression = 0.0;  ///< by which it gives way, at most
  double duration = 0.0;
};

struct Body;

/// Limits of a body that is known at one point (ModalBody); other bodies have none.
struct Validity {
  /// Cutoff up to which all of its modes are there, c/R.
  double complete_to = std::numeric_limits<double>::infinity();

  /// Largest product of the cutoff and the half-width of a contact up to which its shapes follow its modes, c.
  double max_cutoff_times_width = std::numeric_limits<double>::infinity();

  /// What the body might be instead, by the errors of the numbers that it was made from, one for each kind of them.
  /// @param other curvature of what it meets, in its own units
  std::function<std::vector<Body>(double other)> alternatives{};

  /// The same where only its motion along the surface is another.
  std::function<std::vector<Body>(double other)> alternatives_along{};

  /// `max_cutoff_times_width` of its motion along the surface.
  double max_cutoff_times_width_along = std::numeric_limits<double>::infinity();

  /// Velocity along the surface per impulse along the normal that its point may have in the end, 1/mass in its own
  /// units, from the modes and the turning that join both directions; a contact of a duration, R/c.
  std::function<double(double duration)> cross_mobility{};

  /// Of an alternative: it differs by what none of the numbers tells, not by the error of one. Such changes add up, and
  /// errors by their squares.
  bool is_bound = false;
};

/// An elastic body by itself, with its modes up to a cutoff: all that a contact needs to know of it, in its own units
/// (for a disk R = c = ρ = 1). Motion is along the axis, towards what it meets. A new body is a function that fills
/// this structure (docs/architecture.md).
struct Body {
  std::string name;  ///< with its parameters, for provenance
  BodyScale scale;   ///< of this body among others
  Contour contour = Contour::flat;
  double mass = 0.0;                  ///< of the body, and of every mode
  bool held = false;                  ///< so that it does not move as a whole: its mass is only a very large number
  double extent = 0.0;                ///< distance from the centre of mass to the foremost point
  double curvature = 1.0;             ///< of its surface near the foremost point, 1/R
  double hole = 0.0;                  ///< radius of a concentric hole, whose shell gives waves back at once, R; 0: none
  double curvature_difference = 0.0;  ///< of the principal curvatures there, 1/R; `curvature` is their mean
  double softness = 1.0;    ///< 1/E* near its end, in 1/E: 1 in plane stress, 1 − ν² in plane strain, 0 if rigid
  double inertia = 0.0;     ///< moment about the centre of mass, mass × R²; 0: it does not turn
  double mass_along = 0.0;  ///< of the whole body against forces along its surface; 0: the same as along the normal
  double loss_time = 0.0;   ///< η of a lossy material, R/c: stress = (1 + η ∂/∂t) elastic stress
  Relaxation relaxation{};  ///< of a material that relaxes, times in R/c; instead of a loss time (relaxing)
  std::vector<MaterialLoss> layers{};  ///< of layers that lose energy in different ways, times in R/c: both numbers
                                       ///< above are then those of the uppermost one, at the surface
  Coat coat{};                         ///< on its face; a compliance of 0: none
  double asperities = 0.0;  ///< u₀ of its rough face, R: pressure falls as e^{−gap/u₀} (rough); 0: smooth
  Strength strength{};      ///< from which on it yields
  double cutoff = 0.0;      ///< all modes with ω ≤ kept_cutoff(body) are in `groups` (but see with_modes)
  double highest_cutoff = std::numeric_limits<double>::infinity();  ///< that such a body can be made with
  /// Largest stable time step at a hard wall: above it one kick moves the kept modes of some order further than the
  /// residual compliance does.
  double stable_step = std::numeric_limits<double>::infinity();
  Sampling sampling{};            ///< of a contact with more than a single point
  std::vector<ModeGroup> groups;  ///< kept modes
  BodyPart part;                  ///< what of the body is there
  Validity known{};               ///< how far it is

  std::function<Surface(const ContactPoints&)> surface;

  /// Static compliance between the points of the modes that are not kept, W (points × points, symmetric positive
  /// definite): displacement of point i into the body per force on point j.
  std::function<std::vector<double>(const ContactPoints&, const Poll&)> residual_compliance;

  /// Second moment of the modes that are not kept, V (points × points, symmetric, positive semidefinite): as W with
  /// 1/ω⁴ for 1/ω². These modes answer forces that vary slowly with W f − V f̈.
  std::function<std::vector<double>(const ContactPoints&, const Poll&)> residual_second_moment;

  /// The same from the points of the opposite face to those of this one, here × there: displacement of a point here
  /// per force on a point there. Empty for bodies without an opposite face of the same shape.
  std::function<std::vector<double>(const ContactPoints& here, const ContactPoints& there)> opposite_compliance{};

  /// Makes the near side of the body, a part of size 0 < `size` ≤ 1, in the units of the whole; of a half-space, one
  /// for contacts of duration `size`. Empty for bodies that have none, or are one.
  std::function<Body(double size, double cutoff, const Poll& poll)> near_side{};

  /// The same body against forces along its surface, which move it by the same rows with other weights
  /// (docs/theory/oblique.md): bodies with the mass, scale, contour, cutoff and loss time of this one whose modes,
  /// surface and residual functions are those along the surface and whose softness is that along it. A ball has one,
  /// whose points move along y. A disk has two, in which directions mix: of forces even in y, normal and odd tangential
  /// ones (0) and tangential and odd normal ones (1). Empty for bodies that have none, as rods.
  std::function<std::vector<Body>(const Poll& poll)> along{};

  /// The same ball against forces that do not vary around the axis: normal ones, and friction that acts outward along
  /// the surface. Rings move along the axis (first component) and out from it (second). Empty for other bodies.
  std::function<Body(const Poll& poll)> outward{};

  /// Greatest strain under a load, estimated, of a body that has layers or is thin; empty: no more than near the
  /// contact.
  std::function<double(const Load& load)> strain{};

  /// Displacements at each point: all arrays of Surface, and the residual matrices, are those of the first component at
  /// every point, then of the second. Only bodies that `along` or `outward` makes have more than one. What meets as the
  /// second body is turned around, which changes the sign of its second component.
  std::size_t components = 1;
};

/// Makes a body with all modes up to a cutoff.
using BodyMaker = std::function<Body(double cutoff, const Poll& poll)>;

/// Makes the rigid body at any cutoff. @throws InvalidInput for a half-space or half-plane
[[nodiscard]] BodyMaker rigid(const BodyMaker& maker);

/// The same body of a material that relaxes from the modulus it has, with times in its R/c.
/// @throws InvalidInput as validate(Relaxation), and for a body with a loss time or with layers that differ
[[nodiscard]] Body relaxing(const Body& body, const Relaxation& relaxation);

/// Makes such a body at any cutoff; without terms the body itself.
[[nodiscard]] BodyMaker relaxing(const BodyMaker& maker, const Relaxation& relaxation);

/// The same body with a rough face, whose asperities deform elastically: their pressure is p₀ e^{−g/u₀} at the mean gap
/// g (B. N. J. Persson, Phys. Rev. Lett. 99, 125502 (2007)). Of two faces u₀² = u₁² + u₂². What p₀ is does not matter.
/// @param asperities u₀, 0 to 1000 in its R, some 0.45 of their rms height (stoss/encounter/roughness.hpp)
[[nodiscard]] Body rough(const Body& body, double asperities);

/// Makes such a body at any cutoff; of 0 the body itself.
[[nodiscard]] BodyMaker rough(const BodyMaker& maker, double asperities);

/// The same body with a coat, thin beside the contact and so soft that its pressure follows its closure at the same
/// point alone, p = (M/h) · closure (Winkler's foundation; K. L. Johnson, Contact Mechanics, 1985, §4.3). Its mass does
/// not count, and it carries no tension.
/// @throws InvalidInput for a compliance below 0 or not finite, and as validate(Relaxation)
[[nodiscard]] Body coated(const Body& body, const Coat& coat);

/// Makes such a body at any cutoff; of a coat without compliance the body itself.
[[nodiscard]] BodyMaker coated(const BodyMaker& maker, const Coat& coat);

/// The same body of a material that yields, in contacts that are small beside it (docs/theory/real_contact.md).
/// @throws InvalidInput for Y beyond 0 to 1 and H beyond 0 to 0.03 in its E, C beyond 0 to 1, ε̇₀ that is not above 0,
/// and for a body that is
///         rigid or does not touch on a circle
[[nodiscard]] Body yielding(const Body& body, const Strength& strength);

/// Makes such a body at any cutoff; of a Y of 0 the body itself.
[[nodiscard]] BodyMaker yielding(const BodyMaker& maker, const Strength& strength);

/// The same body with a mass fixed to it, as the hammer behind a ball. It moves as the body does on average over its
/// mass. The force between them acts evenly on the whole body, so that it excites no mode and changes none.
/// @param mass in that of Body::scale, 0 or more
/// @throws InvalidInput for a mass below 0 or not finite, and for a body other than a whole one that touches on a
/// circle
[[nodiscard]] Body laden(const Body& body, double mass);

/// Makes such a body at any cutoff; of a mass of 0 the body itself.
[[nodiscard]] BodyMaker laden(const BodyMaker& maker, double mass);

/// Checks what a contact relies on: positive finite scale, mass and cutoff, groups with arrays of one length, finite
/// weights and 0 < ω ≤ kept_cutoff(body), and all functions.
/// @throws InvalidInput naming the body and what is wrong with it
void validate(const Body& body);

/// Mean pressure of a load, F/πa² on a circle, F/2a on a line.
[[nodiscard]] double pressure(Contour contour, const Load& load);

/// Mean strain near a contact over the mean pressure and 1/E*: 0.2 a/R over 4a/3πR (Tabor; Hertz).
inline constexpr double strain_of_contact = 0.47;

/// Highest frequency of the modes that a body keeps at a cutoff, both in one unit of frequency and η in that of time:
/// the cutoff, or less in a lossy material, min(ω_c, √(ω_c/η)).
///
/// A mode decays at up to 2γ = ηω². Where that is faster than the steps, which ω_c sets, kicks are no substitute for
/// a force, while the compliance of the modes that are not kept describes it (docs/theory/loss.md).
[[nodiscard]] double kept_cutoff(double cutoff, double loss_time);

/// The same of a body, in its own units.
[[nodiscard]] double kept_cutoff(const Body& body);

/// Whether its material, or a layer of it, takes energy.
[[nodiscard]] bool loses(const Body& body);

/// Longest loss time of its layers; 0 if none has one.
[[nodiscard]] double longest_loss_time(const Body& body);

/// Number of kept modes.
[[nodiscard]] std::size_t mode_count(const Body& body);

/// What a mode moves the opposite face by, towards what meets it there, over this one: 1 or −1, of a body with an
/// `opposite_compliance`.
[[nodiscard]] double opposite_share(const Body& body, const ModeGroup& group, std::size_t index);

/// Mass of the body, whatever part of it is there.
[[nodiscard]] double whole_mass(const Body& body);

/// Whether the body extends to infinity: it has no translation, and its modes only carry waves away.
[[nodiscard]] bool is_unbounded(const Body& body);

/// Whether only a point of the body is known, and what the errors of that change.
[[nodiscard]] bool is_known_at_a_point(const Body& body);

/// Whether all of the body is there and bounded, so that it can vibrate before an impact.
[[nodiscard]] bool is_whole(const Body& body);

/// The same body without elasticity: it keeps mass and surface, and the units in which it is given. It meets elastic
/// bodies. @throws InvalidInput for a half-space or half-plane
[[nodiscard]] Body rigid(const Body& body);

/// A body with only some of its kept modes, as the paper selects them, for exponential walls. A hard wall would need
/// the compliance of the others: the residual functions refuse. With all of them, the body itself.
/// @param keep one flag for each mode, in the order of Body::groups
/// @throws InvalidInput for another number of flags, or none set
[[nodiscard]] Body with_modes(const Body& body, const std::vector<bool>& keep);

}  // namespace stoss
