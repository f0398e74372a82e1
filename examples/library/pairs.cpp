// ε of two bodies, in units of the first: v is their speed of approach in c of the first.
#include <cstdio>
#include <stoss/bodies/disk.hpp>
#include <stoss/bodies/half_space.hpp>
#include <stoss/bodies/sphere.hpp>
#include <stoss/restitution.hpp>
#include <stoss/table.hpp>

using namespace stoss;

int main() {
  const RefinableContact disks(disk(0.33), disk(Disk{.poisson = 0.33, .radius = 2.0}));
  std::printf("disk on one of twice its radius: %.5f\n", restitution(disks, 0.1).restitution.value);

  // Glass in units of bearing steel: modulus 7e10/2.1e11, density 2500/7810; 1 m/s, yielding begins at 2.2 m/s.
  const RefinableContact drop(sphere(0.3), half_space(HalfSpace{.poisson = 0.22, .young = 0.3333, .density = 0.3201}));
  std::printf("ball of bearing steel on glass, elastic: %.5f\n", restitution(drop, 2e-4).restitution.value);

  // Any two disks of one material, to 0.01: speeds from 0.01 to 0.1 c, radii up to 2 : 1.
  const PairTable table = pair_table(mixture(Disk{.poisson = 0.33}), 0.01, 0.1, 1.0, 2.0, {.error = 0.01});
  std::printf("radii 1.5 : 1 at 0.05 c: %.3f ± %.3f\n", table.value(0.05, 1.5), table(0.05, 1.5).error);
}
