// A ball of bearing steel of 5 mm radius on laminated glass beside glass of one piece, and on coated steel, at
// 0.2 m/s: on a block of tungsten carbide it yields from 0.235 m/s. Of these only aluminium yields.
#include <fmt/os.h>

#include <cmath>
#include <limits>

#include "stoss/encounter/materials.hpp"
#include "study.hpp"

namespace study {
namespace {

constexpr double radius = 5e-3, speed = 0.2;

/// A layer in units of the ball.
stoss::Layer layer(const char* name, double thickness) {
  const stoss::Material &its = stoss::named_material(name), &ball = stoss::named_material("bearing steel");
  return {thickness / radius, its.poisson, its.young / ball.young, its.density / ball.density};
}

stoss::Plate plate(const std::vector<stoss::Layer>& layers) {
  stoss::Plate all{layers[0].thickness, layers[0].poisson, layers[0].young, layers[0].density};
  all.below.assign(layers.begin() + 1, layers.end());
  return all;
}

/// @param top material of the first of the layers
void print(fmt::ostream& out, const std::string& what, const char* top, double sheet, double other,
           const std::vector<stoss::Layer>& layers) {
  const stoss::Material& ball = stoss::named_material("bearing steel");
  const double c = std::sqrt(ball.young / ball.density);
  const stoss::Restitution r = on_layers({.ball_poisson = ball.poisson}, plate(layers), {speed / c}).front();
  out.print("{},{:.5g},{:.5g},{:.7g},{:.7g},{:.1e},{:.6g},{:.6g},{},{}\n", what, 1e3 * sheet, 1e3 * other,
            r.restitution.value, r.lost_fraction.value, r.lost_fraction.error, r.contact_time.value * radius / c * 1e6,
            r.impulse_time.value * radius / c * 1e6, r.converged,
            yield_speed(ball, radius, stoss::named_material(top)));
}

}  // namespace

void write_layers(const std::string& name) {
  auto out = fmt::output_file(name);
  out.print(
      "# A steel ball of {} m radius at {} m/s, elastic; yield_speed: of the ball on a block of the first layer; made "
      "by `make "
      "results`.\n",
      radius, speed);
  out.print(
      "what,sheet[mm],other[mm],restitution,lost_fraction,lost_fraction_error,contact_time[us],impulse_time[us],"
      "converged,yield_speed[m/s]\n");
  for (const double sheet : series(2e-3, 32e-3, 13)) {
    print(out, "one sheet", "glass", sheet, 0.0, {layer("glass", sheet)});
    print(out, "two sheets in one", "glass", sheet, 0.0, {layer("glass", 2.0 * sheet)});
    for (const double between : {0.38e-3, 1.52e-3}) {
      print(out, "laminated", "glass", sheet, between,
            {layer("glass", sheet), layer("PVB", between), layer("glass", sheet)});
    }
  }
  for (const double sheet : {0.01, 0.04}) {
    print(out, "bare steel", "bearing steel", sheet, 0.0, {layer("bearing steel", sheet)});
    for (const char* coat : {"tungsten carbide", "aluminium", "PMMA"}) {
      for (const double thickness : series(1e-4, 2e-3, 9)) {
        print(out, coat, coat, sheet, thickness, {layer(coat, thickness), layer("bearing steel", sheet)});
      }
    }
  }
  print(out, "bare steel", "bearing steel", std::numeric_limits<double>::infinity(), 0.0,
        {layer("bearing steel", 1e-2), layer("bearing steel", std::numeric_limits<double>::infinity())});
}

}  // namespace study
