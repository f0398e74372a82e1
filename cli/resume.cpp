#include "resume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include "csv.hpp"
#include "lines.hpp"
#include "stoss/errors.hpp"
#include "text.hpp"

namespace stoss::cli {
namespace {

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
bool read_header(Lines& lines, const Provenance& provenance, const std::string& columns) {
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
  if (complete && names != columns) refuse_file(lines, names);
  return complete;
}

bool is_value(const std::string& cell) {
  if (cell == "true" || cell == "false" || cell == unknown) return true;
  double number = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  return error == std::errc{} && end == cell.data() + cell.size();
}

}  // namespace

Earlier read_earlier(const Output& output, const Provenance& provenance, const std::string& columns,
                     const RowVisitor& visit) {
  Lines lines(output);
  if (!read_header(lines, provenance, columns)) return {};
  const auto width = split(columns, ',').size();
  Earlier earlier{lines.size(), 0};
  while (const auto line = lines.next()) {
    const long number = lines.count();
    if (*line == csv_interrupted && !lines.next()) break;
    const std::vector<std::string> cells = split(*line, ',');
    if (cells.size() != width || !std::all_of(cells.begin(), cells.end(), is_value)) {
      throw InvalidInput(
          fmt::format("resume: got '{}' as line {} of '{}', allowed a row of {} numbers (mend it, or "
                      "write another file)",
                      excerpt(*line), number, lines.path(), width));
    }
    visit(earlier.rows++, cells);
    earlier.size = lines.size();
  }
  return earlier;
}

}  // namespace stoss::cli
