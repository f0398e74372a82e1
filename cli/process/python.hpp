#pragma once

#include <string>
#include <vector>

namespace stoss::cli {

/// Becomes Python with these words for the package's command of the same name: the package has the store of sweeps.
/// Complains of a package of another version, which would compute other values.
/// @throws OutputError if there is no Python
[[noreturn]] void become_python(const std::vector<std::string>& words);

}  // namespace stoss::cli
