#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace gas {

/// The next event of each particle, earliest first: a binary heap in which the time of any particle can change. Of
/// equal times the smaller index comes first.
class EventQueue {
 public:
  explicit EventQueue(std::size_t particles) : time_(particles, 0.0), heap_(particles), place_(particles) {
    for (std::size_t i = 0; i < particles; ++i) heap_[i] = place_[i] = i;
  }

  /// Whose event is next.
  [[nodiscard]] std::size_t first() const { return heap_[0]; }

  [[nodiscard]] double time(std::size_t particle) const { return time_[particle]; }

  void set(std::size_t particle, double time) {
    time_[particle] = time;
    rise(place_[particle]);
    sink(place_[particle]);
  }

 private:
  [[nodiscard]] bool before(std::size_t a, std::size_t b) const {
    const double first = time_[heap_[a]], second = time_[heap_[b]];
    return first < second || (first == second && heap_[a] < heap_[b]);
  }

  void exchange(std::size_t a, std::size_t b) {
    std::swap(heap_[a], heap_[b]);
    place_[heap_[a]] = a;
    place_[heap_[b]] = b;
  }

  void rise(std::size_t at) {
    for (; at > 0 && before(at, (at - 1) / 2); at = (at - 1) / 2) exchange(at, (at - 1) / 2);
  }

  void sink(std::size_t at) {
    for (std::size_t child = 2 * at + 1; child < heap_.size(); child = 2 * at + 1) {
      if (child + 1 < heap_.size() && before(child + 1, child)) ++child;
      if (!before(child, at)) return;
      exchange(at, child);
      at = child;
    }
  }

  std::vector<double> time_;
  std::vector<std::size_t> heap_, place_;
};

}  // namespace gas
