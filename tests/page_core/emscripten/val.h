#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

/// Stands for Emscripten's header where the core of the page is compiled for this machine: what web/core uses of it.
/// Objects and arrays are shared, as those of JavaScript are; values are JSON, and typed arrays and numbers that JSON
/// does not have are objects with the one member "$" (stoss.mjs).
namespace emscripten {

class val {
 public:
  using Function = std::function<void(const val& each, const val& index)>;

  val() = default;
  explicit val(bool value) : leaf_(value) {}
  explicit val(const char* value) : leaf_(value) {}
  explicit val(const std::string& value) : leaf_(value) {}
  explicit val(Function function) : function_(std::move(function)) {}
  template <typename Number>
  requires std::is_arithmetic_v<Number>
  explicit val(Number value) : leaf_(value) {
    const auto real = static_cast<double>(value);
    if (!std::isfinite(real)) leaf_ = {{"$", std::isnan(real) ? "NaN" : real > 0.0 ? "Infinity" : "-Infinity"}};
  }

  [[nodiscard]] static val undefined() { return {}; }
  [[nodiscard]] static val object() { return with(Members{}); }
  [[nodiscard]] static val array() { return with(Elements{}); }
  /// A class of typed arrays.
  [[nodiscard]] static val global(const char* name) { return val(name); }
  [[nodiscard]] static val module_property(const char*) { return {}; }
  [[nodiscard]] static val from(const nlohmann::json& json) {
    if (json.is_object() && json.contains("$")) return val(std::stod(json["$"].get<std::string>()));
    val made;
    if (json.is_object()) {
      made = object();
      for (const auto& [name, each] : json.items()) made.set(name, from(each));
    } else if (json.is_array()) {
      made = array();
      for (const auto& each : json) made.elements_->push_back(from(each));
    } else {
      made.leaf_ = json;
    }
    return made;
  }

  [[nodiscard]] bool isUndefined() const { return !members_ && !elements_ && !function_ && leaf_.is_discarded(); }
  template <typename Value>
  [[nodiscard]] Value as() const {
    if constexpr (std::is_same_v<Value, double>) {
      if (leaf_.is_object()) return std::stod(leaf_["$"].get<std::string>());
      if (leaf_.is_discarded() || leaf_.is_null()) return std::nan("");  // as JavaScript makes numbers of them
    }
    return leaf_.get<Value>();
  }
  [[nodiscard]] std::vector<double> numbers() const {
    std::vector<double> all;
    for (const val& each : *elements_) all.push_back(each.as<double>());
    return all;
  }

  val operator[](const char* name) const {
    const auto found = members_ ? members_->find(name) : Members::iterator();
    return members_ && found != members_->end() ? found->second : val();
  }
  template <typename Value>
  void set(const std::string& name, const Value& value) {
    (*members_)[name] = of(value);
  }
  template <typename>
  void call(const char*, const auto& value) const {
    elements_->push_back(of(value));
  }
  template <typename... Values>
  void operator()(const Values&... values) const {
    if constexpr (sizeof...(values) == 2) function_(of(values)...);
  }
  /// A typed array of what another one has.
  [[nodiscard]] val new_(const val& values) const {
    const std::vector<double> all = values.typed_ ? *values.typed_ : values.numbers();
    val made = object();
    made.typed_ = std::make_shared<const std::vector<double>>(all);
    made.set("$", *this);
    val list = array();
    for (const double each : all) list.elements_->push_back(val(each));
    made.set("of", list);
    return made;
  }

  [[nodiscard]] nlohmann::json json() const {
    if (elements_) {
      auto list = nlohmann::json::array();
      for (const val& each : *elements_) list.push_back(each.json());
      return list;
    }
    if (!members_) return leaf_;
    auto made = nlohmann::json::object();
    for (const auto& [name, each] : *members_) {
      if (!each.isUndefined()) made[name] = each.json();
    }
    return made;
  }

 private:
  using Members = std::map<std::string, val>;
  using Elements = std::vector<val>;

  static val with(Members members) {
    val made;
    made.members_ = std::make_shared<Members>(std::move(members));
    return made;
  }
  static val with(Elements elements) {
    val made;
    made.elements_ = std::make_shared<Elements>(std::move(elements));
    return made;
  }
  template <typename Value>
  static val of(const Value& value) {
    if constexpr (std::is_same_v<Value, val>) {
      return value;
    } else {
      return val(value);
    }
  }

  nlohmann::json leaf_ = nlohmann::json(nlohmann::json::value_t::discarded);
  std::shared_ptr<Members> members_;
  std::shared_ptr<Elements> elements_;
  std::shared_ptr<const std::vector<double>> typed_;
  Function function_;
};

/// An array of numbers.
[[nodiscard]] inline val typed_memory_view(std::size_t size, const double* values) {
  val made = val::array();
  for (std::size_t i = 0; i < size; ++i) made.call<void>("push", values[i]);
  return made;
}

template <typename>
[[nodiscard]] std::vector<double> convertJSArrayToNumberVector(const val& array) {
  return array.numbers();
}

}  // namespace emscripten
