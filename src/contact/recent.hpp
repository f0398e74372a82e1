#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>

namespace stoss {

/// What was made last, by key, as long as all of it together is not larger than some size. Any number of threads may
/// ask.
template <typename Key, typename Value>
class Recent {
 public:
  explicit Recent(std::size_t most) : most_(most) {}

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

}  // namespace stoss
