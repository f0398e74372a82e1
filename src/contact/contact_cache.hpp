#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>

#include "contact/edge/compliance.hpp"
#include "contact/mode_tables.hpp"
#include "contact/residual/residuals.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// What was made last, by key, as long as all of it together is not larger than some size. Any number of threads may
/// ask.
template <typename Key, typename Value>
class Cache {
 public:
  explicit Cache(std::size_t most) : most_(most) {}

  /// The value of a key, which is kept, and made if it is not there.
  /// @param size of the value, in the unit of the most
  template <typename Make>
  std::shared_ptr<const Value> of(const Key& key, std::size_t size, const Make& make) {
    const auto find = [&] {
      return std::find_if(kept_.begin(), kept_.end(), [&](const Entry& each) { return each.key == key; });
    };
    {
      const std::lock_guard lock(mutex_);
      if (const auto known = find(); known != kept_.end()) return known->value;
    }
    auto made = std::make_shared<const Value>(make());
    const std::lock_guard lock(mutex_);
    if (const auto known = find(); known != kept_.end()) return known->value;
    kept_.push_back({key, made, size});
    for (size_ += size; size_ > most_; kept_.pop_front()) size_ -= kept_.front().size;
    return made;
  }

 private:
  struct Entry {
    Key key;
    std::shared_ptr<const Value> value;
    std::size_t size;
  };

  std::mutex mutex_;
  std::deque<Entry> kept_;
  std::size_t size_ = 0, most_;
};

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
class ContactCache {
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
  Cache<Key, SetUp> cached_{16 * mega};
  Cache<ModesKey, ModeTables> modes_{3 * mega};
};

/// The tables of the modes of a contact, shared where it shares what it has made.
[[nodiscard]] std::shared_ptr<const ModeTables> mode_tables(const Contact& contact, const ContactGrid& grid,
                                                            double step, Kicks kicks);

}  // namespace stoss
