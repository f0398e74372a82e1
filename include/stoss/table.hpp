#pragma once

// ε as a function of the speed and of the ratio of radii, and the whole collision rule: everything in
// include/stoss/table/.

#include "stoss/table/adaptive.hpp"
#include "stoss/table/adaptive_pairs.hpp"
#include "stoss/table/adaptive_rule.hpp"
#include "stoss/table/c_source.hpp"
#include "stoss/table/collide.hpp"
#include "stoss/table/mixture.hpp"
#include "stoss/table/pair_table.hpp"
#include "stoss/table/restitution_function.hpp"
#include "stoss/table/rule_table.hpp"
#include "stoss/table/slow_law.hpp"
#include "stoss/table/table_values.hpp"
#include "stoss/table/two_column.hpp"
