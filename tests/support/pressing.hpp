#pragma once

#include <numeric>
#include <vector>

#include "contact/edge/edge_contact.hpp"
#include "contact/touch.hpp"
#include "stoss/contact/grid.hpp"
#include "support/complementarity.hpp"

namespace stoss::test {

/// The whole force on a body that is pressed to another, and how wide they touch.
struct Press {
  double force = 0.0, half_width = 0.0;
};

/// A body and what it is pressed to, by all its modes that are not kept: with the edge law, and without.
class Pressing {
 public:
  Pressing(const Contact& contact, double width, int nodes)
      : grid_(contact_grid(contact, width, nodes)),
        shift_(touch_compression(contact, grid_, 1.0)),
        with_law_(residual_compliance(contact, grid_), edge_law(contact, grid_, 0.0), grid_.recess.size(), {}),
        without_(residual_compliance(contact, grid_), grid_.recess.size()),
        force_(grid_.recess.size()),
        moved_(grid_.recess.size()) {}

  [[nodiscard]] double spacing() const { return grid_.points.spacing * grid_.points.radius; }

  /// Compression at which this grid begins to push.
  [[nodiscard]] double shift() const { return shift_; }

  Press with_law(double compression) {
    with_law_.solve(position(compression), force_, moved_);
    return {sum(), with_law_.half_width() * spacing()};
  }

  double without_law(double compression) {
    without_.solve(position(compression), force_, moved_);
    return sum();
  }

 private:
  [[nodiscard]] std::vector<double> position(double compression) const {
    std::vector<double> q;
    for (const double recess : grid_.recess) q.push_back(compression - recess);
    return q;
  }
  [[nodiscard]] double sum() const { return std::accumulate(force_.begin(), force_.end(), 0.0); }

  ContactGrid grid_;
  double shift_;
  EdgeContact with_law_;
  Complementarity without_;
  std::vector<double> force_, moved_;
};

}  // namespace stoss::test
