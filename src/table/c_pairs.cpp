// A cell is found as by numeric::Bins. In it ε is the cubic of values and slopes at the ends, in ln v and in
// s = (ratio − 1)/(ratio + 1).
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "check.hpp"
#include "numeric/interpolation.hpp"
#include "stoss/table/c_source.hpp"
#include "table/arguments.hpp"
#include "table/axes.hpp"
#include "table/c_text.hpp"

namespace stoss {
namespace {

constexpr std::string_view pair_functions = R"(
/* Ratios by their difference over their sum, which changes its sign with the inverse. */
@NAME@_FUNCTION double @name@_place(double ratio)
{
  const double s = (ratio - 1.0) / (ratio + 1.0);
  return @place@;
}

@NAME@_FUNCTION int @name@_holds(double v, double ratio)
{
  const double s = @name@_place(ratio);
  return v >= @NAME@_SLOWEST && v <= @NAME@_FASTEST && ratio > 0.0 && s >= @first_s@ && s <= @last_s@;
}

@NAME@_FUNCTION double @name@_within(double v, double s)
{
  const double x = log(v);
  const int k = @name@_interval(@name@_speeds, @name@_first_speeds, @intervals_x@, @bins_x@, x);
  const int j = @name@_interval(@name@_ratios, @name@_first_ratios, @intervals_s@, @bins_s@, s);
  const double (*a)[4] = @name@_nodes + k * (@intervals_s@ + 1) + j;
  const double (*b)[4] = a + @intervals_s@ + 1;
  const double h = @name@_speeds[k + 1] - @name@_speeds[k];
  const double g = @name@_ratios[j + 1] - @name@_ratios[j];
  const double t = (x - @name@_speeds[k]) / h, u = 1.0 - t;
  const double p = (s - @name@_ratios[j]) / g, q = 1.0 - p;
  const double a0 = (1.0 + 2.0 * t) * u * u, b0 = t * t * (1.0 + 2.0 * u), a1 = h * t * u * u, b1 = -h * t * t * u;
  const double left = a0 * a[0][0] + b0 * b[0][0] + a1 * a[0][1] + b1 * b[0][1];
  const double right = a0 * a[1][0] + b0 * b[1][0] + a1 * a[1][1] + b1 * b[1][1];
  const double from = a0 * a[0][2] + b0 * b[0][2] + a1 * a[0][3] + b1 * b[0][3];
  const double to = a0 * a[1][2] + b0 * b[1][2] + a1 * a[1][3] + b1 * b[1][3];
  return left * (1.0 + 2.0 * p) * q * q + right * p * p * (1.0 + 2.0 * q) + g * p * q * (from * q - to * p);
}

@NAME@_FUNCTION double @name@_restitution(double speed, double ratio)
{
  double v = fabs(speed), s = @name@_place(ratio);
  if (@name@_holds(v, ratio)) return @name@_within(v, s);
  if (!(v >= 0.0)) return v;
  if (!(ratio >= 0.0 || ratio < 0.0)) return ratio;
@outside@}

@NAME@_FUNCTION double @name@_restitution_error(double speed, double ratio)
{
  const double v = fabs(speed), s = @name@_place(ratio);
  if (!(v >= 0.0)) return v;
  if (!(ratio >= 0.0 || ratio < 0.0)) return ratio;
  if (!@name@_holds(v, ratio)) return HUGE_VAL;
  return @name@_errors[@name@_interval(@name@_speeds, @name@_first_speeds, @intervals_x@, @bins_x@, log(v))]
                      [@name@_interval(@name@_ratios, @name@_first_ratios, @intervals_s@, @bins_s@, s)];
}
)";

constexpr std::string_view clamped = R"(  if (!(ratio > 0.0)) return HUGE_VAL - HUGE_VAL;
  if (v < @NAME@_SLOWEST) v = @NAME@_SLOWEST;
  if (v > @NAME@_FASTEST) v = @NAME@_FASTEST;
  if (s < @begin_s@) s = @begin_s@;
  if (!(s <= @end_s@)) s = @end_s@;
  return @name@_within(v, s);
)";

constexpr std::string_view refused = "  return HUGE_VAL - HUGE_VAL;\n";

