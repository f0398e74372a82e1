#pragma once

// Ensembles of vibrating bodies: everything in include/stoss/vibration/.

#include "stoss/vibration/distribution.hpp"
#include "stoss/vibration/ensemble.hpp"
#include "stoss/vibration/bounce.hpp"
