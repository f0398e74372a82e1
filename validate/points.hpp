#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/relaxation.hpp"
#include "stoss/restitution/restitution.hpp"

namespace validate {

/// What restitution() gives with an error, in this order everywhere.
enum Quantity : std::size_t {
  lost_fraction,
  restitution_coefficient,
  contact_time,
  impulse_time,
  max_force,
  max_compression,
  quantities
};
inline constexpr std::array<const char*, quantities> quantity_names{
    "1−ε²", "ε", "contact time", "time of the impulse", "maximum force", "maximum compression"};

template <typename T>
using PerQuantity = std::array<T, quantities>;

/// An impact at a hard wall, or of two bodies of a kind, with reference values; their `error` is the uncertainty.
struct Point {
  double poisson = 0.0;
  std::optional<stoss::Disk> against{};  ///< in units of the first body, a sphere at a sphere; none: the wall
  double speed = 0.0;
  PerQuantity<std::optional<stoss::Estimate>> reference;
  std::optional<stoss::Estimate> finite_elements;  ///< of ε
  bool sphere = false;                             ///< instead of a disk
  double inner = 0.0;                              ///< of a sphere, radius of its hole
  double loss_time = 0.0;                          ///< of the first body
  stoss::Relaxation relaxation{};                  ///< of the first body
  stoss::Relaxation against_relaxation{};          ///< of what it meets
  bool half_space = false;                         ///< is what it meets, of the material of `against`
  bool rigid = false;                              ///< is the first body
  double temperature = 0.0;                        ///< of the bodies before the impact (stoss::thermal)
  double highest = 0.0;                            ///< frequency of their vibration
  long sample = 0;                                 ///< of that ensemble, seed 0
  std::optional<stoss::Encounter> encounter{};     ///< who meets whom, in place of all these numbers
};

/// How the bodies of a point vibrate before the impact.
stoss::Vibration vibration_of(const Point& point, const stoss::RefinableContact& contact);

/// Those at the wall: of validate/data/reference.csv, then of tests/data/restitution_hard_wall.csv.
/// @throws std::runtime_error if a file cannot be read
std::vector<Point> read_points();

/// Those at the wall to which no constant was fitted: of validate/data/reference_unseen.csv.
/// @throws std::runtime_error as read_points
std::vector<Point> read_unseen_points();

/// Spheres at the wall: those of validate/data/reference_spheres.csv. @throws std::runtime_error as read_points
std::vector<Point> read_spheres();

/// Hollow spheres at the wall: those of validate/data/reference_hollow.csv. @throws std::runtime_error as read_points
std::vector<Point> read_hollow();

/// Spheres on half-spaces and disks on half-planes: those of validate/data/reference_half_spaces.csv.
/// @throws std::runtime_error as read_points
std::vector<Point> read_half_spaces();

/// Lossy spheres and disks: those of validate/data/reference_lossy.csv. @throws std::runtime_error as read_points
std::vector<Point> read_lossy();

/// Spheres and disks that relax: those of validate/data/reference_relaxing.csv. @throws std::runtime_error as
/// read_points
std::vector<Point> read_relaxing();

/// Spheres and disks with rough or coated faces: those of validate/data/reference_faces.csv.
/// @throws std::runtime_error as read_points
std::vector<Point> read_faces();

/// Disks, spheres and pairs that vibrate: those of validate/data/reference_vibrating.csv.
/// @throws std::runtime_error as read_points
std::vector<Point> read_vibrating();

/// Pairs of disks: those of validate/data/reference_pairs.csv. @throws std::runtime_error as read_points
std::vector<Point> read_pairs();

}  // namespace validate
