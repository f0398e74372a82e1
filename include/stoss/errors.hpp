#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "stoss/cxx20.hpp"

namespace stoss {

/// An input that is refused. what() is one line, of one of three templates; its parts can be read one by one.
///
///     out_of_range   name: got …, allowed … (hint)
///     missing        name: missing, what is needed (hint)
///     conflict       name: why it does not go with the rest (hint)
class InvalidInput : public std::invalid_argument {
 public:
  enum class Kind { out_of_range, missing, conflict };

  [[nodiscard]] static InvalidInput out_of_range(std::string name, std::string got, std::string allowed,
                                                 std::string hint = {});
  [[nodiscard]] static InvalidInput missing(std::string name, std::string needed, std::string hint = {});
  [[nodiscard]] static InvalidInput conflict(std::string name, std::string reason, std::string hint = {});

  /// The same refusal of a part of something, whose name comes first: "against" of "radius" is "against radius".
  [[nodiscard]] InvalidInput within(std::string_view whole) const;

  /// The same refusal, whose hint is followed by another value of this input: rigid, "against rigid", against.
  [[nodiscard]] InvalidInput with_way(std::string_view input) const;

  [[nodiscard]] Kind kind() const noexcept;
  /// The input as its caller has it: an argument, an option, a key; after "against" where it is of the second body.
  [[nodiscard]] const std::string& name() const noexcept;
  /// What was given; empty where something is missing or does not go together.
  [[nodiscard]] const std::string& got() const noexcept;
  /// The range or the words that are allowed, what is needed, or why it does not go together.
  [[nodiscard]] const std::string& allowed() const noexcept;
  [[nodiscard]] const std::string& hint() const noexcept;
  /// The input by another value of which the hint is followed; empty where it is that of name(), or none.
  [[nodiscard]] const std::string& way() const noexcept;

 private:
  struct Parts;
  explicit InvalidInput(std::shared_ptr<const Parts> parts);

  std::shared_ptr<const Parts> parts_;  // shared, so that a copy of the exception cannot throw
};

/// A computation that could not meet its own conditions. what() is one line: what failed (hint).
class NotConverged : public std::runtime_error {
 public:
  /// @param input another value of which may help, as in step; empty if none @param hint how
  explicit NotConverged(const std::string& failure, const std::string& input = {}, const std::string& hint = {});

  /// What failed, without the hint.
  [[nodiscard]] const std::string& failure() const noexcept;
  [[nodiscard]] const std::string& input() const noexcept;
  [[nodiscard]] const std::string& hint() const noexcept;

 private:
  struct Parts;

  std::shared_ptr<const Parts> parts_;
};

}  // namespace stoss
