// Each grid has its places, its nodes and the errors of its cells. A cell is found as by numeric::Bins.
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "check.hpp"
#include "numeric/bins.hpp"
#include "stoss/table/c_source.hpp"
#include "table/arguments.hpp"
#include "table/axes.hpp"
#include "table/c_text.hpp"
#include "table/rule/c_rule_text.hpp"

namespace stoss {
namespace {

/// An axis of a grid that counts.
struct Axis {
  std::string name;      ///< of its array
  std::string of;        ///< what its places are
  std::string variable;  ///< in C
  std::vector<double> places;
};

std::vector<Axis> axes_of(const std::string& part, const RuleGrid& grid, double scale) {
  std::vector<Axis> axes{{part + "_speeds", "ln(speed)", "x", {}}};
  for (const double each : grid.speeds) axes[0].places.push_back(std::log(each * scale));
  if (grid.slips.size() > 1) axes.push_back({part + "_slips", "z", "z", grid.slips});
  if (grid.ratios.size() > 1) {
    axes.push_back({part + "_ratios", "(ratio - 1)/(ratio + 1)", "p", {}});
    for (const double each : grid.ratios) axes.back().places.push_back(place_of_ratio(each));
  }
  return axes;
}

std::string arrays(const std::string& part, const std::vector<Axis>& axes, const std::vector<double>& nodes,
                   const std::vector<double>& errors) {
  std::string text;
  for (const Axis& axis : axes) {
    text += table::c_array("double", axis.name, axis.of, table::c_numbers(axis.places));
    text += table::c_array("int", axis.name + "_first", "interval in which each of equal parts of it begins",
                           table::c_numbers(numeric::Bins(axis.places).first()));
  }
  text += table::c_array("double", part + "_nodes", "value at each crossing, and its derivatives along the axes",
                         table::c_numbers(nodes));
  return text + table::c_array("double", part + "_errors", "of each cell", table::c_numbers(errors));
}

/// Lines that set the value of a grid, and its error, found[at] and found[at + 1].
std::string look_up(const std::string& part, const std::vector<Axis>& axes, std::size_t at) {
  const std::size_t last = axes.size() - 1;
  std::vector<std::size_t> next(axes.size(), std::size_t{1} << axes.size()), cells(axes.size(), 1);
  for (std::size_t d = last; d > 0; --d) {
    next[d - 1] = next[d] * axes[d].places.size();
    cells[d - 1] = cells[d] * (axes[d].places.size() - 1);
  }
  std::string steps, intervals, node, cell;
  for (std::size_t d = 0; d <= last; ++d) {
    const Axis& axis = axes[d];
    const std::string k = "k[" + std::to_string(d) + "]", count = std::to_string(axis.places.size() - 1);
    steps += (d > 0 ? ", " : "") + std::to_string(next[d]);
    intervals += "    " + k + " = @name@_interval(" + axis.name + ", " + axis.name + "_first, " + count + ", " +
                 table::c_number(numeric::Bins(axis.places).per_unit()) + ", " + axis.variable +
                 ");\n    @name@_weigh(" + axis.name + ", " + k + ", @name@_between(" + axis.variable + ", " +
                 axis.name + ", " + count + "), w + " + std::to_string(4 * d) + ");\n";
    node += (d > 0 ? " + " : "") + k + " * " + std::to_string(next[d]);
    cell += (d > 0 ? " + " : "") + k + " * " + std::to_string(cells[d]);
  }
  const std::string sum = "@name@_sum_" + std::to_string(axes.size());
  return "  {\n    static const int next[] = {" + steps + "};\n" + intervals + "    found[" + std::to_string(at) +
         "] = " + sum + "(" + part + "_nodes + (" + node + "), next, w);\n    found[" + std::to_string(at + 1) +
         "] = " + part + "_errors[" + cell + "];\n  }\n";
}

constexpr std::string_view between = R"(
/* A place within the range of places x. */
@NAME@_FUNCTION double @name@_between(double at, const double *x, int last)
{
  if (at < x[0]) return x[0];
  return at > x[last] ? x[last] : at;
}
)";

std::vector<std::string> comment(const RuleTable& rule, const TableLabel& label, const std::string& name) {
  const RuleValues& values = rule.values();
  const bool mixture = values.sliding.ratios.size() > 1;
  std::vector<std::string> lines{
      "Collision rule of two round elastic bodies with friction: speed v of approach along the normal, sliding s of "
      "the",
      "first body's point of contact over the second's, Coulomb's friction, ratio of the second radius to the first.",
      "",
      "  @name@_restitution(v, s, friction, ratio)  of the normal velocity, error at most " +
          table::at_most(rule.greatest_restitution_error()),
      "  @name@_sliding(v, s, friction, ratio)      s afterwards",
      "  @name@_collide_2d(&a, &b, normal, friction), _3d  changes velocities and spins; normal from a to b; 0: they",
      "                                             do not approach, nothing changes",
      "",
      "Velocities are in " + label.unit + ", spins times radii too. Errors, interpolation included, are those of",
      "@name@_restitution_error and @name@_sliding_error, the latter over |v_t| + |spin R| of both + friction v: at",
      "most " + table::at_most(rule.greatest_sliding_error()) + ".",
      "",
      values.friction ? "The friction must be @NAME@_FRICTION; with another one values are not numbers."
                      : "The friction may be any.",
      mixture ? "Ratios go from @NAME@_SMALLEST to @NAME@_GREATEST" +
                    std::string(values.alike ? "; the inverse is the same pair." : ".")
              : "The ratio does not count.",
      "Speeds go from @NAME@_SLOWEST to @NAME@_FASTEST. Beyond, values are " +
          std::string(rule.beyond() == Beyond::clamp ? "those of the nearer end," : "not numbers,") +
          " errors HUGE_VAL.",
      "",
      "Where s = 0 there is no friction. |s afterwards| <= |s| and restitution <= 1: no collision gains energy.",
      ""};
  for (std::string& line : lines) line = table::filled(line, name);
  lines.insert(lines.end(), label.provenance.begin(), label.provenance.end());
  while (lines.back().empty()) lines.pop_back();
  return lines;
}

}  // namespace

