#include "table/adaptive_grid.hpp"

#include <algorithm>

namespace stoss {
namespace {

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

std::size_t AdaptiveGrid::size() const { return axes_[0].size() * axes_[1].size() * axes_[2].size(); }

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

bool AdaptiveGrid::halve(const std::vector<double>& enough) {
  for (std::size_t number = 0; number < axes_.size(); ++number) {
    std::vector<double> worst(axes_[number].size() - 1);
    Index lines{axes_[0].size(), axes_[1].size(), axes_[2].size()};
    lines[number] = 1;
    for (std::size_t quantity = 0; quantity < enough.size(); ++quantity) {
      for_each(lines, [&](const Index& through) {
        const std::vector<double> own = axes_[number].missed(line(number, through, quantity));
        for (std::size_t k = 0; k < own.size(); ++k) worst[k] = std::max(worst[k], own[k] / enough[quantity]);
      });
    }
    if (axes_[number].halve(worst, 1.0)) return true;
  }
  return false;
}

std::vector<Estimate> AdaptiveGrid::values(std::size_t quantity) const {
  std::vector<Estimate> all;
  for_each({axes_[0].size(), axes_[1].size(), axes_[2].size()},
           [&](const Index& index) { all.push_back(values_.at(place(index))[quantity]); });
  return all;
}

std::vector<double> AdaptiveGrid::interpolation_errors(std::size_t quantity) const {
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
        missed[{i, j}] = NestedAxis::worst_of_three(axes_[number].missed(line(number, through, quantity)));
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
