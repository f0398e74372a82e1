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
@comment@The interval k of places x in which another one lies, and in it )"
                                     R"(the weights of the cubic a + w0(b - a) + w1 a' - w2 b'
@more@of values a, b and slopes a', b' at its ends.@done@
@whole_function:weigh@(@numbers:x@, @wholes:first@, @whole:last@, @number:bins@, @number:at@, @out:w@)@gives_whole@
  @later_numbers:h, t, u@;
  @later_whole:k@;
  k = @index@(at - x[0]) * bins@indexed@;
@from_zero@  @if@k > last@then@k = last;@end@
  k = first[k];
  @while@k + 1 < last && at >= x[k + 1]@then@@next@@end@
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
@number_function:sum_1@(@numbers:a@, @whole:next@, @numbers:w@)@gives_number@
  @row:b@ = @from:a@next@till@;
  return a[0] + w[0] * (b[0] - a[0]) + w[1] * a[1] - w[2] * b[1];
}
)",
                                               R"(
@number_function:sum_2@(@numbers:a@, @whole:next@, @whole:line@, @numbers:w@, @numbers:y@)@gives_number@
  @row:b@ = @from:a@line@till@;
  @constant:begin@ = @name@_sum_1(a, next, w)@also_constant:end@ = @name@_sum_1(b, next, w);
  return begin + y[0] * (end - begin) + y[1] * @name@_sum_1(@from:a@2@till@, next, w) - )"
                                               R"(y[2] * @name@_sum_1(@from:b@2@till@, next, w);
}
)",
                                               R"(
@number_function:sum_3@(@numbers:a@, @whole:next@, @whole:line@, @whole:plane@, @numbers:w@, @numbers:y@,
                                    @numbers:z@)@gives_number@
  @row:b@ = @from:a@plane@till@;
  @constant:begin@ = @name@_sum_2(a, next, line, w, y)@also_constant:end@ = @name@_sum_2(b, next, line, w, y);
  return begin + z[0] * (end - begin) + z[1] * @name@_sum_2(@from:a@4@till@, next, line, w, y) -
         z[2] * @name@_sum_2(@from:b@4@till@, next, line, w, y);
}
)"};

/// An axis of a grid that counts.
struct Axis {
  std::string name;      ///< of its array
  std::string of;        ///< what its places are
  std::string variable;  ///< in the functions
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

std::string arrays(const Axis& axis, const Language& language) {
  return c_array(language, language.number, axis.name, axis.of, c_numbers(axis.places)) +
         c_array(language, language.whole, axis.name + "_first", "interval in which each of equal parts of it begins",
                 c_numbers(numeric::Bins(axis.places).first()));
}

std::string arrays(const CGrid& grid, const Language& language) {
  return c_array(language, language.number, grid.name + "_nodes",
                 "value at each crossing, and its derivatives along the axes", c_numbers(grid.nodes)) +
         c_array(language, language.number, grid.name + "_errors", "of each cell", c_numbers(grid.errors));
}

/// The line that finds the interval k[i] of an axis, and the weights in it.
std::string interval(const Axis& axis, const std::string& i) {
  return "  k[" + i + "] = @name@_weigh(@in:" + axis.name + "@, @in:" + axis.name + "_first@, " +
         std::to_string(axis.last()) + ", " + c_number(numeric::Bins(axis.places).per_unit()) + ", " + axis.variable +
         ", @out_of:w[" + i + "]@);\n";
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
    weights_of.append(", @in:w[").append(i).append("]@");
    node.append(more).append(i).append("] * ").append(std::to_string(next[d]));
    cell.append(more).append(i).append("] * ").append(std::to_string(cells[d]));
  }
  return "  found[" + std::to_string(at) + "] = @name@_sum_" + std::to_string(axes.size()) + "(@from:" + part +
         "_nodes@(" + node + ")@till@" + steps + weights_of + ");\n  found[" + std::to_string(at + 1) + "] = " + part +
         "_errors[" + cell + "];\n";
}

}  // namespace