std::string c_header(const RuleTable& rule, const TableLabel& label) {
  table::require_c_name(label.name);
  const std::string name = label.name + "_rule";
  const RuleValues& values = rule.values();
  const auto [slowest, fastest] =
      table::speed_range(values.sliding.speeds.front(), values.sliding.speeds.back(), label.scale);
  const std::vector<Axis> normal = axes_of(name + "_restitution", values.restitution, label.scale),
                          along = axes_of(name + "_sliding", values.sliding, label.scale);
  const std::vector<double>& ratios = values.sliding.ratios;
  const bool mixture = ratios.size() > 1;
  const std::string s = "(ratio - 1.0) / (ratio + 1.0)";
  const std::vector<std::pair<std::string, std::string>> fillings{
      {"place", !mixture       ? "0.0"
                : values.alike ? "fabs(" + s + ")"
                               : s},
      {"friction", values.friction ? "!(friction < @NAME@_FRICTION) && !(friction > @NAME@_FRICTION)"
                                   : "friction >= 0.0 && friction < HUGE_VAL"},
      {"ratio", mixture ? " && ratio > 0.0 && ratio < HUGE_VAL" : ""},
      {"unused", mixture ? "" : "  (void)ratio;\n"},
      {"inside", mixture ? " && p >= " + table::c_number(place_of_ratio(ratios.front()) - rounding_of_ratios) +
                               " && p <= " + table::c_number(place_of_ratio(ratios.back()) + rounding_of_ratios)
                         : ""},
      {"outside", rule.beyond() == Beyond::clamp ? "" : "    return;\n"}};
  std::string limits = "#define @NAME@_SLOWEST " + table::c_number(slowest) + "\n#define @NAME@_FASTEST " +
                       table::c_number(fastest) + "\n";
  if (mixture) {
    limits += "#define @NAME@_SMALLEST " + table::c_number(ratios.front()) + "\n#define @NAME@_GREATEST " +
              table::c_number(ratios.back()) + "\n";
  }
  if (values.friction) limits += "#define @NAME@_FRICTION " + table::c_number(*values.friction) + "\n";
  std::string body = limits + "\n" +
                     arrays(name + "_restitution", normal, rule.restitution_nodes(), rule.restitution_errors()) +
                     arrays(name + "_sliding", along, rule.sliding_nodes(), rule.sliding_errors());
  body += std::string(table::c_interval_function) + std::string(between) + std::string(table::c_cubic_functions);
  body +=
      "\n@NAME@_FUNCTION void @name@_look_up(double x, double z, double p, double *found)\n{\n  double w[12];\n"
      "  int k[3];\n";
  body +=
      look_up(name + "_restitution", normal, 0) + look_up(name + "_sliding", along, 2) + "  (void)z;\n  (void)p;\n}\n";
  body += std::string(table::c_rule_functions) + std::string(table::c_collide_functions);
  return table::c_file(name, comment(rule, label, name), table::filled(body, name, fillings));
}

}  // namespace stoss
