#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stoss/body/body.hpp"
#include "stoss/encounter/solid.hpp"
#include "stoss/quantity.hpp"

/// The table of kinds: what can meet, and the numbers that make it. Option texts, keys, documents, refusals and the
/// ranges of every face follow from it.
namespace stoss {

/// A number that makes something of a kind.
struct Parameter {
  std::string_view name;
  std::string_view unit;                ///< in SI; "" for a pure number
  std::optional<double> default_value;  ///< without a material, where it is not given; none: it must be given
  double low, high;                     ///< of the range, in units of the first body
  bool low_included;
  bool of_material;  ///< given by the material, where there is one
  std::string_view help;
};

/// Numbers by the names of their parameters.
using Values = std::map<std::string, double, std::less<>>;

/// What can meet.
struct Kind {
  std::string_view name;
  std::string_view plural;
  std::string_view help;
  bool wall;     ///< has no body: a law of force, or a word for one
  bool bounded;  ///< has a size and a mass, and can be the first
  bool can_be_rigid;
  bool can_yield;      ///< its material may have a yield strength
  bool has_plane;      ///< a section of a solid, thin or long
  Contour contour;     ///< it meets what has the same
  UnitSystem own, si;  ///< of results of which it is the first
  std::vector<Parameter> parameters;
  std::function<Solid(const Values&)> solid;  ///< of all its numbers, in consistent units; empty for a wall
  /// Puts a further layer below all others, infinitely thick where its thickness is infinite; empty of what has none.
  std::function<void(Solid&, const Values&)> add_layer{};
  bool from_file = false;  ///< given by a document of its own in SI (modal_file.hpp), not by numbers
};

/// Layers that one thing may have.
inline constexpr std::size_t most_layers = 20;

/// Whether a parameter says how a material loses energy.
[[nodiscard]] inline bool is_loss(std::string_view name) { return name == "loss_time" || name == "quality"; }

/// Whether a parameter says how rough a face is, with what it is coated, or from which stress on it yields.
[[nodiscard]] inline bool is_of_face(std::string_view name) {
  return name == "roughness" || name == "u0" || name.starts_with("coat") || name.starts_with("yield");
}

/// Whether a parameter is no size, and not of a layer but of all of them together.
[[nodiscard]] inline bool is_of_whole(std::string_view name) {
  return is_loss(name) || is_of_face(name) || name == "extra_mass";
}

/// Whether a parameter is a pure number that says what shape something has.
[[nodiscard]] inline bool is_shape(const Parameter& its) {
  return its.unit.empty() && !its.of_material && !is_of_whole(its.name);
}

/// All kinds, in the order in which they are named.
[[nodiscard]] const std::vector<Kind>& kinds();

/// The kind of that name. @throws InvalidInput if there is none
[[nodiscard]] const Kind& kind(std::string_view name);

/// A parameter of a kind; null if it has none of that name.
[[nodiscard]] const Parameter* parameter(const Kind& kind, std::string_view name);

/// Whether a body of one kind meets what is of the other.
[[nodiscard]] bool meets(const Kind& first, const Kind& against);

/// "a disk meets disks and half-planes; a sphere or …": of all kinds that can be the first.
[[nodiscard]] std::string who_meets_whom();

}  // namespace stoss
