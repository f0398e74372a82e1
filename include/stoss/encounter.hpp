#pragma once

// Who meets whom, and how it is given: everything in include/stoss/encounter/.

#include "stoss/encounter/document.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/encounter/inner_fields.hpp"
#include "stoss/encounter/inside.hpp"
#include "stoss/encounter/kinds.hpp"
#include "stoss/encounter/laws.hpp"
#include "stoss/encounter/materials.hpp"
#include "stoss/encounter/schema.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/encounter/solid.hpp"
#include "stoss/encounter/visible.hpp"
#include "stoss/encounter/waves.hpp"
