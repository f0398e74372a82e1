#include "output/earlier.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <map>
#include <optional>

#include "process/text.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

/// The complete lines of an output, one by one.
class Lines {
 public:
  explicit Lines(const Output& output) : path_(shortened(output.path(), longest_path)), stream_(output.stream()) {}

  /// The next line without its end; nothing where no complete line follows. @throws OutputError, InvalidInput for CRLF
  std::optional<std::string> next() {
    std::string line;
    for (int c = std::getc(stream_); c != EOF; c = std::getc(stream_)) {
      if (c != '\n') {
        line += static_cast<char>(c);
        continue;
      }
      if (!line.empty() && line.back() == '\r') {
        throw InvalidInput(fmt::format(
            "resume: got line ends CRLF in '{}', allowed LF, as stoss writes them (dos2unix converts a file)", path_));
      }
      size_ += line.size() + 1;
      ++count_;
      return line;
    }
    if (std::ferror(stream_) != 0) {
      throw OutputError(fmt::format("resume: cannot read '{}': {}", path_, std::strerror(errno)));
    }
    rest_ = line;
    return std::nullopt;
  }

  [[nodiscard]] std::uintmax_t size() const { return size_; }      ///< of the lines read so far
  [[nodiscard]] long count() const { return count_; }              ///< their number
  [[nodiscard]] const std::string& rest() const { return rest_; }  ///< the incomplete last line
  [[nodiscard]] const std::string& path() const { return path_; }  ///< for messages

 private:
  std::string path_;
  std::FILE* stream_;
  std::uintmax_t size_ = 0;
  long count_ = 0;
  std::string rest_;
};

constexpr std::size_t longest_excerpt = 40;

/// The beginning of a line that may be anything; a message would end at a NUL.
std::string excerpt(const std::string& line) { return visible(shortened(line, longest_excerpt)); }

[[noreturn]] void refuse_file(const Lines& lines, const std::string& got) {
  throw InvalidInput(fmt::format("resume: got '{}' in '{}', allowed a CSV file of this job (it is left alone)",
                                 excerpt(got), lines.path()));
}

[[noreturn]] void refuse_input(const Lines& lines, const std::string& name, const std::string& now,
                               const std::string& before) {
  throw InvalidInput(fmt::format("{}: got {}, allowed {} as in '{}' (another job needs another file)", name,
                                 shortened(now), before, lines.path()));
}

void check_origin(const Lines& lines, const std::string& got, const Provenance& provenance) {
  const std::string expected = csv_origin(provenance);
  if (got == expected) return;
  constexpr std::string_view name = "# stoss ";
  const auto colon = got.find(": ");
  if (got.rfind(name, 0) != 0 || colon == std::string::npos) refuse_file(lines, got);
  const auto end = expected.find(": ");
  const auto part = [&](const std::string& line, std::size_t from, std::size_t to) { return line.substr(from, to); };
  if (got.substr(colon) != expected.substr(end)) {
    refuse_input(lines, "kind of result", part(expected, end + 2, std::string::npos),
                 excerpt(part(got, colon + 2, std::string::npos)));
  }
  refuse_input(lines, "version of stoss", part(expected, name.size(), end - name.size()),
               excerpt(part(got, name.size(), colon - name.size())));
}

using Inputs = std::map<std::string, std::string>;

void check_inputs(const Lines& lines, Inputs found, const Provenance& provenance, bool all) {
  for (const auto& [name, value] : csv_inputs(provenance)) {
    const auto before = found.find(name);
    if (before == found.end() && all) refuse_input(lines, name, value, "none");
    if (before == found.end()) continue;
    if (before->second != value) refuse_input(lines, name, value, excerpt(before->second));
    found.erase(before);
  }
  found.erase("command");
  if (!found.empty()) refuse_input(lines, found.begin()->first, "none", excerpt(found.begin()->second));
}

/// Whether the header is complete, up to the names of the columns. If it is not, there is no row either.
bool read_header(Lines& lines, const Provenance& provenance, const Columns& columns) {
  const auto first = lines.next();
  if (!first) {
    if (csv_origin(provenance).rfind(lines.rest(), 0) != 0) refuse_file(lines, lines.rest());
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
  if (complete && names != csv_columns(columns)) refuse_file(lines, names);
  return complete;
}

}  // namespace

std::uintmax_t read_earlier(const Output& output, const Provenance& provenance, const Columns& columns,
                            const std::function<void(const Row&)>& visit) {
  Lines lines(output);
  if (!read_header(lines, provenance, columns)) return 0;
  std::uintmax_t size = lines.size();
  while (const auto line = lines.next()) {
    const long number = lines.count();
    if (*line == csv_interrupted && !lines.next()) break;
    const auto row = row_of_csv(*line, columns.size());
    if (!row) {
      throw InvalidInput(fmt::format(
          "resume: got '{}' as line {} of '{}', allowed a row of {} numbers (mend it, or write another file)",
          excerpt(*line), number, lines.path(), columns.size()));
    }
    visit(*row);
    size = lines.size();
  }
  return size;
}

}  // namespace stoss::cli
