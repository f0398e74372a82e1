#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "stoss/poll.hpp"

namespace stoss {

/// Runs job(i, heed) for i = 0 … count−1 and hands each result to deliver(i, result) in order, on the calling thread,
/// as soon as all before it are there. With one thread, or one job, everything runs on the calling thread, and `heed`
/// is `poll`; with more, `poll` is called on the calling thread while it waits. What a job, deliver or poll throws ends
/// the rest: the jobs under way call `heed` every few milliseconds and let pass what it throws.
/// @param threads 0: as many as the machine has
template <typename Result>
void run_in_order(std::size_t count, int threads, const std::function<Result(std::size_t, const Poll& heed)>& job,
                  const std::function<void(std::size_t, Result&&)>& deliver, const Poll& poll) {
  const std::size_t available = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t used = std::min(count, threads == 0 ? available : static_cast<std::size_t>(threads));
  if (used <= 1) {
    for (std::size_t i = 0; i < count; ++i) deliver(i, job(i, poll));
    return;
  }
  using Outcome = std::variant<Result, std::exception_ptr>;
  constexpr auto patience = std::chrono::milliseconds(20);
  std::vector<std::optional<Outcome>> outcomes(count);
  std::mutex mutex;
  std::condition_variable ready;
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stop = false;

  struct Stopped {};
  const Poll heed = [&stop] {
    if (stop) throw Stopped{};
  };
  const auto work = [&] {
    for (std::size_t mine = next++; mine < count && !stop; mine = next++) {
      std::optional<Outcome> outcome;
      try {
        outcome = job(mine, heed);
      } catch (...) {
        outcome = std::current_exception();
      }
      const std::lock_guard lock(mutex);
      outcomes[mine] = std::move(outcome);
      ready.notify_one();
    }
  };

  std::vector<std::thread> pool;
  const auto join = [&pool] {
    for (std::thread& thread : pool) thread.join();
  };
  try {
    for (std::size_t i = 0; i < used; ++i) pool.emplace_back(work);
    for (std::size_t i = 0; i < count; ++i) {
      std::unique_lock lock(mutex);
      while (!outcomes[i]) {
        if (poll) {
          lock.unlock();
          poll();
          lock.lock();
          if (outcomes[i]) break;
        }
        ready.wait_for(lock, patience);
      }
      Outcome outcome = std::move(*outcomes[i]);
      outcomes[i].reset();
      lock.unlock();
      if (auto* failure = std::get_if<std::exception_ptr>(&outcome)) std::rethrow_exception(*failure);
      deliver(i, std::move(std::get<Result>(outcome)));
    }
  } catch (...) {
    stop = true;
    join();
    throw;
  }
  join();
}

}  // namespace stoss
