#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include "support/csv.hpp"

namespace stoss::test {

/// The document of a body in examples/any_body, as it stands in one of who meets whom.
/// @param more further members, as R"(, "yield_strength": 3e8)"
inline std::string body_of_file(const std::string& name, const std::string& more = {}) {
  std::ifstream stream(data_path("../../examples/any_body/" + name + ".json"));
  return R"({"kind": "modal", "body": )" + std::string{std::istreambuf_iterator<char>(stream), {}} + more + "}";
}

/// A document of who meets whom.
inline std::string meeting_of(const std::string& first, const std::string& against) {
  return R"({"first": )" + first + R"(, "against": )" + against + "}";
}

/// The steel of these bodies, and a ball of it.
inline const std::string steel_of_files = R"("material": {"young": 210e9, "poisson": 0.3, "density": 7850})";
inline std::string steel_ball(const std::string& radius, const std::string& more = {}) {
  return R"({"kind": "sphere", "radius": )" + radius + ", " + steel_of_files + more + "}";
}

}  // namespace stoss::test
