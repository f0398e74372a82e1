#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "input/encounter.hpp"
#include "output/output.hpp"
#include "process/process.hpp"
#include "stoss/encounter/modal_file.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {

namespace {

/// Refuses what may never end or never begin: a FIFO by its name, a device. Streams that are open already are read.
void require_file(const std::string& option, const std::string& path, const std::string& what) {
  std::error_code none;
  const std::filesystem::file_status its = std::filesystem::status(path, none);
  const bool open_already =
      path == "/dev/stdin" || path.rfind("/dev/fd/", 0) == 0 || path.rfind("/proc/self/fd/", 0) == 0;
  if (open_already || !is_other(its)) return;
  throw InvalidInput::out_of_range(
      fmt::format("{}", option), fmt::format("'{}', which is no regular file", shortened(path)), what, "or /dev/stdin");
}

}  // namespace

std::string text_of_file(const std::string& option, const std::string& path, const std::string& what) {
  constexpr std::size_t most = 64U << 20U;
  require_file(option, path, what);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string all;
  if (file) {
    all.resize(most + 1);
    file.read(all.data(), static_cast<std::streamsize>(all.size()));
    all.resize(static_cast<std::size_t>(file.gcount()));
  }
  if (!file.is_open() || file.bad() || (file.gcount() == 0 && errno != 0)) {
    const int reason = errno != 0 ? errno : EIO;
    throw OutputError(fmt::format("{}: cannot read '{}' ({})", option, shortened(path), std::strerror(reason)), reason);
  }
  if (all.size() > most) {
    throw InvalidInput::out_of_range(fmt::format("{}", option), fmt::format("'{}' of more than 64 MiB", path), what);
  }
  return all;
}

Participant modal_from_file(const std::string& option, const std::string& text) {
  const std::string path = text.substr(1), all = text_of_file(option, path, "a file of modes at a point");
  if (all.rfind("PK", 0) == 0) {  // a ZIP archive, which an NPZ file is
    throw InvalidInput::out_of_range(fmt::format("{}", option), fmt::format("'@{}', an NPZ file", path), "JSON",
                                     fmt::format("in Python: stoss.ModalBody.read('{}').save('body.json')", path));
  }
  return modal_participant(modal_body_from_json(all, option + " " + path));
}

}  // namespace stoss::cli
