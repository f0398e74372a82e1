#pragma once

#include <string>

namespace stoss::cli {

/// Writes a file that appears whole or not at all: its text goes into another one next to it, which then takes its
/// place. What is no regular file (stdout as "" or "-", a pipe, a device) is written directly.
/// @throws OutputError
void write_whole(const std::string& path, const std::string& text);

/// Refuses a path where no file can be written, before the work is done. @throws OutputError
void require_writable(const std::string& path);

}  // namespace stoss::cli
