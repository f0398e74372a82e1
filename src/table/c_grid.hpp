#pragma once

#include <string>
#include <vector>

#include "stoss/table/c_source.hpp"
#include "table/language.hpp"

namespace stoss::table {

/// A table as a header in C, or a module of another language, has it.
struct CGrid {
  std::string name;  ///< of its arrays
  const TableValues& values;
  const std::vector<double>& nodes;
  const std::vector<double>& errors;
};

/// Arrays of grids, and the function name_look_up(x, z, p, found) that sets the value of each and its error, in turn,
/// at x = ln(speed), the slip z and p = (ratio − 1)/(ratio + 1), all within the grids but for rounding.
/// @param scale speed of the header over that of the grids
[[nodiscard]] std::string c_look_up(const std::vector<CGrid>& grids, double scale, const Language& language);

/// Functions that return one of the numbers each that name_at sets. @param arguments of name_at but the last, which
/// are numbers
[[nodiscard]] std::string c_numbers_of(const std::vector<std::string>& arguments, const std::vector<std::string>& names,
                                       const Language& language);

/// Of the range of a table: the place p of a ratio, whether it lies inside, and lines that take the nearest speed
/// and place within.
struct CRange {
  std::string place, inside{}, nearest;

  /// @param ratios of a table; of one alone nothing depends on it
  CRange(const std::vector<double>& ratios, bool alike, const Language& language);

 private:
  void add_ratios(const std::vector<double>& ratios, bool alike);
};

/// Constants of the range of a table. @param ratios one if they do not count
[[nodiscard]] std::string c_limits(const std::vector<double>& speeds, const std::vector<double>& ratios, double scale,
                                   const Language& language);

/// A comment whose places are filled, then the provenance.
[[nodiscard]] std::vector<std::string> c_description(std::vector<std::string> lines, const std::string& name,
                                                     const TableLabel& label, const Language& language);

}  // namespace stoss::table
