
#include <algorithm>
#include <utility>

#include "app.hpp"
#include "process/process.hpp"

namespace stoss::cli {
namespace {

constexpr std::size_t narrowest = 40;
constexpr std::size_t names_width = 26;

/// Where a line ends of which `room` characters fit: behind a space, or behind a comma of a word that is longer.
std::size_t end_of_line(std::string_view text, std::size_t room) {
  if (text.size() <= room) return text.size();
  if (const auto space = text.rfind(' ', room); space != std::string_view::npos && space > 0) return space;
  if (const auto comma = text.rfind(',', room - 1); comma != std::string_view::npos) return comma + 1;
  return std::min(text.find_first_of(" ,"), text.size());
}

void append_wrapped(std::string& text, std::string_view words, std::size_t width, std::size_t indent,
                    std::size_t hanging) {
  for (bool first = true; !words.empty(); first = false) {
    const std::size_t margin = first ? indent : hanging;
    const std::size_t end = end_of_line(words, width - std::min(margin, width / 2));
    if (!text.empty()) text += '\n';
    text += std::string(margin, ' ');
    text += words.substr(0, end);
    words.remove_prefix(end);
    words.remove_prefix(std::min(words.find_first_not_of(' '), words.size()));
  }
}

/// All lines but the first begin with so many spaces.
std::string indented(std::string text, std::size_t margin) {
  for (auto at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
    text.insert(at + 1, margin, ' ');
  }
  return text;
}

/// Lines as they are, but for those that are too long: these go on six spaces in, as a command line does.
std::string with_short_lines(const std::string& text, std::size_t width) {
  constexpr std::size_t hanging = 6;
  std::string all;
  for (const std::string& line : split(text, '\n')) {
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    append_wrapped(all, std::string_view(line).substr(indent), width, indent, indent > 0 ? hanging : 0);
  }
  return all;
}

/// A text in lines of at most `width` characters, without a line end behind it. Its own line ends count only before
/// lines that begin with a space, which are items: what of an item does not fit hangs two spaces further in.
std::string wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> items;
  for (std::string& line : split(std::string(text), '\n')) {
    const bool item = line.rfind(' ', 0) == 0;
    if (items.empty() || item || items.back().rfind(' ', 0) == 0) {
      items.push_back(std::move(line));
    } else {
      items.back() += ' ' + line;
    }
  }
  std::string all;
  for (const std::string& item : items) {
    const std::size_t indent = std::min(item.find_first_not_of(' '), item.size());
    append_wrapped(all, std::string_view(item).substr(indent), width, indent, indent > 0 ? indent + 2 : 0);
  }
  return all;
}

/// The help of the command and its subcommands, wrapped to the terminal: names left, what they mean right of them.
class Help : public CLI::Formatter {
 public:
  /// @param width of the terminal, in characters
  explicit Help(std::size_t width);

  [[nodiscard]] std::string make_group(std::string group, bool positional,
                                       std::vector<const CLI::Option*> options) const override;
  [[nodiscard]] std::string make_option(const CLI::Option* option, bool positional) const override;
  [[nodiscard]] std::string make_subcommand(const CLI::App* command) const override;
  [[nodiscard]] std::string make_description(const CLI::App* app) const override;
  [[nodiscard]] std::string make_footer(const CLI::App* app) const override;

 private:
  [[nodiscard]] std::string entry(const std::string& name, const std::string& meaning) const;

  std::size_t width_;
};

Help::Help(std::size_t width) : width_(std::max(width, narrowest)) { column_width(names_width); }

std::string Help::entry(const std::string& name, const std::string& meaning) const {
  const std::size_t column = get_column_width();
  constexpr std::size_t indent = 2, hanging = 6;
  std::string text;
  append_wrapped(text, name, width_, indent, hanging);
  const bool beside = text.size() < column;
  text += beside ? std::string(column - text.size(), ' ') : "\n" + std::string(column, ' ');
  return text + indented(wrapped(meaning, width_ - column), column) + "\n";
}

std::string Help::make_group(std::string group, bool positional, std::vector<const CLI::Option*> options) const {
  std::string text = "\n" + wrapped(group + ":", width_) + "\n";
  for (const CLI::Option* option : options) text += make_option(option, positional);
  return text;
}

std::string Help::make_option(const CLI::Option* option, bool positional) const {
  return entry(make_option_name(option, positional) + make_option_opts(option), make_option_desc(option));
}

std::string Help::make_subcommand(const CLI::App* command) const {
  return entry(command->get_display_name(true), command->get_description());
}

std::string Help::make_description(const CLI::App* app) const { return wrapped(app->get_description(), width_) + "\n"; }

std::string Help::make_footer(const CLI::App* app) const { return with_short_lines(app->get_footer(), width_) + "\n"; }

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_formatter(std::size_t width) { return std::make_shared<Help>(width); }

}  // namespace stoss::cli
