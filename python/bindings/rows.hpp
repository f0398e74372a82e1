#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "support.hpp"

namespace stoss::python {

/// The numbers and flags of several results, as a structured array has them: one after the other, eight bytes for each,
/// errors after their values. Filled without the interpreter.
template <typename Result>
class Rows {
 public:
  static constexpr std::size_t cell = 8;

  /// @param quantities without names
  explicit Rows(const Quantities<Result>& quantities) : quantities_(&quantities) {
    for (const auto& [name, dimension, help, value, error] : quantities) width_ += (error ? 2 : 1) * cell;
  }

  [[nodiscard]] std::size_t width() const { return width_; }

  /// Writes the row of a result.
  void write(const Result& result, std::byte* to) const {
    const auto put = [&to](const auto& number) {
      std::memcpy(to, &number, sizeof(number));
      to += cell;
    };
    for (const auto& [name, dimension, help, value, error] : *quantities_) {
      const Value found = value(result);
      if (const auto* number = std::get_if<double>(&found)) {
        put(*number);
      } else if (const auto* whole = std::get_if<std::int64_t>(&found)) {
        put(*whole);
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

  [[nodiscard]] py::dtype type() const {
    py::list names, formats, offsets;
    const auto field = [&](const std::string& name, const char* format) {
      offsets.append(cell * names.size());
      names.append(name);
      formats.append(format);
    };
    for (const auto& [name, dimension, help, value, error] : *quantities_) {
      const Value found = value(Result{});
      field(name, std::holds_alternative<double>(found)         ? "f8"
                  : std::holds_alternative<std::int64_t>(found) ? "i8"
                                                                : "?");
      if (error) field(name + "_error", "f8");
    }
    return {names, formats, offsets, static_cast<py::ssize_t>(width_)};
  }

  /// The rows that were added as a read-only array, which takes them over.
  [[nodiscard]] py::array take() {
    const auto count = static_cast<py::ssize_t>(made_.size() / width_);
    auto* owned = new std::vector<std::byte>(std::move(made_));
    const py::capsule owner(owned, [](void* memory) { delete static_cast<std::vector<std::byte>*>(memory); });
    py::array array(type(), {count}, {static_cast<py::ssize_t>(width_)}, owned->data(), owner);
    array.attr("flags").attr("writeable") = false;
    return array;
  }

 private:
  const Quantities<Result>* quantities_;
  std::size_t width_ = 0;
  std::vector<std::byte> made_;
};

/// Fills rows as results come, and `reasons` at the end, so that what is done is there if Ctrl-C ends them.
/// @param tick    called after each result where there is one: only then is the interpreter asked for
/// @param compute what hands its results over, one after the other, to the function that it is given
template <typename Result, typename Compute>
void fill(const Quantities<Result>& quantities, py::array& rows, py::list& reasons,
          const std::optional<py::function>& tick, const Compute& compute) {
  const Rows<Result> layout(quantities);
  const bool fits = rows.ndim() == 1 && (rows.flags() & py::array::c_style) != 0 && rows.dtype().equal(layout.type());
  if (!fits) throw std::invalid_argument("rows: one for each result");
  auto* const row = static_cast<std::byte*>(rows.mutable_data());
  std::vector<std::string> why;
  const auto put = [&](const Result& result) {
    layout.write(result, row + why.size() * layout.width());
    why.push_back(result.reason);
    if (!tick) return;
    const py::gil_scoped_acquire interpreter;
    (*tick)();
  };
  const auto hand_over = [&] {
    for (const std::string& reason : why) reasons.append(reason);
  };
  try {
    const Released released;
    compute(put);
  } catch (const py::error_already_set&) {
    hand_over();
    throw;
  }
  hand_over();
}

}  // namespace stoss::python
