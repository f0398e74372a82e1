#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stoss/encounter/kinds.hpp"
#include "stoss/impact/vibration.hpp"
#include "stoss/material.hpp"
#include "stoss/restitution/ladder.hpp"

namespace stoss {

/// A body or a wall as it is given: its kind with the numbers that make it.
struct Participant {
  std::string kind = "disk";               ///< of the table of kinds
  Values values{};                         ///< those of its parameters that were given
  std::optional<Material> material{};      ///< in place of those of the material; then all is in SI
  std::string material_name{};             ///< where it is a named one
  Plane plane = Plane::stress;             ///< of a disk or a half-plane with a material
  std::optional<Relaxation> relaxation{};  ///< instead of that of the material, in the unit of loss times; E is E(0)
  bool rigid = false;                      ///< keeps its mass and the units of the elastic body
  /// Further layers, downwards: their values and materials count; a last one without a thickness is a block.
  std::vector<Participant> below{};
  std::shared_ptr<const ModalBody> modal{};  ///< of kind "modal": the body in SI, of whose point `material` is
};

/// What a rigid body has where it is not given: it cancels, and is only a unit, in Pa.
inline const Values units_of_rigid{{"young", 1e9}, {"poisson", 0.3}};

/// Something of a kind without numbers.
[[nodiscard]] inline Participant of_kind(std::string kind) { return {.kind = std::move(kind)}; }

/// A body by its modes at a point, in SI.
[[nodiscard]] Participant modal_participant(ModalBody body);

/// Who meets whom, and how both are given; not at which speed.
///
/// With a material of the first body, sizes, loss times and speeds are in SI. Without, they are in any consistent
/// units, as ratios to the first, and speeds in its c. What the second leaves out is that of the first for Poisson's
/// ratio, otherwise 1; its kind "same" means a body equal to the first.
struct Encounter {
  Participant first{};
  Participant against = of_kind("wall");
  Vibration vibration{};  ///< of the bodies before they meet
};

/// Refuses what cannot meet, numbers out of range, and numbers that are missing or do not go together.
/// @throws InvalidInput with the name of the number, after "against" where it is of the second
void validate(const Encounter& encounter);

/// The first body, and what it meets where that is a body or half-space, in units of the first: with a material
/// R = E = ρ = 1, of a rod in SI. @throws InvalidInput as validate
[[nodiscard]] Solid first_solid(const Encounter& encounter);
[[nodiscard]] std::optional<Solid> second_solid(const Encounter& encounter);

/// Makers of these, rigid where they are.
[[nodiscard]] BodyMaker first_maker(const Encounter& encounter);
[[nodiscard]] BodyMaker second_maker(const Encounter& encounter);

/// The wall that the first meets, a rough one as an exponential one; a hard one for two bodies.
/// @throws InvalidInput as validate
[[nodiscard]] Wall wall_of(const Encounter& encounter);

/// At any cutoff, for `restitution`. @throws InvalidInput as validate
[[nodiscard]] RefinableContact refinable(const Encounter& encounter);

/// At one cutoff, and for contacts as long as at this speed, both in units of the first body.
/// @throws InvalidInput as validate and contact
[[nodiscard]] Contact contact_of(const Encounter& encounter, double cutoff, double speed, const Poll& poll = {});

/// Cutoff where none is given, c/R of the first body: `most`, or less up to which the modes of a file are known. Of two
/// bodies it is higher where the second is much smaller, and lower where one has more than 600 c/R of its own. On a
/// half-space, a plate or their like it is at most 64 over the time_scale and over the stretch for which it is made
/// (RefinableContact::stretch), as the modes that are kept there grow with the square of cutoff and duration. For balls
/// at 1e-8 … 0.1 c on blocks of their own or ten times their modulus and on plates of 0.5, 1 and 4 R, and at
/// 1e-8 … 0.05 c on a block of a tenth of it and ten times their density, ε is that of `restitution` to 4e-6 or to its
/// error at the tolerance 1e-4.
/// @param speed the slowest that is to be computed, c of the first body
/// @throws InvalidInput as validate and refinable
[[nodiscard]] double usual_cutoff(const Encounter& encounter, double speed, double most = 50.0, const Poll& poll = {});

/// SI values of the units of the first body, where it has a material.
[[nodiscard]] std::optional<Scales> si_scales(const Encounter& encounter);

/// Names of the units in which bodies and speeds are given: of SI, or of the first body.
[[nodiscard]] UnitSystem unit_system(const Encounter& encounter);

/// c of the first body in m/s, or 1: what a speed that is given is divided by.
[[nodiscard]] double speed_unit(const Encounter& encounter);

/// A speed that is given, in c of the first body. @throws InvalidInput unless it is 1e-8 … 1 c
[[nodiscard]] double speed_in_c(const Encounter& encounter, double speed);

/// Speed of approach at which a sphere, or what it meets, begins to yield, m/s; nothing without a yield strength.
/// @throws InvalidInput as quasistatic::yield_speed
[[nodiscard]] std::optional<double> yield_speed(const Encounter& encounter);

/// Whether a body has a yield strength of its own, from which on it yields.
[[nodiscard]] bool yields(const Encounter& encounter);

/// What a user must be told of elastic results at that speed, m/s: one line beyond the speed of yielding, else nothing.
[[nodiscard]] std::string yield_warning(const Encounter& encounter, double speed);

/// What a user must be told of materials that lose far more where they are not sound: a line for each of the list whose
/// loss it has.
[[nodiscard]] std::vector<std::string> sound_warnings(const Encounter& encounter);

/// Where the shell of a hollow sphere begins to give way by more than its thickness h, of bodies with materials.
struct ShellLimit {
  double force = 0.0;  ///< N, 4Eh³/(R√(3(1−ν²))): that of a spherical shell under a force at a point times h (E.
                       ///< Reissner, J. Math. Phys. 25, 279 (1946))
  double speed = 0.0;  ///< of approach, about, m/s: that at which the shells as springs take all of the energy
};

/// Deflection over h, and so about force and speed over those of ShellLimit, at which a shell that is pressed at a
/// plane buckles inward (L. Pauchard and S. Rica, Phil. Mag. B 78, 225 (1998): about 2).
inline constexpr double buckling = 2.0;

/// Nothing without a hollow sphere or without materials.
[[nodiscard]] std::optional<ShellLimit> shell_limit(const Encounter& encounter);

/// What a user must be told of shells: a line where they deflect by more than linear elasticity knows, else nothing.
/// @param fastest m/s
[[nodiscard]] std::vector<std::string> shell_warnings(const Encounter& encounter, double fastest);

/// All that a user must be told of computed impacts: yield_warning and shell_warnings at the fastest, sound_warnings.
/// @param fastest m/s
[[nodiscard]] std::vector<std::string> material_warnings(const Encounter& encounter, double fastest);

}  // namespace stoss
