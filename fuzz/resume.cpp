// What an earlier run has left is read, or refused, and left as it was; its rows are written as they were read.
#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "oracle.hpp"
#include "output/row_run.hpp"

using namespace stoss;

namespace {

/// A file of this process, which goes with it.
const std::string& file() {
  static const struct File {
    std::string path = std::filesystem::temp_directory_path() / ("stoss-fuzz-" + std::to_string(getpid()) + ".csv");
    ~File() { std::filesystem::remove(path); }
  } its;
  return its.path;
}

void write(std::string_view text) {
  std::ofstream stream(file(), std::ios::binary | std::ios::trunc);
  stream << text;
}

std::string content() {
  std::ifstream stream(file(), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

/// The first byte tells how much of a right header stands before the rest; the whole of it for 255.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const cli::Provenance provenance{"restitution", "stoss restitution", {{"poisson", 0.3}, {"speed", "0.1,0.2"}}};
  const cli::Columns columns{{"speed", "c"}, {"restitution"}, {"restitution_error"}, {"converged"}};
  std::string text = cli::csv_header(provenance) + cli::csv_columns(columns) + "\n";
  text.resize(text.size() * data[0] / 255);
  text += fuzz::text_of(data + 1, size - 1);
  write(text);
  std::uintmax_t kept = 0;
  std::vector<cli::Row> rows;
  const bool read = fuzz::reads([&] {
    const cli::Output output(file(), cli::Output::Use::resume);
    kept = cli::read_earlier(output, provenance, columns, [&](const cli::Row& row) { rows.push_back(row); }).size;
  });
  fuzz::hold(content() == text, "the file is left as it was");
  for (const cli::Row& row : rows) {
    const auto again = cli::row_of_csv(cli::csv_row(row), columns.size());
    fuzz::hold(again && cli::csv_row(*again) == cli::csv_row(row), "a row is written as it was read");
  }
  if (!read) return 0;
  fuzz::hold(kept <= text.size() && (kept == 0 || text[kept - 1] == '\n'), "whole lines are kept");
  return 0;
}
