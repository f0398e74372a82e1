#pragma once

// Ensembles of vibrating bodies, sequences of impacts, and chains of rods: everything in include/stoss/vibration/.

#include "stoss/vibration/bounce.hpp"
#include "stoss/vibration/distribution.hpp"
#include "stoss/vibration/ensemble.hpp"
#include "stoss/vibration/rod_chain.hpp"
