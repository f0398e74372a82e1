// Every constant of the error bars that was fitted to cases: the set of cases (files of validate/data, or as
// docs/developer says), and when. `make calibrate` computes again what a set asks of each
// (docs/developer/numerics.md, section 5).
#pragma once

namespace stoss::calibration {

/// How the error of a quantity follows from the differences of runs.
struct Differences {
  double order;   ///< at which it falls with the cutoff, at most
  double safety;  ///< by which the maximum difference is multiplied
};

/// A share of the unresolved energy U: at a cutoff of 64, and the power with which it falls.
struct Share {
  double at_64, power;
  double half;  ///< speed at which half of it is left
};

/// By how much the share of one run may be off: at a cutoff of 16, and the power with which it falls.
struct Noise {
  double at_16, power;
  double speed;  ///< below which it grows
};

// 1 − ε² on a line and on a circle: reference.csv; reference_spheres.csv (2026-11-22).
inline constexpr Share share_on_a_line{0.0115, 0.8, 0.1}, share_of_balls{0.045, 0.6, 0.2};
inline constexpr Noise noise_on_a_line{0.27, 2.5, 1e-4}, noise_of_balls{0.2, 1.0, 1e-3};
inline constexpr double of_share = 0.8;       // that its mean may be off by, both sets (2026-11-22)
inline constexpr double fast_of_balls = 0.6;  // of the share without its fall at high speed, reference_spheres.csv
inline constexpr double fast_speed = 0.33, fast_at_most = 3.5;  // 120 fast disks, 0.1 < v < 0.6 (2026-11-22)
inline constexpr double slow_speed = 0.02, slow_power = -0.1, slow_at_most = 1.7;  // both sets (2026-11-22)
inline constexpr Differences lost_fraction{2.5, 3.0};                              // reference.csv (2026-11-22)
inline constexpr double order_of_losses = 1.75;          // in place of 2.5: reference_lossy.csv (2026-11-22)
inline constexpr Differences lost_at_a_point{1.0, 6.0};  // rods, of which ε is known exactly (2026-11-22)
inline constexpr double unresolved_at_a_point = 0.5;     // of U, the same rods

/// Of bodies known at a point (few_modes.hpp): k at a cutoff of 4, and how it falls with cutoff and speed.
struct FewModes {
  double at_4, power;
  double speed, speed_power, fast;  ///< speed at which it is that, and the least factor of faster ones
  double most;
};

// Spheres by modes up to 1.5 to 18 c/R, at walls, balls and half-spaces, 400 impacts at up to eight numbers of modes
// each; hollow ones, radii 0.5 to 0.9, 240 impacts (numerics, 20; 2026-11-30).
inline constexpr FewModes few_modes{0.35, 0.5, 1e-3, 0.25, 0.7, 2.0};
inline constexpr double share_of_few_modes_from = 8.0;  // below, the share of U that comes back is that of this cutoff

// Nodes of lossy bodies: reference_lossy.csv (2026-11-23).
inline constexpr double nodes_of_balls = 12.0, nodes_on_a_line = 2.1;
inline constexpr double relaxing_nodes = 0.7, always_left = 0.03;  // nodes that relax (numerics, 9; 2026-11-29)

/// A constant of rough or coated faces at walls and between bodies, which ring, and on half-spaces and plates.
struct OnFaces {
  double at_walls, on_waves;
};

// Of what is lost: over n² of edges, as far as asperities do not smear them out, and of what coats take; over (h/a)⁴ of
// asperities. 144 impacts with 16 to 128 nodes, and reference_faces.csv (numerics, 16; 2026-11-29, c₄ 2026-11-30).
inline constexpr OnFaces nodes_of_edges{0.3, 0.05}, nodes_of_coats{3.0, 0.3};
inline constexpr OnFaces nodes_of_asperities{4.0, 0.2}, nodes_of_asperities_on_a_line{0.3, 0.1};
inline constexpr double nodes_of_lossy_coats = 6.0;
// Of force and time, over n²; of the compression, over h²/R: the same.
inline constexpr double nodes_of_pulse = 0.05, spacing_of_balls = 0.026, spacing_on_a_line = 0.013;

// Half-spaces: reference_half_spaces.csv (2026-11-22). Plates: 60 random impacts, reference_plates.csv (2026-11-28).
inline constexpr double least_returned = 0.5;  // of the doubt, where only the body gives back
inline constexpr double waves_of_a_half_space = 3e-5, waves_of_a_plate = 3e-6;  // left out, of the compliance
inline constexpr double calm_on_a_plate = 0.5;                                  // of the doubt of a single run

inline constexpr double spacing_on_waves = 0.03;  // over n² rings with friction: 76 balls, 95 % (2026-11-29)

// Of a contact that yields, over a/R (of times over its square): elastic bodies with and without its law, at walls, in
// pairs, on half-spaces and plates, a/R from 0.03 to 0.46 (numerics, 17; 2026-11-29). The fit of the law:
// studies/yield.
inline constexpr double place_of_ringing = 2.0, place_of_radiation = 0.3, force_at_a_place = 0.05, on_a_plate = 0.3;
inline constexpr double time_at_a_place = 0.3, law_of_yield = 0.01;
inline constexpr double law_of_one =
    0.15;  // of ε², where an elastic body meets one that yields: studies/yield/waves.csv

/// The other quantities: reference.csv and all sets after it (2026-11-22).
inline constexpr Differences contact_time{1.5, 5.0};  // at which waves open or close the contact; all sets (2026-11-27)
inline constexpr Differences last_touch{1.0, 4.0};    // of a ball that a plate follows: plates (2026-11-26)
inline constexpr Differences max_force{1.5, 4.0};     // the peak of a force that jumps about
inline constexpr Differences force_of_waves{1.0, 4.0};  // of a ball on a half-space or plate: 182 of them (2026-11-28)
inline constexpr Differences smooth{2.0, 6.0};          // what is integrated twice, or between two parts of the impulse
inline constexpr double focus = 0.6;                    // of √U: an edge focuses a wave, ν → ±1; reference.csv
inline constexpr double roughness = 0.05;               // of √U of balls: 64 at walls (2026-11-28)
/// The same of a hollow ball is larger by this times b⁶: the waves in its shell come back to the contact. Hollow balls
/// at a wall, b = 0.5 to 0.98, v = 1e-4 to 0.05: 0.08 at 0.5, 0.3 at 0.8, 1.8 at 0.9, 3.3 at 0.95 (2026-11-30).
inline constexpr double roughness_of_shells = 4.5;
/// The same waves take or give a share of U, times b⁶, and let the order of the losses fall by so much, times b⁶.
/// 92 random hollow balls at a wall, b = 0.5 to 0.98, ν = 0 to 0.47, v = 1e-5 to 0.1 (2026-11-30).
inline constexpr double share_of_shells = 0.08, slower_in_shells = 1.0;
inline constexpr double turn = 0.008;         // of U, missing at closest approach: reference.csv
inline constexpr double squared_step = 10.0;  // of Δt²/t: 147 random half-spaces (2026-11-28)
inline constexpr double ripple = 0.005;       // of the mean of a force that begins with a jump: rods (2026-11-28)
inline constexpr double blur = 0.5;           // of the period of that ripple, in which it ends: rods (2026-11-28)

/// How s′ and ε_n of oblique impacts follow from the differences of runs.
struct ObliqueDifferences {
  double order, safety;
  double of_few;  ///< the safety after three runs
};

// 111 random impacts of disks, and Maw's curve for spheres (docs/developer/derivations/oblique.md; 2026-11-24).
inline constexpr ObliqueDifferences on_rings{1.4, 3.0, 5.0}, of_one_kind{1.7, 2.0, 3.0}, where_mixing{1.0, 2.5, 3.5};
inline constexpr double spacing_where_mixing = 0.1;  // of what n points leave open where directions do not mix
inline constexpr double sign_change = 0.1, most_sign_change = 1.5;  // over β/μ, and at most
inline constexpr double normal_where_mixing = 0.2;                  // of ε_n, over β min(μ, β²/μ)

/// Points of a contact with friction: those that 111 random impacts needed for errors of points and of cutoff alike.
struct ObliquePoints {
  double usual, cutoff, power;  ///< usual points at a cutoff, and how they grow with it
  double share;                 ///< of the error that is wanted, which the points may leave
  double most, where_too_fine;  ///< computed; where more were wanted
  double of_first;              ///< the share of the first run
};
inline constexpr ObliquePoints points_on_rings{40.0, 32.0, 0.7, 0.9, 256.0, 256.0, 1.0};
inline constexpr ObliquePoints points_where_mixing{7.0, 1.0, 0.5, 0.8, 112.0, 64.0, 0.8};

}  // namespace stoss::calibration
