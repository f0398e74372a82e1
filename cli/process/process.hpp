#pragma once

#include <string>
#include <vector>

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

}  // namespace stoss::cli
