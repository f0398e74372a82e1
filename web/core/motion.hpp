#pragma once

#include "questions.hpp"
#include "stoss/encounter/collision.hpp"

namespace stoss::web {

/// The motion of a question, in units of the first body, at another angle. @throws InvalidInput for what is no motion
[[nodiscard]] ObliqueCase at_angle(const Question& asked, const Meeting& meeting, double angle);

/// At its own angle.
[[nodiscard]] ObliqueCase case_of(const Question& asked, const Meeting& meeting);

}  // namespace stoss::web
