// The collision rule as a function, and collisions by it.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <tuple>

#include "stoss/encounter/laws.hpp"
#include "stoss/encounter/moving.hpp"
#include "stoss/errors.hpp"
#include "stoss/table/adaptive_rule.hpp"
#include "stoss/table/c_source.hpp"
#include "stoss/table/collide.hpp"
#include "support.hpp"

namespace stoss::python {
namespace {

/// Speeds, slips, ratios, values with their errors, and errors of the interpolation.
using GridOfDoubles = std::array<Doubles, 6>;

TableValues to_grid(const GridOfDoubles& given, bool alike) {
  const auto& [speed, slip, ratio, value, error, interpolation] = given;
  return {to_vector(speed),           to_vector(slip),          to_vector(ratio),
          to_estimates(value, error), to_vector(interpolation), alike};
}

GridOfDoubles to_doubles(TableValues grid) {
  const auto shape = [](auto&&... axes) { return std::vector<py::ssize_t>{static_cast<py::ssize_t>(axes)...}; };
  const auto intervals = [](const std::vector<double>& places) { return places.size() > 1 ? places.size() - 1 : 1; };
  const auto own = shape(grid.speeds.size(), grid.slips.size(), grid.ratios.size());
  const auto cells = shape(intervals(grid.speeds), intervals(grid.slips), intervals(grid.ratios));
  const auto [value, error] = to_arrays(grid.values, own);
  return {take(std::move(grid.speeds)),
          take(std::move(grid.slips)),
          take(std::move(grid.ratios)),
          value,
          error,
          take(std::move(grid.interpolation_error), cells)};
}

RuleTable made_rule(const GridOfDoubles& restitution, const GridOfDoubles& sliding, bool alike,
                    std::optional<double> friction, const std::string& beyond) {
  return RuleTable({to_grid(restitution, alike), to_grid(sliding, alike), friction}, to_beyond(beyond));
}

/// ε_n, its error, s′ and its error, one after the other.
py::array_t<double> evaluated(const RuleTable& rule, const Doubles& speed, const Doubles& sliding,
                              const Doubles& friction, const Doubles& ratio) {
  const py::ssize_t size = speed.size();
  std::vector<double> found(static_cast<std::size_t>(4 * size));
  for (py::ssize_t i = 0; i < size; ++i) {
    const Rule at = rule(speed.data()[i], sliding.data()[i], friction.data()[i], ratio.data()[i]);
    double* own = &found[static_cast<std::size_t>(i)];
    own[0] = at.restitution.value;
    own[size] = at.restitution.error;
    own[2 * size] = at.sliding_after;
    own[3 * size] = at.sliding_error;
  }
  return take(std::move(found), {4, size});
}

template <std::size_t dimension>
MovingBody<dimension> moving(const MovingBody<3>& body, const double* velocity, const double* spin) {
  MovingBody<dimension> made{body.inverse_mass, body.inverse_inertia, body.radius, {}, {}};
  std::copy_n(velocity, made.velocity.size(), made.velocity.begin());
  std::copy_n(spin, made.spin.size(), made.spin.begin());
  return made;
}

/// Changes velocities and spins, each a row of their arrays, in units of the first body.
template <std::size_t dimension>
void collide_all(const RuleTable& rule, const MovingPair& pair, std::array<Doubles, 2> velocity,
                 std::array<Doubles, 2> spin, const Doubles& normal, const Doubles& friction,
                 const std::optional<std::array<Doubles, 2>>& radius) {
  constexpr std::size_t turning = dimension == 3 ? 3 : 1;
  for (py::ssize_t i = 0; i < friction.size(); ++i) {
    const MovingPair own = radius ? pair.resized((*radius)[0].data()[i], (*radius)[1].data()[i]) : pair;
    const auto row = static_cast<std::size_t>(i);
    double *v = velocity[0].mutable_data() + dimension * row, *w = velocity[1].mutable_data() + dimension * row,
           *s = spin[0].mutable_data() + turning * row, *t = spin[1].mutable_data() + turning * row;
    auto first = moving<dimension>(own.first, v, s), second = moving<dimension>(own.second, w, t);
    std::array<double, dimension> n{};
    std::copy_n(normal.data() + dimension * row, dimension, n.begin());
    try {
      if (!collide(rule, first, second, n, friction.data()[i])) continue;
    } catch (const InvalidInput& error) {
      if (friction.size() == 1) throw;
      throw error.within("collision " + std::to_string(i));
    }
    std::copy(first.velocity.begin(), first.velocity.end(), v);
    std::copy(second.velocity.begin(), second.velocity.end(), w);
    std::copy(first.spin.begin(), first.spin.end(), s);
    std::copy(second.spin.begin(), second.spin.end(), t);
  }
}

}  // namespace

void bind_rules(py::module_& module) {
  py::class_<RuleTable> rule(module, "RuleTable", "The collision rule against speed in c, sliding and friction.");
  seal(rule);
  const auto nodes = [](const RuleTable& self) {
    std::vector<double> normal = self.restitution_nodes(), along = self.sliding_nodes();
    return std::pair(take(std::move(normal)), take(std::move(along)));
  };
  def(rule, "evaluate", {"speed", "sliding", "friction", "ratio"}, &evaluated);
  def(rule, "given", [](const RuleTable& self) {
    return std::tuple(to_doubles(self.values().restitution), to_doubles(self.values().sliding),
                      self.values().sliding.alike);
  });
  def(rule, "nodes", nodes);
  def(rule, "errors", [](const RuleTable& self) {
    return std::pair(self.greatest_restitution_error(), self.greatest_sliding_error());
  });
  bind_code(rule);
  def(rule, "collide", {"encounter", "dimension", "velocity", "spin", "normal", "friction", "radius"},
      [](const RuleTable& self, const Encounter& encounter, int dimension, std::array<Doubles, 2> velocity,
         std::array<Doubles, 2> spin, const Doubles& normal, const Doubles& friction,
         const std::optional<std::array<Doubles, 2>>& radius) {
        const MovingPair pair = moving_pair(encounter);
        const auto all = dimension == 3 ? &collide_all<3> : &collide_all<2>;
        all(self, pair, std::move(velocity), std::move(spin), normal, friction, radius);
      });
  def(module, "make_rule", {"restitution", "sliding", "alike", "friction", "beyond"}, &made_rule);
  def(module, "adaptive_rule", {"encounter", "speed", "ratio", "error", "tolerance", "friction", "threads"},
      [](const Encounter& encounter, const std::array<double, 2>& speed,
         const std::optional<std::array<double, 2>>& ratio, double error, double tolerance,
         std::optional<double> friction, int threads) {
        return computed([&](const Poll& poll) {
          const RuleTableOptions options{
              .error = error, .tolerance = tolerance, .friction = friction, .threads = threads, .poll = poll};
          if (!ratio) return rule_table(refinable(encounter), speed[0], speed[1], options);
          return rule_table(mixture(encounter), speed[0], speed[1], (*ratio)[0], (*ratio)[1], options);
        });
      });
}

}  // namespace stoss::python