std::vector<std::string> comment(const PairTable& pairs, const TableLabel& label, const std::string& name) {
  const bool clamps = pairs.beyond() == Beyond::clamp;
  const std::string inverse = pairs.values().alike ? "; its inverse is the same pair" : "";
  std::vector<std::string> lines{
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
  for (std::string& line : lines) line = table::filled(line, name);
  lines.insert(lines.end(), label.provenance.begin(), label.provenance.end());
  while (lines.back().empty()) lines.pop_back();
  return lines;
}

std::string arrays(const PairTable& pairs, const std::string& name, const numeric::Bins& x, const numeric::Bins& s) {
  std::vector<std::vector<std::string>> nodes, errors;
  for (const auto& [value, by_speed, by_ratio, by_both] : pairs.nodes()) {
    nodes.push_back(table::c_numbers(std::vector{value, by_speed, by_ratio, by_both}));
  }
  const std::size_t columns = s.x().size() - 1;
  for (std::size_t k = 0; k + 1 < x.x().size(); ++k) {
    const auto row = pairs.errors().begin() + static_cast<std::ptrdiff_t>(k * columns);
    errors.push_back(table::c_numbers(std::vector<double>(row, row + static_cast<std::ptrdiff_t>(columns))));
  }
  return table::c_array("double", name + "_speeds", "ln(speed)", table::c_numbers(x.x())) +
         table::c_array("double", name + "_ratios", "s = (ratio - 1)/(ratio + 1)", table::c_numbers(s.x())) +
         table::c_array("double", name + "_nodes",
                        "restitution at each speed for all ratios, its slopes against ln(speed), s, and both", nodes) +
         table::c_array("double", name + "_errors", "of the restitution between two speeds and two ratios", errors) +
         table::c_array("int", name + "_first_speeds", "interval in which each of equal parts of ln(speed) begins",
                        table::c_numbers(x.first())) +
         table::c_array("int", name + "_first_ratios", "interval in which each of equal parts of s begins",
                        table::c_numbers(s.first()));
}

}  // namespace

std::string c_header(const PairTable& pairs, const TableLabel& label) {
  table::require_c_name(label.name);
  const std::string name = label.name + "_pair";
  const auto [slowest, fastest] =
      table::speed_range(pairs.values().speeds.front(), pairs.values().speeds.back(), label.scale);
  std::vector<double> logarithms, differences;
  for (const double each : pairs.values().speeds) logarithms.push_back(std::log(each * label.scale));
  for (const double each : pairs.values().ratios) differences.push_back(place_of_ratio(each));
  const numeric::Bins x(logarithms), s(differences);
  const std::string outside(pairs.beyond() == Beyond::clamp ? clamped : refused);
  const std::vector<std::pair<std::string, std::string>> fillings{
      {"outside", outside},
      {"place", pairs.values().alike ? "fabs(s)" : "s"},
      {"first_s", table::c_number(differences.front() - rounding_of_ratios)},
      {"last_s", table::c_number(differences.back() + rounding_of_ratios)},
      {"begin_s", table::c_number(differences.front())},
      {"end_s", table::c_number(differences.back())},
      {"intervals_x", std::to_string(logarithms.size() - 1)},
      {"intervals_s", std::to_string(differences.size() - 1)},
      {"bins_x", table::c_number(x.per_unit())},
      {"bins_s", table::c_number(s.per_unit())},
      {"slowest", table::c_number(slowest)},
      {"fastest", table::c_number(fastest)},
      {"smallest", table::c_number(pairs.values().ratios.front())},
      {"greatest", table::c_number(pairs.values().ratios.back())}};
  const std::string limits =
      "#define @NAME@_SLOWEST @slowest@\n#define @NAME@_FASTEST @fastest@\n#define @NAME@_SMALLEST @smallest@\n"
      "#define @NAME@_GREATEST @greatest@\n\n";
  return table::c_file(
      name, comment(pairs, label, name),
      table::filled(limits, name, fillings) + arrays(pairs, name, x, s) +
          table::filled(std::string(table::c_interval_function) + std::string(pair_functions), name, fillings));
}

}  // namespace stoss
