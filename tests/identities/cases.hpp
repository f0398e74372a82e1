#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "identities/solids.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/wall.hpp"

namespace stoss::test {

/// Who meets what, how fast: a line of the table of the identity suite.
struct Case {
  std::string name;
  Solid first;
  std::optional<Solid> second;               ///< none: a wall
  Relaxation relaxation, second_relaxation;  ///< times in R/c of each body
  bool half_space = false;                   ///< of the material of `second`, whose size means nothing
  double thickness = 0.0;                    ///< of a plate or strip in its stead; 0: a half-space or half-plane
  std::vector<MaterialLoss> layers;          ///< of as many equal layers of a plate, times in R/c of `second`
  bool soft = false;                         ///< an exponential wall, without the modes above the cutoff
  double asperities = 0.0;                   ///< of the first body, in its R
  Tail tail = Tail::radiating;               ///< at a hard wall and between two bodies
  double speed = 0.0;
  double cutoff = 0.0;
};

/// A case is known by its name.
inline void PrintTo(const Case& its, std::ostream* out) { *out << its.name; }

/// All cases: bodies × what they can meet × speeds.
[[nodiscard]] const std::vector<Case>& all_cases();

/// Those of two bodies that move, of two equal ones, and of exponential walls.
[[nodiscard]] std::vector<Case> pairs();
[[nodiscard]] std::vector<Case> equal_pairs();
[[nodiscard]] std::vector<Case> soft_walls();

/// Those of them that friction can turn: of round bodies, at no exponential wall, with the tail on which it is stable.
[[nodiscard]] std::vector<Case> rubbing(std::vector<Case> cases);

[[nodiscard]] bool is_rod(const Case& its);

/// Whether a material takes energy.
[[nodiscard]] bool is_lossy(const Case& its);

/// The contact of a case, its second body or its wall included.
[[nodiscard]] Contact contact_of(const Case& its);

/// The same bodies with the second called the first, in its units.
[[nodiscard]] Case swapped(const Case& its);

/// The same bodies measured in other units of length, modulus and density.
[[nodiscard]] Case in_units(const Case& its, double length, double modulus, double density);

}  // namespace stoss::test
