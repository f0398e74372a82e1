#include "alive.hpp"

#include <emscripten.h>

namespace {

EM_JS(void, call_alive, (), {
  if (Module["alive"]) Module["alive"]();
});

}  // namespace

namespace stoss::web {

void say_alive() {
  constexpr double pause = 250.0;  // ms
  static double last = 0.0;
  const double now = emscripten_get_now();
  if (now - last < pause) return;
  last = now;
  call_alive();
}

}  // namespace stoss::web
