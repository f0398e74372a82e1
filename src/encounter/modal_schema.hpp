#pragma once

#include "encounter/json_values.hpp"

namespace stoss::json {

/// JSON schema of the file of a body by its modes at a point (modal_file.hpp).
[[nodiscard]] Json schema_of_modal_body();

}  // namespace stoss::json
