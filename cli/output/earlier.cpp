// What an earlier run has left.
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <map>
#include <optional>
#include <utility>

#include "output/row_run.hpp"
#include "process/process.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

/// The complete lines of an output, one by one.
struct Lines {
  std::string path;  ///< for messages
  std::FILE* stream;
  std::uintmax_t size = 0;  ///< of the lines read so far
  long count = 0;           ///< their number
  std::string rest{};       ///< the incomplete last line

  /// The next line without its end; nothing where no complete line follows. @throws OutputError, InvalidInput for CRLF
  std::optional<std::string> next() {
    rest.clear();
    for (int c = std::getc(stream); c != EOF && c != '\n'; c = std::getc(stream)) rest += static_cast<char>(c);
    if (std::ferror(stream) != 0) {
      throw OutputError(fmt::format("resume: cannot read '{}': {}", path, std::strerror(errno)));
    }
    if (std::feof(stream) != 0) return std::nullopt;
    if (rest.ends_with('\r')) {
      throw InvalidInput::out_of_range("resume", fmt::format("line ends CRLF in '{}'", path),
                                       "LF, as stoss writes them", "dos2unix converts a file");
    }
    size += rest.size() + 1;
    ++count;
    return std::exchange(rest, {});
  }
};

constexpr std::size_t longest_excerpt = 200;  // room for a body in SI

/// The beginning of a line that may be anything; a message would end at a NUL.
std::string excerpt(const std::string& line) { return visible(shortened(line, longest_excerpt)); }

[[noreturn]] void refuse_file(const Lines& lines, const std::string& got) {
  throw InvalidInput::out_of_range("resume", fmt::format("'{}' in '{}'", excerpt(got), lines.path),
                                   "a CSV file of this job", "it is left alone");
}

[[noreturn]] void refuse_input(const Lines& lines, const std::string& name, const std::string& now,
                               const std::string& before) {
  throw InvalidInput::out_of_range(name, shortened(now, longest_excerpt),
                                   fmt::format("{} as in '{}'", before, lines.path), "another job needs another file");
}

void check_origin(const Lines& lines, const std::string& got, const Provenance& provenance) {
  const std::string expected = csv_origin(provenance);
  if (got == expected) return;
  constexpr std::size_t name = std::string_view("# stoss ").size();
  const auto colon = got.find(": "), end = expected.find(": ");
  if (got.compare(0, name, expected, 0, name) != 0 || colon == std::string::npos) refuse_file(lines, got);
  if (got.substr(colon) != expected.substr(end)) {
    refuse_input(lines, "kind of result", expected.substr(end + 2), excerpt(got.substr(colon + 2)));
  }
  refuse_input(lines, "version of stoss", expected.substr(name, end - name), excerpt(got.substr(name, colon - name)));
}

using Inputs = std::map<std::string, std::string>;

void check_inputs(const Lines& lines, Inputs found, const Provenance& provenance, bool all) {
  for (const auto& [name, value] : csv_inputs(provenance)) {
    const auto before = found.extract(name);
    if (before.empty() && all) refuse_input(lines, name, value, "none");
    if (!before.empty() && before.mapped() != value) refuse_input(lines, name, value, excerpt(before.mapped()));
  }
  found.erase("command");
  if (!found.empty()) refuse_input(lines, excerpt(found.begin()->first), "none", excerpt(found.begin()->second));
}

/// Whether the header is complete, up to the names of the columns. If it is not, there is no row either.
/// @param checked whether the last column is that of checksums
bool read_header(Lines& lines, const Provenance& provenance, const Columns& columns, bool& checked) {
  const auto first = lines.next();
  if (!first) {
    if (csv_origin(provenance).rfind(lines.rest, 0) != 0) refuse_file(lines, lines.rest);
    return false;
  }
  check_origin(lines, *first, provenance);
  Inputs found;
  std::string names;
  bool complete = false;
  while (const auto line = lines.next()) {
    if (*line == csv_interrupted) {  // before the first row
      if (lines.next()) refuse_file(lines, *line);
      break;
    }
    if (!line->starts_with("# ")) {
      names = *line;
      complete = true;
      break;
    }
    const auto colon = line->find(": ");
    if (colon == std::string::npos) refuse_file(lines, *line);
    found[line->substr(2, colon - 2)] = line->substr(colon + 2);
  }
  check_inputs(lines, std::move(found), provenance, complete);
  const std::string expected = csv_columns(columns);
  checked = names == fmt::format("{},{}", expected, csv_checksum);
  if (complete && !checked && names != expected) refuse_file(lines, names);
  return complete;
}

}  // namespace

Earlier read_earlier(const Output& output, const Provenance& provenance, const Columns& columns,
                     const std::function<void(const Row&)>& visit) {
  Lines lines{shortened(output.path(), longest_path), output.stream()};
  Earlier made;
  if (!read_header(lines, provenance, columns, made.checked)) return {};
  made.size = lines.size;
  while (const auto line = lines.next()) {
    const long number = lines.count;
    if (*line == csv_interrupted && !lines.next()) break;
    const std::string cells = made.checked ? line->substr(0, line->rfind(',')) : *line;
    const auto row = row_of_csv(cells, columns.size());
    if (!row) {
      throw InvalidInput::out_of_range(
          "resume", fmt::format("'{}' as line {} of '{}'", excerpt(*line), number, lines.path),
          fmt::format("a row of {} numbers", columns.size()), "mend it, or write another file");
    }
    if (made.checked && with_checksum(cells) != *line) {
      throw InvalidInput::out_of_range(
          "resume", fmt::format("line {} of '{}' with the checksum of another row", number, lines.path),
          "a row as it was written", "mend it, or write another file");
    }
    visit(*row);
    made.size = lines.size;
  }
  return made;
}

}  // namespace stoss::cli
