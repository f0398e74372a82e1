// Each grid has its places, its nodes and the errors of its cells. A cell is found as by numeric::Bins, and its cubic
// is summed as by numeric::CubicGrid.
#include "table/c_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "numeric/interpolation.hpp"
#include "table/arguments.hpp"
#include "table/axes.hpp"
#include "table/c_text.hpp"

namespace stoss::table {
namespace {

constexpr std::string_view weights = R"(
/* The interval k of places x in which another one lies, and in it the weights of the cubic a + w0(b - a) + w1 a' - w2 b'
 * of values a, b and slopes a', b' at its ends. */
@NAME@_FUNCTION int @name@_weigh(const double *x, const int *first, int last, double bins, double at, double *w)
{
  double h, t, u;
  int k;
  k = @NAME@_INDEX((at - x[0]) * bins);
  if (k < 0) k = 0;
  if (k > last) k = last;
  k = first[k];
  while (k + 1 < last && at >= x[k + 1]) ++k;
  h = x[k + 1] - x[k];
  t = (at - x[k]) / h;
  u = 1.0 - t;
  w[0] = t * t * (1.0 + 2.0 * u);
  w[1] = h * t * u * u;
  w[2] = h * t * u * t;
  return k;
}
)";

/// Along one, two and three axes.
constexpr std::array<std::string_view, 3> sums{R"(
@NAME@_FUNCTION double @name@_sum_1(const double *a, int next, const double *w)
{
  const double *b = a + next;
  return a[0] + w[0] * (b[0] - a[0]) + w[1] * a[1] - w[2] * b[1];
}
)",
                                               R"(
@NAME@_FUNCTION double @name@_sum_2(const double *a, int next, int line, const double *w, const double *y)
{
  const double *b = a + line;
  const double begin = @name@_sum_1(a, next, w), end = @name@_sum_1(b, next, w);
  return begin + y[0] * (end - begin) + y[1] * @name@_sum_1(a + 2, next, w) - y[2] * @name@_sum_1(b + 2, next, w);
}
)",
                                               R"(
@NAME@_FUNCTION double @name@_sum_3(const double *a, int next, int line, int plane, const double *w, const double *y,
                                    const double *z)
{
  const double *b = a + plane;
  const double begin = @name@_sum_2(a, next, line, w, y), end = @name@_sum_2(b, next, line, w, y);
  return begin + z[0] * (end - begin) + z[1] * @name@_sum_2(a + 4, next, line, w, y) -
         z[2] * @name@_sum_2(b + 4, next, line, w, y);
}
)"};

/// An axis of a grid that counts.
struct Axis {
  std::string name;      ///< of its array
  std::string of;        ///< what its places are
  std::string variable;  ///< in C
  std::vector<double> places;

  [[nodiscard]] std::size_t last() const { return places.size() - 1; }
  [[nodiscard]] bool same_as(const Axis& other) const { return variable == other.variable && places == other.places; }
};

std::vector<Axis> axes_of(const CGrid& grid, double scale) {
  std::vector<Axis> axes{{grid.name + "_speeds", "ln(speed)", "x", {}}};
  for (const double each : grid.values.speeds) axes[0].places.push_back(std::log(each * scale));
  if (grid.values.slips.size() > 1) axes.push_back({grid.name + "_slips", "z", "z", grid.values.slips});
  if (grid.values.ratios.size() > 1) {
    axes.push_back({grid.name + "_ratios", "(ratio - 1)/(ratio + 1)", "p", {}});
    for (const double each : grid.values.ratios) axes.back().places.push_back(place_of_ratio(each));
  }
  return axes;
}

/// Where an axis, or one with the same places, is among others; their number if it is not.
std::size_t place_of(const Axis& axis, const std::vector<Axis>& all) {
  const auto same = std::find_if(all.begin(), all.end(), [&](const Axis& each) { return each.same_as(axis); });
  return static_cast<std::size_t>(same - all.begin());
}

/// The axes of grids, those that an earlier one has too only once.
std::vector<Axis> distinct_axes(const std::vector<CGrid>& grids, double scale) {
  std::vector<Axis> all;
  for (const CGrid& grid : grids) {
    for (const Axis& axis : axes_of(grid, scale)) {
      if (place_of(axis, all) == all.size()) all.push_back(axis);
    }
  }
  return all;
}

std::string arrays(const Axis& axis) {
  return c_array("double", axis.name, axis.of, c_numbers(axis.places)) +
         c_array("int", axis.name + "_first", "interval in which each of equal parts of it begins",
                 c_numbers(numeric::Bins(axis.places).first()));
}

std::string arrays(const CGrid& grid) {
  return c_array("double", grid.name + "_nodes", "value at each crossing, and its derivatives along the axes",
                 c_numbers(grid.nodes)) +
         c_array("double", grid.name + "_errors", "of each cell", c_numbers(grid.errors));
}

/// The line that finds the interval k[i] of an axis, and the weights in it.
std::string interval(const Axis& axis, const std::string& i) {
  return "  k[" + i + "] = @name@_weigh(" + axis.name + ", " + axis.name + "_first, " + std::to_string(axis.last()) +
         ", " + c_number(numeric::Bins(axis.places).per_unit()) + ", " + axis.variable + ", w[" + i + "]);\n";
}

