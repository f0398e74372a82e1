// Each grid has its places, its nodes and the errors of its cells. A cell is found as by numeric::Bins.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "check.hpp"
#include "numeric/interpolation.hpp"
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

  [[nodiscard]] std::size_t last() const { return places.size() - 1; }
  [[nodiscard]] bool same_as(const Axis& other) const { return variable == other.variable && places == other.places; }
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

/// The axes of two grids, those of the second that the first has too only once.
std::vector<Axis> without_twins(std::vector<Axis> axes, const std::vector<Axis>& others) {
  const std::size_t own = axes.size();
  for (const Axis& other : others) {
    const auto end = axes.begin() + static_cast<std::ptrdiff_t>(own);
    if (std::none_of(axes.begin(), end, [&](const Axis& each) { return each.same_as(other); })) axes.push_back(other);
  }
  return axes;
}

std::string arrays(const std::vector<Axis>& axes) {
  std::string text;
  for (const Axis& axis : axes) {
    text += table::c_array("double", axis.name, axis.of, table::c_numbers(axis.places));
    text += table::c_array("int", axis.name + "_first", "interval in which each of equal parts of it begins",
                           table::c_numbers(numeric::Bins(axis.places).first()));
  }
  return text;
}

std::string arrays(const std::string& part, const std::vector<double>& nodes, const std::vector<double>& errors) {
  return table::c_array("double", part + "_nodes", "value at each crossing, and its derivatives along the axes",
                        table::c_numbers(nodes)) +
         table::c_array("double", part + "_errors", "of each cell", table::c_numbers(errors));
}

/// Lines that find the interval k[i] of each axis, and the weights in it.
std::string intervals(const std::vector<Axis>& axes) {
  std::string text;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Axis& axis = axes[i];
    const std::string at = std::to_string(i);
    text += "  k[" + at + "] = @name@_weigh(" + axis.name + ", " + axis.name + "_first, " +
            std::to_string(axis.last()) + ", " + table::c_number(numeric::Bins(axis.places).per_unit()) + ", " +
            axis.variable + ", w[" + at + "]);\n";
  }
  return text;
}

/// Lines that set the value of a grid, and its error, found[at] and found[at + 1]. @param all axes that have weights
std::string look_up(const std::string& part, const std::vector<Axis>& axes, const std::vector<Axis>& all,
                    std::size_t at) {
  std::string steps, weights, node, cell;
  std::vector<std::size_t> next(axes.size(), std::size_t{1} << axes.size()), cells(axes.size(), 1);
  for (std::size_t d = axes.size() - 1; d > 0; --d) {
    next[d - 1] = next[d] * axes[d].places.size();
    cells[d - 1] = cells[d] * axes[d].last();
  }
  for (std::size_t d = 0; d < axes.size(); ++d) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const Axis& each) { return each.same_as(axes[d]); });
    const std::string i = std::to_string(same - all.begin()), more = d > 0 ? " + k[" : "k[";
    steps.append(", ").append(std::to_string(next[d]));
    weights.append(", w[").append(i).append("]");
    node.append(more).append(i).append("] * ").append(std::to_string(next[d]));
    cell.append(more).append(i).append("] * ").append(std::to_string(cells[d]));
  }
  return "  found[" + std::to_string(at) + "] = @name@_sum_" + std::to_string(axes.size()) + "(" + part + "_nodes + (" +
         node + ")" + steps + weights + ");\n  found[" + std::to_string(at + 1) + "] = " + part + "_errors[" + cell +
         "];\n";
}

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
      "  @name@_collide_2d(&a, &b, normal, friction), _3d  changes velocities and spins, with the normal from a to b,",
      "                                             of any length but 0. 1: done. 0: they do not approach, and -1: the",
      "                                             normal has no direction, an argument is not finite, negative, or",
      "                                             none of the table (friction, ratio); then nothing changes",
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
  const std::vector<Axis> all = without_twins(normal, along);
  std::string body = limits + "\n" + arrays(all) +
                     arrays(name + "_restitution", rule.restitution_nodes(), rule.restitution_errors()) +
                     arrays(name + "_sliding", rule.sliding_nodes(), rule.sliding_errors());
  body += std::string(table::c_interval_function) + std::string(table::c_cubic_functions);
  const std::string count = std::to_string(all.size());
  body += "\n@NAME@_FUNCTION void @name@_look_up(double x, double z, double p, double *found)\n{\n  double w[" + count +
          "][4];\n  int k[" + count + "];\n";
  body += intervals(all) + look_up(name + "_restitution", normal, all, 0) + look_up(name + "_sliding", along, all, 2) +
          "  (void)z;\n  (void)p;\n}\n";
  body += std::string(table::c_rule_functions) + std::string(table::c_collide_functions);
  return table::c_file(name, comment(rule, label, name), table::filled(body, name, fillings));
}

}  // namespace stoss
