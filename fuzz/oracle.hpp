#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"

namespace stoss::fuzz {

/// Ends the fuzzer, which keeps what it has read, unless this holds.
inline void hold(bool condition, std::string_view what) {
  if (condition) return;
  std::fprintf(stderr, "fuzz: this does not hold: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

/// A refusal is one line of printable UTF-8 that does not grow with what was read.
inline void hold_line(const char* refusal) {
  const std::string line(refusal);
  constexpr std::size_t most = 1000;
  if (visible(line) == line && !line.empty() && line.size() <= most) return;
  hold(false, "a refusal is one short line: " + visible(line.substr(0, most)));
}

/// Reads, which ends with a value or with a refusal of one line: whatever else is thrown ends the fuzzer.
/// @return whether it was read
template <typename Read>
bool reads(const Read& read) {
  try {
    read();
    return true;
  } catch (const InvalidInput& error) {
    hold_line(error.what());
    return false;
  }
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace stoss::fuzz
