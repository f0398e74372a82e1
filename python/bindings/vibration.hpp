#pragma once

#include <pybind11/numpy.h>

#include "stoss/impact/vibration.hpp"

namespace stoss::python {

/// A structured array of the type stoss._core.oscillation.
using Oscillations = pybind11::array_t<Oscillation, pybind11::array::c_style>;

/// How bodies vibrate before an impact, as the core takes it.
inline Vibration to_vibration(const Oscillations& array) { return {array.data(), array.data() + array.size()}; }

}  // namespace stoss::python
