#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "table/language.hpp"

namespace stoss::table {

/// A number as C, Rust and JavaScript read it back, of type double: 1.0, not 1.
[[nodiscard]] std::string c_number(double value);

/// Each of several numbers.
[[nodiscard]] std::vector<std::string> c_numbers(const std::vector<double>& values);
[[nodiscard]] std::vector<std::string> c_numbers(const std::vector<std::size_t>& values);

/// An error as text, to two digits, rounded up.
[[nodiscard]] std::string at_most(double error);

/// A constant array, with a line of comment above. Its cells fill lines. @param type of a cell
[[nodiscard]] std::string c_array(const Language& language, std::string_view type, const std::string& name,
                                  const std::string& comment, const std::vector<std::string>& cells);

/// A comment of several lines, from which no text can break out.
[[nodiscard]] std::string c_comment(const std::vector<std::string>& lines, const Language& language);

/// @throws InvalidInput unless names may begin with it
void require_c_name(const std::string& name);

/// A text with each of the places @…@ filled; of @name@ and @NAME@ from `name` in lower and in upper case.
[[nodiscard]] std::string filled(std::string text, const std::string& name,
                                 const std::vector<std::pair<std::string, std::string>>& fillings = {});

/// A file: comment, and the body within what a file of the language begins and ends with.
[[nodiscard]] std::string c_file(const std::string& name, const std::vector<std::string>& comment,
                                 const std::string& body, const Language& language);

}  // namespace stoss::table
