// A function of the speed, and one of the ratio of radii as well: the same functions, with one more argument.
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
@comment@Restitution and its error; what is not a number where the table says nothing.@done@
@function:at@(@number:speed@@ratio@, @out:found@)@gives_nothing@
  @variable:v@ = @absolute@speed)@also_variable:p@ = @place@;
  @flag:inside@ = v >= @NAME@_SLOWEST && v <= @NAME@_FASTEST@inside@;
  @if@!inside@block@
    @both_nan@;
    @if@!(v >= 0.0)@unknown@@then@return;@end@
    found[1] = @infinity@;
@outside@  }
  @name@_look_up(@log@v), 0.0, p, found);
  @if@!inside@then@found[1] = @infinity@;@end@
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
      "and its error @infinity@. NaN gives NaN.",
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
          " and its error @infinity@. NaN gives NaN.",
      "",
      "Values were computed at " + std::to_string(pairs.values().speeds.size()) + " speeds and " +
          std::to_string(pairs.values().ratios.size()) + " ratios.",
      ""};
}

/// The file of one table. @param about its first comment
template <typename Face>
std::string file(const std::string& name, const Face& face, std::vector<std::string> about, const TableLabel& label,
                 const table::Language& language) {
  table::require_c_name(label.name);
  const table::CGrid grid{name + "_restitution", face.values(), face.nodes(), face.errors()};
  const bool mixture = grid.values.ratios.size() > 1;
  const table::CRange range(grid.values.ratios, grid.values.alike, language);
  std::string outside = "    return;\n";
  if (face.beyond() == Beyond::clamp) {
    outside = (mixture ? table::worded("    @if@!(ratio > 0.0)@then@return;@end@\n", language) : "") + range.nearest;
  }
  std::vector<std::string> arguments{"speed"};
  if (mixture) arguments.emplace_back("ratio");
  const std::string body = table::c_limits(grid.values.speeds, grid.values.ratios, label.scale, language) + "\n" +
                           table::c_look_up({grid}, label.scale, language) + table::worded(at, language) +
                           table::c_numbers_of(arguments, {"restitution", "restitution_error"}, language);
  return table::c_file(name, table::c_description(std::move(about), name, label, language),
                       table::filled(body, name,
                                     {{"place", range.place},
                                      {"inside", range.inside},
                                      {"ratio", mixture ? table::worded(", @number:ratio@", language) : ""},
                                      {"unknown", mixture ? " || !(ratio >= 0.0 || ratio < 0.0)" : ""},
                                      {"outside", outside}}),
                       language);
}

std::string of(const RestitutionFunction& function, const TableLabel& label, const table::Language& language) {
  if (function.beyond() == Beyond::law) {
    throw InvalidInput::out_of_range("beyond", "law", "error or clamp", "a table as code has no law of slow impacts");
  }
  return file(label.name, function, comment(function, label), label, language);
}

std::string of(const PairTable& pairs, const TableLabel& label, const table::Language& language) {
  return file(label.name + "_pair", pairs, comment(pairs, label), label, language);
}

}  // namespace

void validate(const TableLabel& label) {
  table::require_c_name(label.name);
  (void)table::speed_range(1.0, 1.0, label.scale);
}

std::string c_header(const RestitutionFunction& function, const TableLabel& label) {
  return of(function, label, table::language_c());
}
std::string rust_module(const RestitutionFunction& function, const TableLabel& label) {
  return of(function, label, table::language_rust());
}
std::string js_module(const RestitutionFunction& function, const TableLabel& label) {
  return of(function, label, table::language_js());
}

std::string c_header(const PairTable& pairs, const TableLabel& label) { return of(pairs, label, table::language_c()); }
std::string rust_module(const PairTable& pairs, const TableLabel& label) {
  return of(pairs, label, table::language_rust());
}
std::string js_module(const PairTable& pairs, const TableLabel& label) {
  return of(pairs, label, table::language_js());
}

}  // namespace stoss
