// ε of balls of 5 mm radius on plates of four pairs of materials against the thickness, with Zener's theory and a
// block. The steel is that of bearings, and no speed is beyond that at which it yields on a block.
#include <fmt/os.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "stoss/encounter/materials.hpp"
#include "study.hpp"

namespace study {
namespace {

constexpr double radius = 5e-3;
constexpr double infinity = std::numeric_limits<double>::infinity();
const std::vector<double> speeds{0.01, 0.1, 0.5};  // m/s

}  // namespace

void write_materials(const std::string& name) {
  using Names = std::pair<const char*, const char*>;
  auto out = fmt::output_file(name);
  out.print(
      "# Balls of {} m radius on plates, elastic; thickness inf: a block; tolerance 1e-3 of 1-eps^2; yield_speed: on a "
      "block, nothing where the materials have no yield strength; made by `make results`.\n",
      radius);
  out.print(
      "ball,plate,speed[m/s],speed[c],thickness[R],thickness[m],restitution,lost_fraction,lost_fraction_error,"
      "lost_to_ball,contact_time[s],impulse_time[s],inelasticity,zener,zener_contact_time[s],deflection[h],"
      "converged,yield_speed[m/s]\n");
  for (const auto& [ball, plate] : {Names{"bearing steel", "bearing steel"}, Names{"bearing steel", "glass"},
                                    Names{"glass", "glass"}, Names{"ice", "ice"}}) {
    const stoss::Material& its = stoss::named_material(ball);
    const Pair pair = pair_of(its, stoss::named_material(plate));
    const std::string yields = yield_speed(its, radius, stoss::named_material(plate));
    const double c = std::sqrt(its.young / its.density), unit = radius / c;
    std::vector<double> own;
    for (const double speed : speeds) own.push_back(speed / c);
    std::vector<double> thicknesses = series(0.2, 100.0, 28);
    thicknesses.push_back(infinity);
    for (const double h : thicknesses) {
      const bool block = std::isinf(h);
      const std::vector<stoss::Restitution> all = block ? on_block(pair, own) : on_plate(pair, h, own);
      for (std::size_t i = 0; i < own.size(); ++i) {
        const stoss::Restitution& r = all[i];
        const Zener thin = block ? Zener{0.0, 1.0, 0.0} : zener(pair, h, own[i]);
        out.print(
            "{},{},{},{:.6g},{:.6g},{:.6g},{:.7g},{:.7g},{:.1e},{:.3e},{:.6g},{:.6g},{:.6g},{:.7g},{:.6g},{:.3g},{},{}"
            "\n",
            ball, plate, speeds[i], own[i], h, h * radius, r.restitution.value, r.lost_fraction.value,
            r.lost_fraction.error, r.lost_to_first, r.contact_time.value * unit, r.impulse_time.value * unit,
            thin.inelasticity, thin.restitution, thin.contact_time * unit,
            block ? 0.0 : deflection(pair, h, own[i], r.restitution.value), r.converged, yields);
      }
    }
  }
}

}  // namespace study
