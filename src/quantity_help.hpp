#pragma once

/// Sentences of quantities that several kinds of results have: see Quantity::help.
namespace stoss::help {

inline constexpr const char* across = "Share of the initial energy in the relative translation along the surface";
inline constexpr const char* beyond_small_strain =
    "Whether the strain is above 0.1, where linear elasticity is no longer accurate";
inline constexpr const char* beyond_small_turn =
    "Whether the contact rolls by more than its half-width, beyond linear kinematics";
inline constexpr const char* center = "Position of the first body's centre of mass, with the plane of first touch at 0";
inline constexpr const char* contact_time =
    "Time from the first force to the last, of rods to the last above 2 % of the maximum";
inline constexpr const char* contacts = "Number of separate periods of contact";
inline constexpr const char* converged = "Whether the result is as accurate as asked for";
inline constexpr const char* cutoff = "Highest frequency of the modes that are kept";
inline constexpr const char* dissipated = "Share of the initial energy that the material has absorbed";
inline constexpr const char* yielded = "Share of the initial energy that plastic flow has taken";
inline constexpr const char* dent = "Depth of the dent that plastic flow leaves";
inline constexpr const char* energy_error = "Missing energy as a share of the initial one";
inline constexpr const char* force = "Force of the contact";
inline constexpr const char* friction_loss = "Share of the initial energy that became heat of friction";
inline constexpr const char* half_width = "Half-width of the contact grid";
inline constexpr const char* impulse_time =
    "Time from 1 % to 99 % of the impulse, which a last grazing contact hardly changes";
inline constexpr const char* index = "Number of the mode among those of its order, from 0";
inline constexpr const char* lost_fraction =
    "1 minus the square of the restitution, negative where vibration is given back";
inline constexpr const char* lost_to_first =
    "Share of the initial energy left in the first body, as vibration and as loss in its material";
inline constexpr const char* lost_to_second =
    "Share of the initial energy left in the second body, waves of a block or a plate included";
inline constexpr const char* max_compression = "Maximum compression, of the centre of mass beyond first touch";
inline constexpr const char* max_force = "Maximum force of the contact";
inline constexpr const char* max_half_width = "Maximum half-width of the contact, of spheres its radius";
inline constexpr const char* max_radius = "Maximum radius of the contact";
inline constexpr const char* modes = "Number of kept modes";
inline constexpr const char* momentum_error = "Missing momentum as a share of the initial one";
inline constexpr const char* nodes = "Number of nodes of the contact grid";
inline constexpr const char* normal_restitution = "Coefficient of restitution along the normal";
inline constexpr const char* normal_translation =
    "Share of the initial energy in the relative translation along the normal";
inline constexpr const char* vibration_after = "Share of the initial energy with which the bodies vibrate afterwards";
inline constexpr const char* omega = "Angular frequency of the mode";
inline constexpr const char* order = "Angular order of the mode, of a sphere its degree, of a rod 0";
inline constexpr const char* radial = "Radial amplitude of the mode at the point of contact";
inline constexpr const char* restitution = "Coefficient of restitution, the speed of parting over that of approach";
inline constexpr const char* all_steps = "Number of time steps, of all impacts that were computed";
inline constexpr const char* rotation = "Share of the initial energy in the spin of the first body";
inline constexpr const char* runs = "Number of impacts that were computed";
inline constexpr const char* second_rotation = "Share of the initial energy in the spin of the second body";
inline constexpr const char* second_spin_after = "Spin of the second body after the impact";
inline constexpr const char* sliding = "Sliding speed at the first point of contact before the impact";
inline constexpr const char* sliding_after = "Sliding speed at the point of contact after the impact";
inline constexpr const char* slow_contact_time = "Time from the first force to the last";
inline constexpr const char* slow_max_compression = "Maximum compression";
inline constexpr const char* speed = "Speed of approach before the impact";
inline constexpr const char* spin_after = "Spin of the first body after the impact";
inline constexpr const char* stays =
    "Whether the body stays on an infinite plate, which never returns the waves: restitution is 0";
inline constexpr const char* step = "Time step";
inline constexpr const char* steps = "Number of time steps";
inline constexpr const char* stored =
    "Share of the initial energy that a soft wall, the static tail or a lossy body holds";
inline constexpr const char* strain = "Maximum strain of the bodies, estimated";
inline constexpr const char* tangential = "Tangential amplitude of the mode, along the edge or the surface";
inline constexpr const char* tangential_after = "Velocity of the first body along the surface after the impact";
inline constexpr const char* tangential_restitution =
    "Sliding speed after over that before, with the sign changed: -1 without friction";
inline constexpr const char* time = "Time from the start of the impact";
inline constexpr const char* translation = "Share of the initial energy in the relative translation";
inline constexpr const char* turned =
    "Largest angle in radians by which a body or the line of centres turns during the contact";
inline constexpr const char* unresolved =
    "Share of the initial energy that modes above the cutoff and waves have taken";
inline constexpr const char* vibration = "Share of the initial energy in the vibration of the kept modes";

}  // namespace stoss::help
