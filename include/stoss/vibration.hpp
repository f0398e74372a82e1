#pragma once

// Ensembles of vibrating bodies, and chains of rods: everything in include/stoss/vibration/.

#include "stoss/vibration/distribution.hpp"
#include "stoss/vibration/ensemble.hpp"
#include "stoss/vibration/rod_chain.hpp"
