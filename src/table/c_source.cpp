// A function of the speed, and one of the ratio of radii as well: the same functions in C, with one more argument.
#include "stoss/table/c_source.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "table/arguments.hpp"
#include "table/axes.hpp"
#include "table/c_grid.hpp"
#include "table/c_text.hpp"

namespace stoss {
namespace {

constexpr std::string_view at = R"(
/* Restitution and its error; what is not a number where the table says nothing. */
@NAME@_FUNCTION void @name@_at(double speed@ratio@, double *found)
{
  double v = fabs(speed), p = @place@;
  const int inside = v >= @NAME@_SLOWEST && v <= @NAME@_FASTEST@inside@;
  if (!inside) {
    found[0] = found[1] = HUGE_VAL - HUGE_VAL;
    if (!(v >= 0.0)@unknown@) return;
    found[1] = HUGE_VAL;
@outside@  }
  @name@_look_up(log(v), 0.0, p, found);
  if (!inside) found[1] = HUGE_VAL;
}
)";

std::vector<std::string> comment(const RestitutionFunction& function, const TableLabel& label) {
  const bool clamps = function.beyond() == Beyond::clamp;
  std::vector<std::string> lines{
      label.by_models ? "Coefficient of restitution against the speed of approach, with yield and adhesion as models."
                      : "Coefficient of restitution of elastic bodies against their speed of approach.",
      "",
      "  @name@_restitution(v)        at the speed of approach v, in " + label.unit + "; its sign does not count",
      "  @name@_restitution_error(v)  its error, interpolation included: at most " +
          table::at_most(function.greatest_error()),
      "",
      "Speeds go from @NAME@_SLOWEST to @NAME@_FASTEST. Beyond, the coefficient is " +
          std::string(clamps ? "that at the nearer end," : "not a number,"),
      "and its error HUGE_VAL. NaN gives NaN.",
      "",
      "A cubic in ln v, monotone where the values are, between values computed at " +
          std::to_string(function.values().speeds.size()) + " speeds.",
      ""};
  if (label.by_models) {
    const std::vector<std::string> more{
        "That error is of computation and interpolation alone. Beside it stand the spread of the",
        "models, which differ from the coefficient by up to " + table::at_most(*label.by_models) +
            ", and the uncertainty of the constants:",
        "stoss predict says both for each speed.", ""};
    lines.insert(lines.begin() + 5, more.begin(), more.end());
  }
  return lines;
}

std::vector<std::string> comment(const PairTable& pairs, const TableLabel& label) {
  const bool clamps = pairs.beyond() == Beyond::clamp;
  const std::string inverse = pairs.values().alike ? "; its inverse is the same pair" : "";
  return {
      "Coefficient of restitution of two elastic bodies against their speed of approach and the ratio of their radii.",
      "",
      "  @name@_restitution(v, r)        at the speed of approach v, in " + label.unit + "; its sign does not count",
      "  @name@_restitution_error(v, r)  its error, interpolation included: at most " + shown(pairs.greatest_error()),
      "",
      "r is the radius of the second body over that of the first" + inverse + ".",
      "Speeds go from @NAME@_SLOWEST to @NAME@_FASTEST, ratios from @NAME@_SMALLEST to @NAME@_GREATEST.",
      "Beyond, the coefficient is " + std::string(clamps ? "that at the nearer end," : "not a number,") +
          " and its error HUGE_VAL. NaN gives NaN.",
      "",
      "Values were computed at " + std::to_string(pairs.values().speeds.size()) + " speeds and " +
          std::to_string(pairs.values().ratios.size()) + " ratios.",
      ""};
}

/// The header of one table. @param about its first comment
template <typename Face>
std::string header(const std::string& name, const Face& face, std::vector<std::string> about, const TableLabel& label) {
  table::require_c_name(label.name);
  const table::CGrid grid{name + "_restitution", face.values(), face.nodes(), face.errors()};
  const bool mixture = grid.values.ratios.size() > 1;
  const table::CRange range(grid.values.ratios, grid.values.alike);
  std::string outside = "    return;\n";
  if (face.beyond() == Beyond::clamp) {
    outside = (mixture ? "    if (!(ratio > 0.0)) return;\n" : "") + range.nearest;
  }
  std::vector<std::string> arguments{"speed"};
  if (mixture) arguments.emplace_back("ratio");
  const std::string body = table::c_limits(grid.values.speeds, grid.values.ratios, label.scale) + "\n" +
                           table::c_look_up({grid}, label.scale) + std::string(at) +
                           table::c_numbers_of(arguments, {"restitution", "restitution_error"});
  return table::c_file(name, table::c_description(std::move(about), name, label),
                       table::filled(body, name,
                                     {{"place", range.place},
                                      {"inside", range.inside},
                                      {"ratio", mixture ? ", double ratio" : ""},
                                      {"unknown", mixture ? " || !(ratio >= 0.0 || ratio < 0.0)" : ""},
                                      {"outside", outside}}));
}

}  // namespace

void validate(const TableLabel& label) {
  table::require_c_name(label.name);
  (void)table::speed_range(1.0, 1.0, label.scale);
}

std::string c_header(const RestitutionFunction& function, const TableLabel& label) {
  if (function.beyond() == Beyond::law) {
    throw InvalidInput::out_of_range("beyond", "law", "error or clamp", "a table in C has no law of slow impacts");
  }
  return header(label.name, function, comment(function, label), label);
}

std::string c_header(const PairTable& pairs, const TableLabel& label) {
  return header(label.name + "_pair", pairs, comment(pairs, label), label);
}

}  // namespace stoss
