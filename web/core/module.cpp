// What the worker calls: one function for every question.
#include <emscripten/bind.h>

#include <map>
#include <new>
#include <string>

#include "javascript.hpp"
#include "questions.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

/// { value } of the answer, or { error } with one line: no exception leaves for JavaScript, which cannot read those of
/// C++.
val ask(const std::string& question, const val& given, const val& deliver) {
  static const std::map<std::string, val (*)(const Question&)> answers{
      {"kinds", answer::kinds},   {"units", answer::units},   {"speed", answer::speed},
      {"number", answer::number}, {"series", answer::series}, {"restitution", answer::restitution},
      {"curve", answer::curve},   {"header", answer::header}, {"collision", answer::collision},
      {"frames", answer::frames}, {"shape", answer::shape},
  };
  std::string what;
  try {
    return object({{"value", answers.at(question)({given, deliver})}});
  } catch (const std::bad_alloc&) {
    what = "memory: the computation needs more than there is (a greater tolerance needs less)";
  } catch (const std::exception& error) {
    what = error.what();
  }
  return object({{"error", val(what)}});
}

}  // namespace

EMSCRIPTEN_BINDINGS(stoss) { emscripten::function("ask", &ask); }

}  // namespace stoss::web
