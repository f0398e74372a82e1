#include "stoss/encounter/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "check.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// A row of a range that the core has too.
Input entry(std::string_view name, Dimension dimension, const Range& range, std::string_view help,
            std::vector<Use> uses, std::string_view unit = {}) {
  return {name,       dimension, unit,           range.low, range.high, range.low_included, range.high_included,
          range.text, help,      std::move(uses)};
}

std::vector<Input> rows() {
  using enum Question;
  using enum Form;
  constexpr Range of_any_size{-no_limit, no_limit, true, true, "any number"};
  constexpr Range angles{-90.0, 90.0, false, false, "above -90 to below 90"};
  constexpr Range above_zero{0.0, no_limit, false, false, "above 0"};
  constexpr auto none = Dimension::none;
  constexpr Range bodies{1.0, 100.0, true, true, "1 to 100"};
  constexpr Range gaps{0.0, 1e3, true, true, "0 to 1000"};
  const std::vector<Use> approach{{impact},          {bounce}, {restitution, series}, {oblique, series}, {distribution},
                                  {predict, series}, {pulse},  {table, range},        {fit, range}};
  return {
      entry("speed", Dimension::speed, ranges::speed, "Speed of approach, along the normal", approach),
      entry("height", none, above_zero, "Height of a fall without air, in place of --speed, of a body with a material",
            approach, "m"),
      entry("speed", Dimension::speed, ranges::along,
            "Velocities of the bodies to the right, from the first on; those that are left out rest", {{row, series}}),
      entry("height", none, above_zero,
            "Heights from which the bodies have fallen towards the right, in place of --speed, with a material",
            {{row, series}}, "m"),
      entry("tangential", Dimension::speed, ranges::along,
            "Velocity of the centre of the body along the surface, relative to what it meets",
            {{oblique, series, 0.0}}),
      entry("angle", none, angles, "Angle between the velocity of the centre and the normal, in place of --tangential",
            {{oblique, series}}, "degrees"),
      entry("spin", Dimension::frequency, ranges::along,
            "Spin of the body; positive moves its foremost point as --tangential does", {{oblique, series, 0.0}}),
      entry("second_spin", Dimension::frequency, of_any_size,
            "Spin of the second body, up to 1 c at its surface, with the same sign of sliding",
            {{oblique, series, 0.0}}),
      entry("friction", none, ranges::friction, "Coefficient of Coulomb's law",
            {{oblique, number, {}, true}, {fit, number, 0.0}, {calibrate}}),
      entry("friction", none, ranges::friction,
            "With --oblique, of disks that are not equal: the coefficient of Coulomb's law for which the table holds; "
            "other tables serve any friction",
            {{table}}),
      entry("ratio", none, ranges::ratio,
            "Range of the ratio of radii, second body over first: a table of pairs of disks or of spheres, --against "
            "same or a body, whose radius does not count",
            {{table, range}}),
      entry("tolerance", none, ranges::tolerance, "Relative error of 1-eps^2 to reach", {{restitution, number, 1e-3}}),
      entry("tolerance", none, ranges::tolerance, "Relative error of 1-eps^2 without models to reach",
            {{predict, number, 1e-3}}),
      entry("tolerance", none, ranges::sliding_tolerance,
            "Error to reach of the velocity at which surfaces slide afterwards, over that before or, if larger, the "
            "friction times the speed",
            {{oblique, number, 1e-2}}),
      entry("tolerance", none, ranges::rule_tolerance,
            "With --oblique: maximum error of the sliding after the collision over |v_t| + |spin R| of both bodies + "
            "MU v",
            {{table, number, 2e-2}}),
      entry("tolerance", none, ranges::force_tolerance,
            "Error of the force at any time over its maximum to reach, between flat ends of the maximum alone",
            {{pulse, number, 1e-2}}),
      entry("threshold", none, ranges::threshold, "Share of the maximum force above which the duration is taken",
            {{pulse, number, 1e-2}}),
      entry("points", none, ranges::points, "Number of instants, and of frequencies", {{pulse, whole, 400.0}}),
      entry("distance", Dimension::length, ranges::place,
            "Distance of a receiver on a half-space or a plate from the contact, along the surface", {{pulse}}),
      entry("depth", Dimension::length, ranges::place,
            "Depth of a receiver below the surface, of a plate up to its thickness", {{pulse}}),
      entry("until", Dimension::time, ranges::flight_time,
            "Time at which the receiver stops (default: when waves have passed)", {{pulse}}),
      entry("tolerance", none, ranges::row_tolerance,
            "Error of each velocity afterwards to reach, over the greatest difference of velocities before",
            {{row, number, 1e-3}}),
      entry("absolute", none, ranges::absolute,
            "Absolute error of 1-eps^2 at which to stop, whatever --tolerance says; 0: only the tolerance counts",
            {{restitution, number, 1e-6}}),
      entry("error", none, ranges::sample_error, "Error of 1-eps^2 of each to reach", {{distribution, number, 1e-3}}),
      entry("error", none, ranges::table_error, "Maximum error of eps at any speed, interpolation included",
            {{table, number, 1e-3}}),
      entry("temperature", none, ranges::energy,
            "Mean energy of each mode up to --highest, as a share of the translational one (this or --spectrum)",
            {{distribution}}),
      entry(
          "highest", none, above_zero,
          "With --temperature: modes up to this frequency in c/R of the first body vibrate (default: 10, where bodies "
          "allow it)",
          {{distribution}}),
      entry("samples", none, ranges::samples, "Number of impacts", {{distribution, whole, 1000.0}}),
      entry("seed", none, ranges::seed, "Seed of the ensemble: another seed, another ensemble",
            {{distribution, whole, 0.0}}),
      entry("count", none, ranges::count, "Number of impacts", {{bounce, whole, 100.0}}),
      entry("count", none, bodies, "Number of bodies", {{row, whole, 3.0}}),
      entry("gap", Dimension::length, gaps,
            "Gaps between neighbours, what stands at an end included: one for all, or one for each from left to right",
            {{row, series, 0.0}}),
      entry("until", Dimension::time, ranges::flight_time,
            "Time after the first contact at which to stop (default: when no bodies can meet any more)", {{row}}),
      entry("flight_time", Dimension::time, ranges::flight_time,
            "Time between leaving the wall and touching it (this or --gravity)", {{bounce}}),
      entry("gravity", Dimension::acceleration, ranges::gravity, "Acceleration g: a flight lasts 2v/g", {{bounce}}),
      entry("decay_time", Dimension::time, ranges::decay_time,
            "Time TAU in which vibrational energies fall in flight as exp(-t/TAU): 0 for at once, no decay without it",
            {{bounce}}),
      entry(
          "cutoff", none, above_zero,
          "Highest frequency of the kept modes, in c/R (default: 50, or up to which those of a file are known; less on "
          "a half-space or a plate)",
          {{impact}}),
      entry("cutoff", none, above_zero,
            "Highest frequency of the kept modes, in c/R (default: 20, or less as of stoss impact)", {{bounce}}),
      entry("step", none, above_zero, "Time step, in R/c (default: recommended)", {{impact}}),
      entry("nodes", none, ranges::nodes, "Number of contact nodes (default: recommended)", {{impact, whole}}),
      entry("adhesion", none, ranges::adhesion,
            "Work of adhesion of both surfaces (default: that of the materials, 2 sqrt(gamma_1 gamma_2))",
            {{predict}, {table}}, "J/m^2"),
  };
}

