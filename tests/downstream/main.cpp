// A user's program: the installed library, its exported target, one impact.
#include <stoss/bodies/disk.hpp>
#include <stoss/bodies/disk/modes.hpp>
#include <stoss/bodies/rod.hpp>
#include <stoss/body/body.hpp>
#include <stoss/contact/wall.hpp>
#include <stoss/errors.hpp>
#include <stoss/impact/impact.hpp>
#include <stoss/material.hpp>
#include <stoss/restitution/restitution.hpp>
#include <stoss/version.hpp>

#include <cmath>
#include <cstdio>
#include <string_view>

int main() {
  const stoss::Body disk = stoss::disk(0.33, 25.0);
  const stoss::Impact impact = stoss::impact(disk, stoss::HardWall{}, 0.1);
  const std::string_view version = stoss::version();
  std::printf("stoss %.*s: %zu modes, lost fraction %.6f\n", static_cast<int>(version.size()), version.data(),
              stoss::mode_count(disk), impact.lost_fraction);
  if (version.empty() || stoss::mode_count(disk) != 295) return 1;
  if (!(std::abs(impact.lost_fraction - 0.1032) < 1.5e-4)) return 1;
  try {
    (void)stoss::impact(disk, stoss::HardWall{}, -1.0);
  } catch (const stoss::InvalidInput&) {
    return 0;
  }
  return 1;
}
