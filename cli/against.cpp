#include "against.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "numbers.hpp"
#include "stoss/errors.hpp"
#include "suggestion.hpp"
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

[[noreturn]] void refuse(const std::string& got, const std::vector<std::string>& allowed, const std::string& where) {
  const std::string similar = nearest(got, allowed);
  const std::string names = allowed.empty() ? "none" : fmt::format("{}", fmt::join(allowed, ", "));
  throw InvalidInput(fmt::format("against: got '{}', allowed {}{}{}", shortened(got), names, where,
                                 similar.empty() ? "" : fmt::format(", did you mean {}?", similar)));
}

std::string without_spaces(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

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
  if (kind == kinds.end()) refuse(against.kind, names_of_kinds, "");
  const std::vector<std::string>& keys = kind->second;
  for (auto part = parts.begin() + 1; part != parts.end(); ++part) {
    const auto equals = part->find('=');
    const std::string key = without_spaces(part->substr(0, equals));
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) refuse(key, keys, " with " + against.kind);
    if (equals == std::string::npos) {
      throw InvalidInput(fmt::format("against: got '{0}' without a value, allowed {0}=NUMBER", key));
    }
    const double value = parse_number("against " + key, part->substr(equals + 1));
    if (!against.values.emplace(key, value).second) {
      throw InvalidInput(fmt::format("against: got {} twice, allowed once", key));
    }
  }
  return against;
}

}  // namespace stoss::cli
