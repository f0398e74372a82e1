#include "against.hpp"

#include <vector>

#include "keys.hpp"
#include "numbers.hpp"
#include "text.hpp"

namespace stoss::cli {
namespace {

/// What can be met, with the keys of its numbers.
const std::map<std::string, std::vector<std::string>> kinds{
    {"wall", {}},
    {"same", {}},
    {"disk", {"poisson", "radius", "young", "density", "loss_time"}},
    {"sphere", {"poisson", "radius", "young", "density", "loss_time", "yield"}},
    {"rod", {"length", "young", "density", "area", "loss_time"}},
    {"half-space", {"poisson", "young", "density", "loss_time", "yield"}},
    {"half-plane", {"poisson", "young", "density", "loss_time"}},
    {"exponential", {"hardness", "strength"}},
};

const std::vector<std::string> names_of_kinds{"wall", "same",       "disk",       "sphere",
                                              "rod",  "half-space", "half-plane", "exponential"};

}  // namespace

double Against::value(const std::string& key, double otherwise) const {
  const auto found = values.find(key);
  return found == values.end() ? otherwise : found->second;
}

Against parse_against(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  Against against;
  against.kind = without_spaces(parts.front());
  const auto kind = kinds.find(against.kind);
  if (kind == kinds.end()) refuse_word("against", against.kind, names_of_kinds);
  for (const auto& [key, value] : parse_keys("against", parts, 1, kind->second, " with " + against.kind)) {
    against.values[key] = parse_number("against " + key, value);
  }
  return against;
}

}  // namespace stoss::cli