/// Lines that set the value of a grid, and its error, found[at] and found[at + 1]. @param all axes that have weights
std::string value(const std::string& part, const std::vector<Axis>& axes, const std::vector<Axis>& all,
                  std::size_t at) {
  std::string steps, weights_of, node, cell;
  std::vector<std::size_t> next(axes.size(), std::size_t{1} << axes.size()), cells(axes.size(), 1);
  for (std::size_t d = axes.size() - 1; d > 0; --d) {
    next[d - 1] = next[d] * axes[d].places.size();
    cells[d - 1] = cells[d] * axes[d].last();
  }
  for (std::size_t d = 0; d < axes.size(); ++d) {
    const std::string i = std::to_string(place_of(axes[d], all)), more = d > 0 ? " + k[" : "k[";
    steps.append(", ").append(std::to_string(next[d]));
    weights_of.append(", w[").append(i).append("]");
    node.append(more).append(i).append("] * ").append(std::to_string(next[d]));
    cell.append(more).append(i).append("] * ").append(std::to_string(cells[d]));
  }
  return "  found[" + std::to_string(at) + "] = @name@_sum_" + std::to_string(axes.size()) + "(" + part + "_nodes + (" +
         node + ")" + steps + weights_of + ");\n  found[" + std::to_string(at + 1) + "] = " + part + "_errors[" + cell +
         "];\n";
}

}  // namespace

std::string c_look_up(const std::vector<CGrid>& grids, double scale) {
  const std::vector<Axis> all = distinct_axes(grids, scale);
  std::string text, intervals, values;
  for (std::size_t i = 0; i < all.size(); ++i) {
    text += arrays(all[i]);
    intervals += interval(all[i], std::to_string(i));
  }
  std::size_t dimensions = 0;
  for (std::size_t i = 0; i < grids.size(); ++i) {
    const std::vector<Axis> axes = axes_of(grids[i], scale);
    dimensions = std::max(dimensions, axes.size());
    values += value(grids[i].name, axes, all, 2 * i);
    text += arrays(grids[i]);
  }
  text += weights;
  for (std::size_t d = 0; d < dimensions; ++d) text += sums[d];
  const std::string count = std::to_string(all.size());
  return text + "\n@NAME@_FUNCTION void @name@_look_up(double x, double z, double p, double *found)\n{\n  double w[" +
         count + "][3];\n  int k[" + count + "];\n" + intervals + values + "  (void)z;\n  (void)p;\n}\n";
}

std::string c_numbers_of(const std::vector<std::string>& arguments, const std::vector<std::string>& names) {
  std::string declared, given, text;
  for (const std::string& each : arguments) {
    declared += (declared.empty() ? "double " : ", double ") + each;
    given += each + ", ";
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += "\n@NAME@_FUNCTION double @name@_" + names[i] + "(" + declared + ")\n{\n  double found[" +
            std::to_string(names.size()) + "];\n  @name@_at(" + given + "found);\n  return found[" + std::to_string(i) +
            "];\n}\n";
  }
  return text;
}

CRange::CRange(const std::vector<double>& ratios, bool alike)
    : place("0.0"),
      nearest(
          "    if (v < @NAME@_SLOWEST) v = @NAME@_SLOWEST;\n"
          "    if (v > @NAME@_FASTEST) v = @NAME@_FASTEST;\n") {
  if (ratios.size() < 2) return;
  place = "(ratio - 1.0) / (ratio + 1.0)";
  if (alike) place = "fabs(" + place + ")";
  const std::string first = c_number(place_of_ratio(ratios.front())), last = c_number(place_of_ratio(ratios.back()));
  nearest += "    if (!(p < " + last + ")) p = " + last + ";\n    if (p < " + first + ") p = " + first + ";\n";
  inside = " && p >= " + c_number(place_of_ratio(ratios.front()) - rounding_of_ratios) +
           " && p <= " + c_number(place_of_ratio(ratios.back()) + rounding_of_ratios);
}

std::string c_limits(const std::vector<double>& speeds, const std::vector<double>& ratios, double scale) {
  const auto [slowest, fastest] = speed_range(speeds.front(), speeds.back(), scale);
  std::string text =
      "#define @NAME@_SLOWEST " + c_number(slowest) + "\n#define @NAME@_FASTEST " + c_number(fastest) + "\n";
  if (ratios.size() < 2) return text;
  return text + "#define @NAME@_SMALLEST " + c_number(ratios.front()) + "\n#define @NAME@_GREATEST " +
         c_number(ratios.back()) + "\n";
}

std::vector<std::string> c_description(std::vector<std::string> lines, const std::string& name,
                                       const TableLabel& label) {
  for (std::string& line : lines) line = filled(line, name);
  lines.insert(lines.end(), label.provenance.begin(), label.provenance.end());
  while (lines.back().empty()) lines.pop_back();
  return lines;
}

}  // namespace stoss::table
