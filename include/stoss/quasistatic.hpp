#pragma once

// Slow contacts: everything in include/stoss/quasistatic/ but the point contacts of spheres (point_*.hpp,
// half_space_radiation.hpp), whose functions overload those here: with both, an address such as &compression needs a
// cast.

#include "stoss/quasistatic/compression.hpp"
#include "stoss/quasistatic/heavy_disk.hpp"
#include "stoss/quasistatic/hertz.hpp"
#include "stoss/quasistatic/lossy_impact.hpp"
#include "stoss/quasistatic/rayleigh.hpp"
#include "stoss/quasistatic/slow_impact.hpp"
#include "stoss/quasistatic/soft_static_contact.hpp"
#include "stoss/quasistatic/static_contact.hpp"
