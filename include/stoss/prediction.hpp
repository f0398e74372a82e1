#pragma once

// What a drop test of real balls shows: everything in include/stoss/prediction/ but the quantities.

#include "stoss/prediction/prediction.hpp"
