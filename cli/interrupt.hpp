#pragma once

namespace stoss::cli {

/// Thrown to leave a computation after Ctrl-C; the command then exits with 130.
struct Interrupted {};

/// From now on Ctrl-C is noted instead of ending the program; a second one ends it.
void catch_interrupts();

[[nodiscard]] bool interrupted();

}  // namespace stoss::cli
