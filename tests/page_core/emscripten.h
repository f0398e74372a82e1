#pragma once

/// Stands for Emscripten's header where the core of the page is compiled for this machine.
inline double emscripten_get_now() { return 0.0; }
