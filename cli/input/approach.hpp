#pragma once

#include <string>
#include <vector>

#include "input/inputs.hpp"

namespace stoss::cli {

/// How fast bodies meet, as a question takes it: --speed or, of a body with a material, --height of the fall.
struct ApproachOptions {
  Question question{};
  std::string speed, height;

  void add_to(CLI::App& command, Question of, const std::string& group);

  /// Speeds in units of the first body. @throws CLI::RequiredError if there are none, InvalidInput
  [[nodiscard]] std::vector<double> series(const Units& units) const;

  /// One of them. @param note why only one
  [[nodiscard]] double one(const Units& units, const std::string& note = {}) const;

  /// The ends of a range.
  [[nodiscard]] Ends ends(const Units& units) const;

 private:
  void require_given(const Units& units) const;
};

}  // namespace stoss::cli
