#include "stoss/table/mixture.hpp"

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

template <typename Round>
Mixture mixed(Round first, Round second) {
  for (const Round& each : {first, second}) {
    if (each.loss_time != 0.0) {
      throw InvalidInput::out_of_range("loss_time", shown(each.loss_time), "0",
                                       "with a loss the radii themselves count, not their ratio alone");
    }
  }
  const bool alike = first.poisson == second.poisson && first.young == second.young && first.density == second.density;
  first.radius = second.radius = 1.0;
  return {.contact =
              [first, second](double ratio) {
                Round other = second;
                other.radius = ratio;
                if constexpr (requires { disk(first); }) {
                  return RefinableContact(disk(first), disk(other));
                } else {
                  return RefinableContact(sphere(first), sphere(other));
                }
              },
          .alike = alike};
}

}  // namespace

Mixture mixture(const Disk& first, const Disk& second) { return mixed(first, second); }
Mixture mixture(const Disk& disk) { return mixed(disk, disk); }
Mixture mixture(const Sphere& first, const Sphere& second) { return mixed(first, second); }
Mixture mixture(const Sphere& sphere) { return mixed(sphere, sphere); }

}  // namespace stoss
