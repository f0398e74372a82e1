#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// What each operating system does in its own way: `posix/`, and `windows/`, of which one is compiled.
namespace stoss::cli {

/// Makes stdin, stdout and stderr what the rest takes them for, first of all.
void prepare_streams();

/// Whether somebody sees what is written on stderr as it comes.
[[nodiscard]] bool stderr_is_terminal();

/// Whether somebody sees what is written on stdout as it comes.
[[nodiscard]] bool stdout_is_terminal();

inline constexpr std::size_t usual_width = 80;

/// Characters in a line of the terminal that stdout is, or 80 if it is none.
[[nodiscard]] std::size_t terminal_width();

/// Writes on stderr as it is, without a line end. If that cannot be written, it is lost and nothing else changes.
void show(std::string_view text) noexcept;

/// Whether a stdout that nobody reads any more ends this process, as is usual.
[[nodiscard]] bool pipe_ends();

/// Becomes the program that these words call, the first of which is its name: that of a Python environment beside this
/// one that has the package stoss (build/venv of a build tree, or that in whose bin the command is), else that of PATH
/// or, where PATH has none, beside this one or where systems have it. It begins with Ctrl-C held back, until it can
/// heed it.
/// @throws OutputError if it cannot be run
[[noreturn]] void become(const std::vector<std::string>& words);

}  // namespace stoss::cli
