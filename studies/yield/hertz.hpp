#pragma once

namespace yield_study {

/// Where a half-space of Poisson's ratio ν begins to yield below Hertz' pressure: the maximum pressure over Y, by the
/// largest von Mises stress on the axis (Johnson, Contact Mechanics, eqs. 3.45). 1.613 at ν = 0.3.
[[nodiscard]] double onset_pressure(double poisson);

}  // namespace yield_study
