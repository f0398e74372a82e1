#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace stoss::table {

/// A number as C reads it back, of type double: 1.0, not 1.
[[nodiscard]] std::string c_number(double value);

/// Each of several numbers.
[[nodiscard]] std::vector<std::string> c_numbers(const std::vector<double>& values);
[[nodiscard]] std::vector<std::string> c_numbers(const std::vector<std::size_t>& values);

/// An error as text, to two digits, rounded up.
[[nodiscard]] std::string at_most(double error);

/// A static array, with a line of comment above. Its cells fill lines. @param type as in double
[[nodiscard]] std::string c_array(const std::string& type, const std::string& name, const std::string& comment,
                                  const std::vector<std::string>& cells);

/// A comment of several lines, from which no text can break out.
[[nodiscard]] std::string c_comment(const std::vector<std::string>& lines);

/// @throws InvalidInput unless names in C may begin with it
void require_c_name(const std::string& name);

/// A text with each of the places @…@ filled; of @name@ and @NAME@ from `name` in lower and in upper case.
[[nodiscard]] std::string filled(std::string text, const std::string& name,
                                 const std::vector<std::pair<std::string, std::string>>& fillings = {});

/// A header: comment, include guard, <math.h>, and between them, for the body, the macros @NAME@_FUNCTION (how a
/// function begins that may stay unused) and @NAME@_INDEX (a double as int), of which nothing remains.
[[nodiscard]] std::string c_file(const std::string& name, const std::vector<std::string>& comment,
                                 const std::string& body);

}  // namespace stoss::table
