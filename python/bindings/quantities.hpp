#pragma once

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "stoss/quantity.hpp"

namespace stoss::python {

/// The quantities of one result as a dict, errors as name_error.
template <typename Result>
pybind11::dict to_dict(const Quantities<Result>& quantities, const Result& result) {
  pybind11::dict dict;
  for (const auto& [name, dimension, value, error] : quantities) {
    dict[pybind11::str(name)] = value(result);
    if (error) dict[pybind11::str(name + "_error")] = error(result);
  }
  return dict;
}

/// The numbers and flags of several results, as a structured array has them: one after the other, eight bytes for each,
/// errors after their values. Filled without the interpreter.
template <typename Result>
class Rows {
 public:
  static constexpr std::size_t cell = 8;

  /// @param quantities without names
  explicit Rows(const Quantities<Result>& quantities) : quantities_(&quantities) {
    for (const auto& [name, dimension, value, error] : quantities) width_ += (error ? 2 : 1) * cell;
  }

  [[nodiscard]] std::size_t width() const { return width_; }

  /// Writes the row of a result.
  void write(const Result& result, std::byte* to) const {
    const auto put = [&to](const auto& number) {
      std::memcpy(to, &number, sizeof(number));
      to += cell;
    };
    for (const auto& [name, dimension, value, error] : *quantities_) {
      const Value found = value(result);
      if (const auto* number = std::get_if<double>(&found)) {
        put(*number);
      } else if (const auto* whole = std::get_if<long>(&found)) {
        put(static_cast<std::int64_t>(*whole));
      } else {
        put(std::get<bool>(found));
      }
      if (error) put(error(result));
    }
  }

  /// Adds the row of a result to those that take() returns.
  void add(const Result& result) {
    made_.resize(made_.size() + width_);
    write(result, made_.data() + made_.size() - width_);
  }

  [[nodiscard]] pybind11::dtype type() const {
    pybind11::list names, formats, offsets;
    const auto field = [&](const std::string& name, const char* format) {
      offsets.append(cell * names.size());
      names.append(name);
      formats.append(format);
    };
    for (const auto& [name, dimension, value, error] : *quantities_) {
      const Value found = value(Result{});
      field(name, std::holds_alternative<double>(found) ? "f8" : std::holds_alternative<long>(found) ? "i8" : "?");
      if (error) field(name + "_error", "f8");
    }
    return {names, formats, offsets, static_cast<pybind11::ssize_t>(width_)};
  }

  /// The rows that were added as a read-only array, which takes them over.
  [[nodiscard]] pybind11::array take() {
    const auto count = static_cast<pybind11::ssize_t>(made_.size() / width_);
    auto* owned = new std::vector<std::byte>(std::move(made_));
    const pybind11::capsule owner(owned, [](void* memory) { delete static_cast<std::vector<std::byte>*>(memory); });
    pybind11::array array(type(), {count}, {static_cast<pybind11::ssize_t>(width_)}, owned->data(), owner);
    array.attr("flags").attr("writeable") = false;
    return array;
  }

 private:
  const Quantities<Result>* quantities_;
  std::size_t width_ = 0;
  std::vector<std::byte> made_;
};

}  // namespace stoss::python
