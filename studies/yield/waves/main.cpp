// A sphere meets a block, with waves and plastic flow, by explicit finite elements:
//   stoss_yield_waves POISSON BALL BLOCK SPEED ELEMENTS SIDE SIZE PART
// The arguments are those of Meeting; a strength of inf is that of an elastic body. Writes a line of waves.csv.
#include <fmt/core.h>

#include <cstdlib>
#include <exception>

#include "collision.hpp"

int main(int count, char** words) {
  if (count != 9) {
    fmt::print(stderr,
               "stoss_yield_waves: got {} arguments, allowed 8: POISSON BALL BLOCK SPEED ELEMENTS SIDE SIZE PART\n",
               count - 1);
    return 2;
  }
  try {
    const auto number = [&](int k) { return std::atof(words[k]); };
    const yield_study::Meeting of{number(1),           number(2), number(3), number(4),
                                  std::atoi(words[5]), number(6), number(7), number(8)};
    const yield_study::Outcome its = yield_study::collide(of);
    fmt::print("{:g},{:.6g},{:.6g},{:.8g},{},{:g},{:g},{:g},", of.poisson, of.of_ball, of.of_block, of.speed,
               of.elements, of.side, of.size, of.part);
    fmt::print("{},{:.3g},{:.5f},{:.5g},{:.3f},{:.5g},{:.5g},{:.3g},{:.5f},{:.5f},{:.2g},{:.2g},{:.1g}\n", its.unknowns,
               its.step, its.restitution, its.force, its.time, its.deepest, its.dent, its.radius, its.flow_ball,
               its.flow_block, its.ball, its.block, its.imbalance);
  } catch (const std::exception& error) {
    fmt::print(stderr, "stoss_yield_waves: {}\n", error.what());
    return 1;
  }
}