std::string c_look_up(const std::vector<CGrid>& grids, double scale, const Language& language) {
  const std::vector<Axis> all = distinct_axes(grids, scale);
  std::string text, functions(weights), intervals, values;
  for (std::size_t i = 0; i < all.size(); ++i) {
    text += arrays(all[i], language);
    intervals += interval(all[i], std::to_string(i));
  }
  std::size_t dimensions = 0;
  for (std::size_t i = 0; i < grids.size(); ++i) {
    const std::vector<Axis> axes = axes_of(grids[i], scale);
    dimensions = std::max(dimensions, axes.size());
    values += value(grids[i].name, axes, all, 2 * i);
    text += arrays(grids[i], language);
  }
  for (std::size_t d = 0; d < dimensions; ++d) functions += sums[d];
  const std::string count = std::to_string(all.size());
  functions +=
      "\n@function:look_up@(@number:x@, @number:z@, @number:p@, @out:found@)@gives_nothing@\n  @weights:" + count +
      "@;\n" + intervals + values + "  @unused:z@;\n  @unused:p@;\n}\n";
  return text + worded(functions, language);
}

std::string c_numbers_of(const std::vector<std::string>& arguments, const std::vector<std::string>& names,
                         const Language& language) {
  std::string declared, given, text;
  for (const std::string& each : arguments) {
    declared += (declared.empty() ? "@number:" : ", @number:") + each + "@";
    given += each + ", ";
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += "\n@public:" + names[i] + "@(" + declared + ")@gives_number@\n  @found:" + std::to_string(names.size()) +
            "@;\n  @name@_at(" + given + "@out_of:found@);\n  return found[" + std::to_string(i) + "];\n}\n";
  }
  return worded(text, language);
}

CRange::CRange(const std::vector<double>& ratios, bool alike, const Language& language)
    : place("0.0"),
      nearest(
          "    @if@v < @NAME@_SLOWEST@then@v = @NAME@_SLOWEST;@end@\n"
          "    @if@v > @NAME@_FASTEST@then@v = @NAME@_FASTEST;@end@\n") {
  if (ratios.size() > 1) add_ratios(ratios, alike);
  place = worded(place, language);
  nearest = worded(nearest, language);
}

void CRange::add_ratios(const std::vector<double>& ratios, bool alike) {
  place = "(ratio - 1.0) / (ratio + 1.0)";
  if (alike) place = "@absolute@" + place + ")";
  const std::string first = c_number(place_of_ratio(ratios.front())), last = c_number(place_of_ratio(ratios.back()));
  nearest += "    @if@!(p < " + last + ")@then@p = " + last + ";@end@\n    @if@p < " + first + "@then@p = " + first +
             ";@end@\n";
  inside = " && p >= " + c_number(place_of_ratio(ratios.front()) - rounding_of_ratios) +
           " && p <= " + c_number(place_of_ratio(ratios.back()) + rounding_of_ratios);
}

std::string c_limits(const std::vector<double>& speeds, const std::vector<double>& ratios, double scale,
                     const Language& language) {
  const auto [slowest, fastest] = speed_range(speeds.front(), speeds.back(), scale);
  std::string text;
  const auto add = [&](const std::string& limit, double value) {
    text += "@limit:" + limit + "@" + c_number(value) + "@limit_end@\n";
  };
  add("SLOWEST", slowest);
  add("FASTEST", fastest);
  if (ratios.size() > 1) {
    add("SMALLEST", ratios.front());
    add("GREATEST", ratios.back());
  }
  return worded(text, language);
}

std::vector<std::string> c_description(std::vector<std::string> lines, const std::string& name, const TableLabel& label,
                                       const Language& language) {
  for (std::string& line : lines) line = filled(worded(line, language), name);
  lines.insert(lines.end(), label.provenance.begin(), label.provenance.end());
  while (lines.back().empty()) lines.pop_back();
  return lines;
}

}  // namespace stoss::table
