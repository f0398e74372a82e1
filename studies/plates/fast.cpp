// Fast impacts on plates of the ball's material next to independent finite elements with a meshed ball and plate.
#include <fmt/os.h>

#include <cmath>
#include <limits>

#include "study.hpp"

namespace study {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// 1 − ε² by finite elements, its error in the last digit; 0 where there is none.
struct Case {
  bool rigid;
  double thickness, speed, elements, elements_error;
};

const std::vector<Case> cases{
    {false, 0.5, 0.1, 0.9999073, 5.0e-6},
    {false, 1.0, 0.1, 0.9418195, 6.3e-6},
    {false, 1.5, 0.1, 0.0, 0.0},
    {false, 2.0, 0.1, 0.5572454, 1.2e-5},
    {false, 3.0, 0.1, 0.0, 0.0},
    {false, 4.0, 0.1, 0.3114130, 1.3e-5},
    {false, 6.0, 0.1, 0.0, 0.0},
    {false, infinity, 0.1, 0.3030738, 1.1e-5},
    {false, 1.0, 0.03, 0.8499497, 4.0e-6},
    {false, 2.0, 0.03, 0.4256670, 5.7e-6},
    {false, 4.0, 0.03, 0.1814369, 4.3e-6},
    {false, 1.0, 0.01, 0.7530522, 5.1e-6},
    {false, 2.0, 0.01, 0.3299824, 2.8e-6},
    {false, infinity, 0.01, 0.0786874, 2.2e-6},
    {false, 1.0, 0.001, 0.5531743, 5.7e-6},
    {false, 2.0, 0.3, 0.6842864, 5.1e-5},
    {true, 1.0, 0.1, 0.9774776, 1.2e-5},
    {true, 2.0, 0.1, 0.6685574, 2.0e-5},
    {true, 4.0, 0.1, 0.4442136, 1.4e-5},
    {true, infinity, 0.1, 0.4420061, 2.9e-5},
};

}  // namespace

void write_fast(const std::string& name) {
  auto out = fmt::output_file(name);
  out.print(
      "# A ball on a plate of its own material, nu = 0.3, elastic or rigid; thickness inf: a block; elements: "
      "independent finite elements; made by `make results`.\n");
  out.print(
      "ball,thickness[R],speed[c],restitution,lost_fraction,lost_fraction_error,lost_to_ball,contact_time[R/"
      "c],contacts,"
      "elements,elements_error,zener_lost_fraction,converged\n");
  for (const Case& each : cases) {
    const Pair pair{.rigid = each.rigid};
    const bool block = std::isinf(each.thickness);
    const stoss::Restitution r =
        (block ? on_block(pair, {each.speed}) : on_plate(pair, each.thickness, {each.speed})).front();
    const double thin = block ? 1.0 : zener(pair, each.thickness, each.speed).restitution;
    const std::string elements =
        each.elements > 0.0 ? fmt::format("{:.7g},{:.1e}", each.elements, each.elements_error) : ",";
    out.print("{},{},{},{:.7g},{:.7g},{:.1e},{:.3g},{:.6g},{},{},{:.6g},{}\n", each.rigid ? "rigid" : "elastic",
              each.thickness, each.speed, r.restitution.value, r.lost_fraction.value, r.lost_fraction.error,
              r.lost_to_first, r.contact_time.value, r.finest.contacts, elements, 1.0 - thin * thin, r.converged);
  }
}

}  // namespace study
