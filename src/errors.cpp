#include "stoss/errors.hpp"

#include <utility>

namespace stoss {

struct InvalidInput::Parts {
  Kind kind;
  std::string name, got, allowed, hint, way{};

  [[nodiscard]] std::string line() const {
    std::string text = name + ": ";
    if (kind == Kind::out_of_range) text += "got " + got + ", allowed ";
    if (kind == Kind::missing) text += allowed.empty() ? "missing" : "missing, ";
    text += allowed;
    return hint.empty() ? text : text + " (" + hint + ")";
  }
};

InvalidInput::InvalidInput(std::shared_ptr<const Parts> parts)
    : std::invalid_argument(parts->line()), parts_(std::move(parts)) {}

InvalidInput InvalidInput::out_of_range(std::string name, std::string got, std::string allowed, std::string hint) {
  return InvalidInput(std::make_shared<const Parts>(
      Parts{Kind::out_of_range, std::move(name), std::move(got), std::move(allowed), std::move(hint)}));
}

InvalidInput InvalidInput::missing(std::string name, std::string needed, std::string hint) {
  return InvalidInput(
      std::make_shared<const Parts>(Parts{Kind::missing, std::move(name), {}, std::move(needed), std::move(hint)}));
}

InvalidInput InvalidInput::conflict(std::string name, std::string reason, std::string hint) {
  return InvalidInput(
      std::make_shared<const Parts>(Parts{Kind::conflict, std::move(name), {}, std::move(reason), std::move(hint)}));
}

InvalidInput InvalidInput::within(std::string_view whole) const {
  Parts parts = *parts_;
  parts.name = std::string(whole) + " " + parts.name;
  return InvalidInput(std::make_shared<const Parts>(std::move(parts)));
}

InvalidInput InvalidInput::with_way(std::string_view input) const {
  Parts parts = *parts_;
  parts.way = input;
  return InvalidInput(std::make_shared<const Parts>(std::move(parts)));
}

InvalidInput::Kind InvalidInput::kind() const noexcept { return parts_->kind; }
const std::string& InvalidInput::name() const noexcept { return parts_->name; }
const std::string& InvalidInput::got() const noexcept { return parts_->got; }
const std::string& InvalidInput::allowed() const noexcept { return parts_->allowed; }
const std::string& InvalidInput::hint() const noexcept { return parts_->hint; }
const std::string& InvalidInput::way() const noexcept { return parts_->way; }

struct NotConverged::Parts {
  std::string failure, input, hint;
};

NotConverged::NotConverged(const std::string& failure, const std::string& input, const std::string& hint)
    : std::runtime_error(hint.empty() ? failure : failure + " (" + hint + ")"),
      parts_(std::make_shared<const Parts>(Parts{failure, input, hint})) {}

const std::string& NotConverged::failure() const noexcept { return parts_->failure; }
const std::string& NotConverged::input() const noexcept { return parts_->input; }
const std::string& NotConverged::hint() const noexcept { return parts_->hint; }

}  // namespace stoss
