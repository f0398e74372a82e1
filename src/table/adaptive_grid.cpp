#include "table/adaptive_grid.hpp"

#include <algorithm>
#include <string>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

// One line may be met by chance where many are not.
constexpr Doubt of_one_line{2.0, 5, true}, of_many_lines{1.0, 3, false};

/// Calls for every index below three counts, the last running fastest.
template <typename Call>
void for_each(const std::array<std::size_t, 3>& count, Call call) {
  for (std::size_t i = 0; i < count[0]; ++i) {
    for (std::size_t j = 0; j < count[1]; ++j) {
      for (std::size_t k = 0; k < count[2]; ++k) call(std::array{i, j, k});
    }
  }
}

}  // namespace

std::string TableRange::named(double x, double p) const {
  return "speed " + rounded(speeds.speed(x)) + " c" + (is_mixture ? " and the ratio " + rounded(ratio(p)) : "");
}

const RefinableContact& Contacts::at(double p) {
  if (!made_.contains(p)) made_.emplace(p, made_of_(range_.ratio(p)));
  return made_.at(p);
}

AdaptiveGrid::AdaptiveGrid(const TableRange& range, NestedAxis slips)
    : range_(range),
      axes_{axis_of_speeds(range.speeds), std::move(slips),
            range.is_mixture ? axis_of_ratios(range.ratios, range.alike) : one_place()} {}

std::size_t AdaptiveGrid::dimensions() const {
  return static_cast<std::size_t>(
      std::count_if(axes_.begin(), axes_.end(), [](const NestedAxis& axis) { return axis.size() > 1; }));
}

std::size_t AdaptiveGrid::size() const { return axes_[0].size() * axes_[1].size() * axes_[2].size(); }

const Doubt& AdaptiveGrid::doubt() const { return dimensions() == 1 ? of_one_line : of_many_lines; }

void AdaptiveGrid::refine(const char* name, const std::vector<double>& enough, int most,
                          const std::function<void(const std::vector<Place>&)>& compute) {
  do {
    if (size() > static_cast<std::size_t>(most)) {
      throw NotConverged(std::string(name) + ": more than " + std::to_string(most) +
                         " values are needed (allow a greater error, smaller ranges, or more values)");
    }
    compute(open());
  } while (halve(enough, Told::by_its_middle) || halve(enough, Told::by_all_around));
}

TableValues AdaptiveGrid::table(std::size_t quantity) const {
  TableValues made{{}, axes_[1].x(), {}, {}, errors(quantity), range_.alike};
  for (const double x : axes_[0].x()) made.speeds.push_back(range_.speeds.speed(x));
  for (const double p : axes_[2].x()) made.ratios.push_back(range_.ratio(p));
  for_each({axes_[0].size(), axes_[1].size(), axes_[2].size()},
           [&](const Index& index) { made.values.push_back(values_.at(place(index))[quantity]); });
  return made;
}

AdaptiveGrid::Place AdaptiveGrid::place(const Index& index) const {
  return {axes_[0].x()[index[0]], axes_[1].x()[index[1]], axes_[2].x()[index[2]]};
}

std::size_t AdaptiveGrid::intervals(std::size_t number) const {
  return std::max<std::size_t>(axes_[number].size(), 2) - 1;
}

std::vector<AdaptiveGrid::Place> AdaptiveGrid::open() const {
  std::vector<Place> places;
  for_each({axes_[2].size(), axes_[0].size(), axes_[1].size()}, [&](const Index& index) {
    const Place at = place({index[1], index[2], index[0]});
    if (!values_.contains(at)) places.push_back(at);
  });
  return places;
}

std::vector<double> AdaptiveGrid::line(std::size_t number, Index through, std::size_t quantity) const {
  std::vector<double> y;
  for (through[number] = 0; through[number] < axes_[number].size(); ++through[number]) {
    y.push_back(values_.at(place(through))[quantity].value);
  }
  return y;
}

bool AdaptiveGrid::halve(const std::vector<double>& enough, Told told) {
  for (std::size_t number = 0; number < axes_.size(); ++number) {
    const NestedAxis& axis = axes_[number];
    std::vector<double> worst(axis.size() - 1);
    Index lines{axes_[0].size(), axes_[1].size(), axes_[2].size()};
    lines[number] = 1;
    for (std::size_t quantity = 0; quantity < enough.size() && axis.size() > 1; ++quantity) {
      for_each(lines, [&](const Index& through) {
        const std::vector<double> y = line(number, through, quantity);
        const bool alone = told == Told::by_its_middle;
        const std::vector<double> own = alone ? axis.missed(y) : axis.errors(y, doubt());
        const double times = (alone ? doubt().safety : 1.0) / enough[quantity];
        for (std::size_t k = 0; k < own.size(); ++k) worst[k] = std::max(worst[k], times * own[k]);
      });
    }
    if (axes_[number].halve(worst)) return true;
  }
  return false;
}

std::vector<double> AdaptiveGrid::errors(std::size_t quantity) const {
  const Index cells{intervals(0), intervals(1), intervals(2)};
  std::vector<double> errors(cells[0] * cells[1] * cells[2]);
  for (std::size_t number = 0; number < axes_.size(); ++number) {
    if (axes_[number].size() < 2) continue;
    const std::size_t a = (number + 1) % 3, b = (number + 2) % 3;
    std::map<std::array<std::size_t, 2>, std::vector<double>> missed;  // of each line
    for (std::size_t i = 0; i < axes_[a].size(); ++i) {
      for (std::size_t j = 0; j < axes_[b].size(); ++j) {
        Index through{};
        through[a] = i, through[b] = j;
        missed[{i, j}] = axes_[number].errors(line(number, through, quantity), doubt());
      }
    }
    std::size_t cell = 0;
    for_each(cells, [&](const Index& index) {
      double greatest = 0.0;  // of the lines around
      for (std::size_t i = index[a]; i < std::min(index[a] + 2, axes_[a].size()); ++i) {
        for (std::size_t j = index[b]; j < std::min(index[b] + 2, axes_[b].size()); ++j) {
          greatest = std::max(greatest, missed[{i, j}][index[number]]);
        }
      }
      errors[cell++] += greatest;
    });
  }
  return errors;
}

}  // namespace stoss
