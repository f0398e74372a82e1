#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>

#include "contact/edge/factored_compliance.hpp"
#include "contact/residual/residuals.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// What hard contacts on one grid with one step share, whatever their speed and start.
struct SetUp {
  Residuals residuals;  ///< at rest
  std::shared_ptr<const FactoredCompliance> compliance;
};

/// @throws NotConverged if W is not positive definite
[[nodiscard]] SetUp make_set_up(const Contact& contact, const ContactGrid& grid, ResidualMotion::Inertia inertia,
                                double step, const Poll& poll);

/// The set-ups that impacts at a contact have needed last: one takes as long as many steps, and neighbouring speeds and
/// the samples of an ensemble need the same. Any number of threads may ask.
class SetUps {
 public:
  /// The set-up of a contact, which is kept.
  [[nodiscard]] std::shared_ptr<const SetUp> of(const Contact& contact, const ContactGrid& grid,
                                                ResidualMotion::Inertia inertia, double step, const Poll& poll);

 private:
  struct Key {
    const Body *first, *second;
    double cutoff, radius, spacing;
    std::size_t count;
    ResidualMotion::Inertia inertia;
    double step;
    bool operator==(const Key&) const = default;
  };

  std::mutex mutex_;
  std::deque<std::pair<Key, std::shared_ptr<const SetUp>>> kept_;
};

}  // namespace stoss
