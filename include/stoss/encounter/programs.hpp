#pragma once

#include <string>
#include <vector>

#include "stoss/cxx20.hpp"

namespace stoss {

/// A force law or rule whose constants are fitted to elasticity, as faces name and explain it.
struct FittedLaw {
  std::string name, what;
};

/// All laws that `stoss fit` knows. The Python package has their equations.
[[nodiscard]] const std::vector<FittedLaw>& fitted_laws();

/// A program for which `stoss fit` writes a law: the laws that it has, what is written, and how far that was tried.
struct FittedProgram {
  std::string name, title;
  std::vector<std::string> laws;
  std::string writes, tried;
};

/// All programs. The Python package writes their lines.
[[nodiscard]] const std::vector<FittedProgram>& fitted_programs();

}  // namespace stoss
