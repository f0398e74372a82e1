#pragma once

#include <cstddef>
#include <memory>

#include "contact/edge/factored_compliance.hpp"
#include "contact/mode_tables.hpp"
#include "contact/recent.hpp"
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

/// What impacts at a contact have needed last: to make it takes as long as many steps, and neighbouring speeds and the
/// samples of an ensemble need the same. Any number of threads may ask.
class SetUps {
 public:
  /// The set-up of a contact, which is kept.
  [[nodiscard]] std::shared_ptr<const SetUp> of(const Contact& contact, const ContactGrid& grid,
                                                ResidualMotion::Inertia inertia, double step, const Poll& poll);

  /// The tables of its modes, which are kept.
  [[nodiscard]] std::shared_ptr<const ModeTables> modes(const Contact& contact, const ContactGrid& grid, double step,
                                                        Kicks kicks);

 private:
  struct Grid {
    const Body *first, *second;
    double cutoff, radius, spacing;
    std::size_t count;
    double step;
    bool operator==(const Grid&) const = default;
  };
  struct Key {
    Grid grid;
    ResidualMotion::Inertia inertia;
    bool operator==(const Key&) const = default;
  };
  struct ModesKey {
    Grid grid;
    Kicks kicks;
    bool operator==(const ModesKey&) const = default;
  };
  static Grid key_of(const Contact& contact, const ContactGrid& grid, double step);

  static constexpr std::size_t mega = std::size_t{1} << 20U;  // bytes
  Recent<Key, SetUp> set_ups_{16 * mega};
  Recent<ModesKey, ModeTables> modes_{3 * mega};
};

/// The tables of the modes of a contact, shared where it shares what it has made.
[[nodiscard]] std::shared_ptr<const ModeTables> mode_tables(const Contact& contact, const ContactGrid& grid,
                                                            double step, Kicks kicks);

}  // namespace stoss
