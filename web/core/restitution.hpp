#pragma once

#include <emscripten/val.h>

#include <string>
#include <vector>

#include "encounter.hpp"

namespace stoss::web {

/// ε at one speed: Restitution of the protocol.
[[nodiscard]] emscripten::val restitution(const Meeting& meeting, double speed, double tolerance);

/// ε at each of the speeds: calls deliver(CurvePoint, index).
void curve(const Meeting& meeting, const std::vector<double>& speeds, double tolerance, const emscripten::val& deliver);

/// The header in C of ε between two speeds, as `stoss table --format c` writes it but for its provenance.
[[nodiscard]] std::string header(const Meeting& meeting, double slowest, double fastest, double error);

}  // namespace stoss::web
