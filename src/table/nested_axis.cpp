#include "table/nested_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numeric/parabolic_cubic.hpp"

namespace stoss {

void NestedAxis::add(double place, int turn) {
  const auto at = std::upper_bound(x_.begin(), x_.end(), place) - x_.begin();
  x_.insert(x_.begin() + at, place);
  turn_.insert(turn_.begin() + at, turn);
  last_ = std::max(last_, turn);
}

std::vector<double> NestedAxis::missed(const std::vector<double>& y) const {
  std::vector<double> distance(x_.size(), std::numeric_limits<double>::infinity());
  for (int turn = 1; turn <= last_; ++turn) {
    std::vector<double> x, before;
    for (std::size_t k = 0; k < x_.size(); ++k) {
      if (turn_[k] >= turn) continue;
      x.push_back(x_[k]);
      before.push_back(y[k]);
    }
    const std::vector<double> slope = numeric::slopes(slopes_, x, before);
    std::size_t left = 0;
    for (std::size_t k = 0; k < x_.size(); ++k) {
      if (turn_[k] != turn) continue;
      while (x[left + 1] < x_[k]) ++left;
      const double h = x[left + 1] - x[left];
      const std::array<double, 4> w = numeric::cubic_weights(h, (x_[k] - x[left]) / h);
      distance[k] =
          std::abs(w[0] * before[left] + w[1] * before[left + 1] + w[2] * slope[left] + w[3] * slope[left + 1] - y[k]);
    }
  }
  std::vector<double> own;
  for (std::size_t k = 0; k + 1 < x_.size(); ++k) {
    own.push_back(turn_[k] > turn_[k + 1] ? distance[k] : distance[k + 1]);  // that of the later end
  }
  return own;
}

bool NestedAxis::halve(const std::vector<double>& missed, double enough) {
  std::vector<double> middles;
  for (std::size_t k = 0; k < missed.size(); ++k) {
    if (missed[k] > enough) middles.push_back(0.5 * (x_[k] + x_[k + 1]));
  }
  const int turn = last_ + 1;
  for (const double middle : middles) add(middle, turn);
  return !middles.empty();
}

std::vector<double> NestedAxis::worst_of_three(const std::vector<double>& missed) {
  std::vector<double> worst;
  for (std::size_t k = 0; k < missed.size(); ++k) {
    const std::size_t left = k > 0 ? k - 1 : k, right = std::min(k + 1, missed.size() - 1);
    worst.push_back(std::max({missed[left], missed[k], missed[right]}));
  }
  return worst;
}

}  // namespace stoss
