// ε of a disk with ν = 0.33 that meets a rigid wall at v = 0.1 c.
#include <cstdio>
#include <stoss/bodies/disk.hpp>
#include <stoss/restitution.hpp>

int main() {
  const stoss::Restitution r = stoss::restitution(stoss::disk(0.33), 0.1);
  std::printf("%.5f ± %.5f\n", r.restitution.value, r.restitution.error);
}