/// The units of the body of which others are in SI.
UnitSystem own(UnitSystem system) {
  if (system == UnitSystem::disk_si) return UnitSystem::disk;
  if (system == UnitSystem::rod_si) return UnitSystem::rod;
  return system == UnitSystem::sphere_si ? UnitSystem::sphere : system;
}

}  // namespace

const Use* Input::use(Question question) const {
  const auto found = std::find_if(uses.begin(), uses.end(), [&](const Use& each) { return each.question == question; });
  return found == uses.end() ? nullptr : &*found;
}

const std::vector<Input>& inputs() {
  static const std::vector<Input> all = rows();
  return all;
}

const Input& input(Question question, std::string_view name) {
  for (const Input& each : inputs()) {
    if (each.name == name && each.use(question) != nullptr) return each;
  }
  throw InvalidInput::out_of_range("input", std::string(name), "one of the table of inputs");
}

const std::vector<std::pair<Question, std::string_view>>& questions() {
  using enum Question;
  static const std::vector<std::pair<Question, std::string_view>> all{{impact, "impact"},
                                                                      {bounce, "bounce"},
                                                                      {restitution, "restitution"},
                                                                      {oblique, "oblique"},
                                                                      {distribution, "distribution"},
                                                                      {predict, "predict"},
                                                                      {table, "table"},
                                                                      {fit, "fit"},
                                                                      {calibrate, "calibrate"},
                                                                      {row, "row"},
                                                                      {pulse, "pulse"}};
  return all;
}

void require(const Input& input, double value, const std::optional<Scales>& scales, UnitSystem system) {
  const double unit = scales ? unit_in_si(input.dimension, *scales) : 1.0;
  const double low = input.low * unit, high = input.high * unit;
  const bool above = input.low_included ? value >= low : value > low;
  const bool below = input.high_included ? value <= high : value < high;
  if (above && below && std::isfinite(value)) return;
  std::string allowed(input.range);
  if (unit != 1.0 && std::isfinite(low)) {
    allowed = (input.low_included ? "" : "above ") + shown_least(low);
    if (std::isfinite(high)) allowed += " to " + shown_most(high);
  }
  const std::string_view its = input.dimension == Dimension::none ? input.unit : unit_name(input.dimension, system);
  if (!its.empty()) allowed += " " + std::string(its);
  std::string hint(input.help);
  hint[0] = static_cast<char>(hint[0] - 'A' + 'a');
  if (unit != 1.0) hint += ", " + std::string(input.range) + " " + std::string(unit_name(input.dimension, own(system)));
  throw InvalidInput::out_of_range(std::string(input.name), shown(value), allowed, hint);
}

double in_own_units(const Input& input, double value, const std::optional<Scales>& scales, UnitSystem system) {
  require(input, value, scales, system);
  const double unit = scales ? unit_in_si(input.dimension, *scales) : 1.0;
  return std::clamp(value / unit, input.low, input.high);  // the division may round beyond an end
}

std::vector<double> series_in_own_units(const Input& input, std::string_view text, const std::optional<Scales>& scales,
                                        UnitSystem system) {
  std::vector<double> values = parse_series(input.name, text);
  const bool typed = text.find(':') == std::string_view::npos;
  for (double& value : values) {
    try {
      value = in_own_units(input, value, scales, system);
    } catch (const InvalidInput& refusal) {
      if (typed) throw;
      throw InvalidInput::out_of_range(refusal.name(), rounded(value) + " of " + in_quotes(text), refusal.allowed(),
                                       refusal.hint());
    }
  }
  return values;
}

}  // namespace stoss
