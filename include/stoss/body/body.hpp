#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "stoss/poll.hpp"

namespace stoss {

/// The kept modes of one angular order n, as a structure of arrays over the index l.
struct ModeGroup {
  int order = 0;                     ///< n
  std::vector<double> omega;         ///< ω > 0, c/R
  std::vector<double> radial;        ///< C, weight of the group's radial shape c
  std::vector<double> tangential;    ///< S, weight of the group's tangential shape s
  std::size_t sum_shape = 0;         ///< row of ContactGrid::shape that holds c + s
  std::size_t difference_shape = 0;  ///< row of ContactGrid::shape that holds c − s
  std::vector<int> index{};          ///< l of each mode; empty: 0, 1, 2, …
};

/// Places at which a body can touch the wall. A node stands for itself and its mirror image.
/// A mode moves node i by Q (C c_i + S s_i) towards the wall. Groups may share rows of shapes: for a disk
/// c + s = cos(n + 1)φ and c − s = cos(n − 1)φ.
struct ContactGrid {
  std::vector<double> coordinate;  ///< arc length from the first point of contact, R; ascending
  std::vector<double> recess;      ///< distance of the undeformed node behind that first point, R
  std::vector<double> measure;     ///< length of edge that the node stands for, both sides, R
  std::vector<double> impedance;   ///< Z, force per velocity of an outgoing plane wave, ρcR
  std::vector<double> shape;       ///< rows × nodes, row-major; see ModeGroup
};

/// All that an impact needs to know of an elastic body, in its own units (for a disk R = c = ρ = 1). Motion is along
/// x towards the wall. A new body is a function that fills this structure (docs/architecture.md).
struct Body {
  std::string name;             ///< with its parameters, for provenance
  double mass = 0.0;            ///< of the body, and of every mode
  double extent = 0.0;          ///< distance from the centre of mass to the first point of contact
  double cutoff = 0.0;          ///< all modes with ω ≤ cutoff are in `groups` (but see with_modes)
  double max_half_width = 0.0;  ///< of the whole edge, R: the widest grid; 0: one point of contact
  /// Largest stable step at a hard wall: above it one kick moves the kept modes of some order
  /// further than the residual compliance does.
  double stable_step = std::numeric_limits<double>::infinity();
  std::vector<ModeGroup> groups;  ///< kept modes

  /// Expected greatest half-width of the contact, for an impact at this speed.
  std::function<double(double speed)> expected_half_width;

  /// A grid of `nodes` nodes from the first point of contact to at least half_width.
  std::function<ContactGrid(double half_width, int nodes)> grid;

  /// Static compliance between the nodes of a grid of the modes that are not kept, W (nodes × nodes, symmetric
  /// positive definite): displacement of node i towards the body per force on node j.
  std::function<std::vector<double>(const ContactGrid& grid, const Poll& poll)> residual_compliance;

  /// Second moment of the modes that are not kept, V (nodes × nodes, symmetric, positive semidefinite): like W with
  /// 1/ω⁴ for 1/ω². To forces that vary slowly these modes answer with W f − V f̈.
  std::function<std::vector<double>(const ContactGrid& grid, const Poll& poll)> residual_second_moment;
};

/// Makes a body with all modes up to a cutoff.
using BodyMaker = std::function<Body(double cutoff, const Poll& poll)>;

/// Checks what an impact relies on: positive finite mass, extent and cutoff; groups with arrays of one length, finite
/// amplitudes and 0 < ω ≤ cutoff; all functions.
/// @throws InvalidInput naming the body and what is wrong with it
void validate(const Body& body);

/// Number of kept modes.
[[nodiscard]] std::size_t mode_count(const Body& body);

/// A body with only some of the kept modes of another, as the paper selects them. It is for
/// exponential walls: a hard wall needs the compliance of the modes left out, so the residual
/// functions refuse. With every flag set it is `body` itself.
/// @param keep one flag for each mode, in the order of Body::groups
/// @throws InvalidInput for another number of flags, or none set
[[nodiscard]] Body with_modes(const Body& body, const std::vector<bool>& keep);

}  // namespace stoss
