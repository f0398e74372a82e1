#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "stoss/encounter/visible.hpp"

/// Signals, standard streams, other programs, and text of the command line. What each operating system does in its own
/// way is in `posix/`, and `windows/`, of which one is compiled.
namespace stoss::cli {

/// Thrown to leave a computation after Ctrl-C or SIGTERM; the command then exits with 128 + the signal's number.
struct Interrupted {};

/// From now on Ctrl-C and SIGTERM are noted instead of ending the program; a second one ends it.
void catch_interrupts();

/// Number of the signal that was noted, or 0.
[[nodiscard]] int interrupted();

/// @throws Interrupted after Ctrl-C or SIGTERM
void heed_interrupts();

/// Becomes Python with these words for the package's command of the same name: it has the store of sweeps, the fits,
/// and writes NetCDF. Complains of a package of another version, which would compute other values.
/// @throws OutputError if there is no Python, and on Windows
[[noreturn]] void become_python(const std::vector<std::string>& words);

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

/// The word as a shell reads it back: bare, in '…' or, with control characters, in $'…'.
[[nodiscard]] std::string shell_quoted(std::string_view word);

/// The parts of `text` between separators, empty ones too.
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);

/// The text without spaces at its ends.
[[nodiscard]] std::string without_spaces(const std::string& text);

/// Writes one line on stderr. If stderr cannot be written, the line is lost and nothing else changes.
void say(std::string_view line) noexcept;

}  // namespace stoss::cli
