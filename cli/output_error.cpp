#include "output_error.hpp"

#include <fmt/format.h>

#include <cstring>

#include "text.hpp"

namespace stoss::cli {
namespace {

std::string sentence(const std::string& path, std::string_view why) {
  const std::string place = path.empty() ? "to stdout" : fmt::format("'{}'", shortened(path, longest_path));
  return fmt::format("output: cannot write {}: {}", place, why);
}

}  // namespace

void cannot_write(const std::string& path, std::string_view why) { throw OutputError(sentence(path, why)); }

void cannot_write(const std::string& path, int reason) {
  throw OutputError(sentence(path, std::strerror(reason)), reason);
}

}  // namespace stoss::cli
