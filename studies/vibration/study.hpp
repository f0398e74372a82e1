#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "stoss/restitution/ladder.hpp"

/// What the tables of this study share. Each is computed and written by one function.
namespace study {

/// A body at a wall and how it is called in the tables.
struct Case {
  std::string body;
  stoss::RefinableContact contact;
};

/// Sphere of ν = 0.3, disk of ν = 0.33.
[[nodiscard]] const Case& sphere();
[[nodiscard]] const Case& disk();

/// f(0) … f(count − 1), each on some thread.
template <typename F>
void on_all_threads(std::size_t count, F&& f) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) f(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> threads;
  for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

/// ε₀ + a√E cos(φ − φ₀), which ε is to first order when one mode vibrates.
struct Sinusoid {
  double mean = 0.0;       ///< ε₀, of the unexcited body
  double amplitude = 0.0;  ///< a
  double error = 0.0;      ///< of a
  double phase = 0.0;      ///< φ₀
};

/// From four phases at a small energy.
[[nodiscard]] Sinusoid sinusoid(const Case& it, double speed, int order, int index);

void write_phases(const std::string& name);
void write_modes(const std::string& name);
void write_temperatures(const std::string& name, const std::string& name_of_samples);
void write_heat(const std::string& name);
void write_bounces(const std::string& name, const std::string& name_of_shares, const std::string& name_of_modes);
void write_chain(const std::string& name, const std::string& name_of_distribution);

}  // namespace study
