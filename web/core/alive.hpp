#pragma once

namespace stoss::web {

/// Tells the worker, some four times a second, that a long computation goes on: calls Module.alive, where it is.
void say_alive();

}  // namespace stoss::web
