// The interval of a speed is found as in RestitutionFunction: in bins of equal ln v.
#include "stoss/table/c_source.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "check.hpp"
#include "stoss/errors.hpp"
#include "table/arguments.hpp"
#include "table/c_text.hpp"

namespace stoss {
namespace {

constexpr std::string_view functions = R"(
/* The interval between knots that ln(speed) lies in. */
@NAME@_FUNCTION int @name@_interval(double x)
{
  int k = @NAME@_INDEX((x - @first@) * @bins@);
  if (k < 0) k = 0;
  if (k > @last@) k = @last@;
  k = @name@_first[k];
  while (k > 0 && x < @name@_knots[k][0]) --k;
  while (k < @last@ && x >= @name@_knots[k + 1][0]) ++k;
  return k;
}

@NAME@_FUNCTION double @name@_restitution(double speed)
{
  const double v = fabs(speed);
  const double *a, *b;
  double x, h, t, u;
  int k;
  if (!(v >= @NAME@_SLOWEST)) return v < @NAME@_SLOWEST ? @below@ : v;
  if (v > @NAME@_FASTEST) return @above@;
  x = log(v);
  k = @name@_interval(x);
  a = @name@_knots[k];
  b = @name@_knots[k + 1];
  h = b[0] - a[0];
  t = (x - a[0]) / h;
  u = 1.0 - t;
  return a[1] * (1.0 + 2.0 * t) * u * u + b[1] * t * t * (1.0 + 2.0 * u) + h * t * u * (a[2] * u - b[2] * t);
}

@NAME@_FUNCTION double @name@_restitution_error(double speed)
{
  const double v = fabs(speed);
  if (v >= @NAME@_SLOWEST && v <= @NAME@_FASTEST) return @name@_errors[@name@_interval(log(v))];
  return v >= 0.0 ? HUGE_VAL : v;
}
)";

/// The interval in which each of as many bins of equal ln v begins.
std::vector<std::string> first_in_bins(const std::vector<double>& x, double bins_per_unit) {
  const std::size_t intervals = x.size() - 1;
  std::vector<std::string> first;
  std::size_t k = 0;
  for (std::size_t bin = 0; bin < intervals; ++bin) {
    const double begin = x.front() + static_cast<double>(bin) / bins_per_unit;
    while (k + 1 < intervals && x[k + 1] <= begin) ++k;
    first.push_back(std::to_string(k));
  }
  return first;
}

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
          std::to_string(function.knots().size()) + " speeds.",
      ""};
  if (label.by_models) {
    const std::vector<std::string> more{
        "That error is of computation and interpolation alone. Beside it stand the spread of the",
        "models, which differ from the coefficient by up to " + table::at_most(*label.by_models) +
            ", and the uncertainty of the constants:",
        "stoss predict says both for each speed.", ""};
    lines.insert(lines.begin() + 5, more.begin(), more.end());
  }
  for (std::string& line : lines) line = table::filled(line, label.name);
  lines.insert(lines.end(), label.provenance.begin(), label.provenance.end());
  while (lines.back().empty()) lines.pop_back();
  return lines;
}

}  // namespace

void validate(const TableLabel& label) {
  table::require_c_name(label.name);
  (void)table::speed_range(1.0, 1.0, label.scale);
}

std::string c_header(const RestitutionFunction& function, const TableLabel& label) {
  table::require_c_name(label.name);
  if (function.beyond() == Beyond::law) {
    throw InvalidInput::out_of_range("beyond", "law", "error or clamp", "a table in C has no law of slow impacts");
  }
  const auto [slowest, fastest] = table::speed_range(function, label.scale);
  const std::vector<Knot>& knots = function.knots();
  std::vector<double> x;
  std::vector<std::vector<std::string>> rows;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    x.push_back(std::log(knots[k].speed * label.scale));
    rows.push_back(
        {table::c_number(x[k]), table::c_number(knots[k].restitution.value), table::c_number(function.slopes()[k])});
  }
  std::vector<std::string> errors;
  for (const double error : function.errors()) errors.push_back(table::c_number(error));
  const double bins_per_unit = static_cast<double>(errors.size()) / (x.back() - x.front());
  const bool clamps = function.beyond() == Beyond::clamp;
  const std::string not_a_number = "HUGE_VAL - HUGE_VAL";

  const std::string& name = label.name;
  const std::string limits =
      table::filled("#define @NAME@_SLOWEST @slowest@\n#define @NAME@_FASTEST @fastest@\n\n", name,
                    {{"slowest", table::c_number(slowest)}, {"fastest", table::c_number(fastest)}});
  const std::string arrays =
      table::c_array("double", name + "_knots", "ln(speed), restitution, its slope against ln(speed)", rows) +
      table::c_array("double", name + "_errors", "of the restitution, between a knot and the next", errors) +
      table::c_array("int", name + "_first", "interval in which each of as many equal parts of ln(speed) begins",
                     first_in_bins(x, bins_per_unit));
  const std::string code = table::filled(std::string(functions), name,
                                         {{"first", table::c_number(x.front())},
                                          {"bins", table::c_number(bins_per_unit)},
                                          {"last", std::to_string(errors.size() - 1)},
                                          {"below", clamps ? rows.front()[1] : not_a_number},
                                          {"above", clamps ? rows.back()[1] : not_a_number}});
  return table::c_file(name, comment(function, label), limits + arrays + code);
}

}  // namespace stoss
