#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <variant>
#include <vector>

#include "interrupt.hpp"

namespace stoss::cli {

/// Runs job(0) … job(count−1) on several threads and hands each result, or the exception in its place, to `deliver` in
/// order, on the calling thread, as soon as all before it are there. Results do not depend on the number of threads.
/// @throws Interrupted after Ctrl-C or SIGTERM, when the jobs under way have ended; what `deliver` throws
template <typename Result>
void run_in_order(std::size_t count, int threads, const std::function<Result(std::size_t)>& job,
                  const std::function<void(std::size_t, std::variant<Result, std::exception_ptr>)>& deliver) {
  using Outcome = std::variant<Result, std::exception_ptr>;
  std::vector<std::optional<Outcome>> outcomes(count);
  std::mutex mutex;
  std::condition_variable ready;
  std::size_t next = 0;
  bool stop = false;

  const auto work = [&] {
    for (;;) {
      std::size_t mine;
      {
        const std::lock_guard lock(mutex);
        if (stop || interrupted() != 0 || next == count) return;
        mine = next++;
      }
      std::optional<Outcome> outcome;
      try {
        outcome = job(mine);
      } catch (...) {
        outcome = std::current_exception();
      }
      const std::lock_guard lock(mutex);
      outcomes[mine] = std::move(outcome);
      ready.notify_one();
    }
  };

  std::vector<std::jthread> pool;
  pool.reserve(static_cast<std::size_t>(threads));
  try {
    for (int i = 0; i < threads; ++i) pool.emplace_back(work);
    for (std::size_t i = 0; i < count; ++i) {
      std::unique_lock lock(mutex);
      while (!outcomes[i]) {
        if (interrupted() != 0) throw Interrupted{};
        ready.wait_for(lock, std::chrono::milliseconds(50));
      }
      Outcome outcome = std::move(*outcomes[i]);
      outcomes[i].reset();
      lock.unlock();
      deliver(i, std::move(outcome));
    }
  } catch (...) {
    const std::lock_guard lock(mutex);
    stop = true;
    throw;
  }
}

}  // namespace stoss::cli
