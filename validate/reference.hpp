#pragma once

#include <string>

namespace validate {

/// Computes the reference values and writes them to a CSV file. Takes minutes.
/// @throws std::runtime_error if the file cannot be written
void make_reference(const std::string& path);

/// The same at points to which no constant was fitted. @throws std::runtime_error as make_reference
void make_unseen_reference(const std::string& path);

/// Computes the reference values of pairs. Takes minutes. @throws std::runtime_error as make_reference
void make_pair_reference(const std::string& path);

/// Computes the reference values of spheres. Takes minutes. @throws std::runtime_error as make_reference
void make_sphere_reference(const std::string& path);

/// Computes those of hollow spheres: validate/data/reference_hollow.csv. @throws std::runtime_error as above
void make_hollow_reference(const std::string& path);

/// Computes those of half-spaces: validate/data/reference_half_spaces.csv. @throws std::runtime_error as above
void make_half_space_reference(const std::string& path);

/// Computes those of plates: validate/data/reference_plates.csv. @throws std::runtime_error as above
void make_plate_reference(const std::string& path);

/// The same of others, much finer: validate/data/reference_plates_unseen.csv. @throws std::runtime_error as above
void make_unseen_plate_reference(const std::string& path);

/// Computes those of bodies by their modes: validate/data/reference_modal.csv. @throws std::runtime_error as above
void make_modal_reference(const std::string& path);

/// Computes those of lossy spheres and disks: validate/data/reference_lossy.csv. @throws std::runtime_error as above
void make_lossy_reference(const std::string& path);

/// Computes those of bodies that relax: validate/data/reference_relaxing.csv. @throws std::runtime_error as above
void make_relaxing_reference(const std::string& path);

/// Computes those of rough and coated faces: validate/data/reference_faces.csv. @throws std::runtime_error as above
void make_face_reference(const std::string& path);

/// Computes those of vibrating bodies: validate/data/reference_vibrating.csv. @throws std::runtime_error as above
void make_vibrating_reference(const std::string& path);

/// Computes those of oblique impacts: validate/data/reference_oblique.csv. @throws std::runtime_error as above
void make_oblique_reference(const std::string& path);

}  // namespace validate
