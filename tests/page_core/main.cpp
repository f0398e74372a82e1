// The core of the page for this machine, for tests of the page without Emscripten (stoss.mjs).
#include <emscripten/bind.h>

#include <iostream>

/// One line of JSON for each question that it has; or, with the name of one, its answer to what is given on stdin: a
/// line for each that it delivers, and the last with what it returns.
int main(int count, char** words) {
  using emscripten::val;
  if (count < 2) {
    for (const auto& [name, answer] : emscripten::questions()) std::cout << name << '\n';
    return 0;
  }
  const auto given = nlohmann::json::parse(std::cin);
  const val deliver(val::Function([](const val& each, const val& index) {
    std::cout << nlohmann::json{{"each", each.json()}, {"index", index.json()}} << '\n';
  }));
  std::cout << emscripten::questions().at(words[1])(val::from(given), deliver).json() << '\n';
}
