#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

namespace stoss::cli {

/// A text in lines of at most `width` characters, without a line end behind it. Its own line ends count only before
/// lines that begin with a space, which are items: what of an item does not fit hangs two spaces further in.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width);

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

}  // namespace stoss::cli
