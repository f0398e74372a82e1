#pragma once

// Slow contacts: everything in include/stoss/quasistatic/ but the quantities. A static law says
// whether bodies touch along a line or at a point.

#include "stoss/quasistatic/compression.hpp"
#include "stoss/quasistatic/half_space_radiation.hpp"
#include "stoss/quasistatic/hertz.hpp"
#include "stoss/quasistatic/oblique/maw.hpp"
#include "stoss/quasistatic/oblique/mindlin.hpp"
#include "stoss/quasistatic/point_hertz.hpp"
#include "stoss/quasistatic/point_lossy_impact.hpp"
#include "stoss/quasistatic/rayleigh.hpp"
#include "stoss/quasistatic/relaxing_impact.hpp"
#include "stoss/quasistatic/slow_impact.hpp"
#include "stoss/quasistatic/static_contact.hpp"
#include "stoss/quasistatic/yield.hpp"
