// The field inside a plate: each wave obeys Newton and leaves both faces free.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/plate/field.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"
#include "support/field_tools.hpp"

namespace stoss::bodies::plate {
namespace {

ContactPoints rings(std::size_t count, double half_width) {
  return {1.0, std::asin(half_width) / static_cast<double>(count), count};
}

/// A plate, or the strip of its first layer.
struct FieldPlate {
  const char* name;
  Plate plate;
  bool strip = false;

  [[nodiscard]] Strip as_strip() const { return {plate.thickness, plate.poisson, plate.young, plate.density}; }
  [[nodiscard]] Body body(double cutoff, double duration) const {
    return strip ? stoss::strip(as_strip(), cutoff, duration) : stoss::plate(plate, cutoff, duration);
  }
  [[nodiscard]] PlateField field(const Body& body, const ContactPoints& contact, PlaneGrid points) const {
    return strip ? PlateField(as_strip(), body, contact, std::move(points))
                 : PlateField(plate, body, contact, std::move(points));
  }
};

void PrintTo(const FieldPlate& its, std::ostream* out) { *out << its.name; }

/// λ and μ of a layer.
struct Moduli {
  double lambda, mu, density;

  Moduli(const Layer& its, bool plane)
      : lambda(its.young * its.poisson / ((1.0 + its.poisson) * (plane ? 1.0 - its.poisson : 1.0 - 2.0 * its.poisson))),
        mu(0.5 * its.young / (1.0 + its.poisson)),
        density(its.density) {}
};

class FieldInPlate : public testing::TestWithParam<FieldPlate> {
 protected:
  const FieldPlate its = GetParam();
  const Body body = its.body(5.0, 6.0);
  const ContactPoints contact = rings(24, 0.3);
  const std::vector<double> no_force = std::vector<double>(contact.count, 0.0);

  [[nodiscard]] std::vector<Layer> layers() const {
    std::vector<Layer> all{{its.plate.thickness, its.plate.poisson, its.plate.young, its.plate.density}};
    all.insert(all.end(), its.plate.below.begin(), its.plate.below.end());
    return all;
  }
};

TEST_P(FieldInPlate, EachWaveObeysNewton) {
  // (λ + 2μ) grad div u − μ rot rot u = −ρω² u, in the middle of every layer
  constexpr double r = 0.7, across = 0.01;
  const double round = its.strip ? 0.0 : 1.0 / r;
  double face = 0.0;
  for (const Layer& layer : layers()) {
    const Moduli of(layer, its.strip);
    const double thickness = std::min(layer.thickness, 1.0), z = face + 0.4 * thickness, deep = 0.01 * thickness;
    face += layer.thickness;
    const PlateField field = its.field(body, contact, {test::stencil(r, across), test::stencil(z, deep)});
    const double whole = of.lambda + 2.0 * of.mu;
    std::size_t k = 0;
    for (const ModeGroup& group : body.groups) {
      for (const double omega : group.omega) {
        if (k++ % 7 != 0) continue;
        const Field at = field.at(test::only(body, k - 1), no_force);
        const test::Derivatives u(at.lateral, across, deep), w(at.normal, across, deep);
        const double gradient_r = u.rr + (u.r - u.value * round) * round + w.rz;
        const double gradient_z = u.rz + u.z * round + w.zz;
        const double rotation_r = w.rz - u.zz, rotation_z = u.rz - w.rr + (u.z - w.r) * round;
        double size = 0.0;
        for (std::size_t i = 0; i < 81; ++i) size = std::max({size, std::abs(at.lateral[i]), std::abs(at.normal[i])});
        // Second differences of rounding.
        const double noise = 1e-13 / (deep * deep) + 1e-7 * (omega * omega + group.wave_number * group.wave_number);
        const double inertia = of.density * omega * omega;
        EXPECT_NEAR(whole * gradient_r - of.mu * rotation_r + inertia * u.value, 0.0, noise * whole * size) << omega;
        EXPECT_NEAR(whole * gradient_z - of.mu * rotation_z + inertia * w.value, 0.0, noise * whole * size) << omega;
      }
    }
  }
}

TEST_P(FieldInPlate, EachWaveLeavesTheFacesFreeAndMovesTheUpperOneAsTheModes) {
  constexpr double r = 0.6, across = 0.01;
  double thickness = 0.0;
  for (const Layer& layer : layers()) thickness += layer.thickness;
  for (const bool lower : {false, true}) {
    const bool deep = its.plate.thickness > 10.0 || std::isinf(thickness);  // without a lower face
    if (lower && deep) continue;
    const Layer layer = lower ? layers().back() : layers().front();
    const Moduli of(layer, its.strip);
    const double step = 0.005 * std::min(1.0, layer.thickness);
    std::vector<double> depth;  // Taylor's series from one side
    for (int i = 0; i < 7; ++i) depth.push_back(lower ? thickness - i * step : i * step);
    const double down = lower ? -step : step;
    const PlateField field = its.field(body, contact, {test::stencil(r, across), depth});
    std::size_t k = 0;
    for (const ModeGroup& group : body.groups) {
      for (std::size_t l = 0; l < group.omega.size(); ++l) {
        if (k++ % 5 != 0) continue;
        const Field at = field.at(test::only(body, k - 1), no_force);
        double u_z = 0.0, w_z = 0.0, size = 0.0;
        for (std::size_t i = 0; i < 7; ++i) {
          u_z += test::one_sided_weights[i] * at.lateral[9 * i + 4] / down;
          w_z += test::one_sided_weights[i] * at.normal[9 * i + 4] / down;
        }
        for (std::size_t i = 0; i < 63; ++i) size = std::max({size, std::abs(at.lateral[i]), std::abs(at.normal[i])});
        const double u_r = test::derivative(at.lateral, 0, 1, across), w_r = test::derivative(at.normal, 0, 1, across);
        const double hoop = its.strip ? 0.0 : at.lateral[4] / r;
        // Those of a deep block can be so close to each other that they are told apart to few digits.
        const double digits = std::isinf(thickness) ? 1e-2 : 1e-7;
        const double bound = size * (1e-13 / step + digits * (1.0 + group.wave_number));
        EXPECT_NEAR(u_z + w_r, 0.0, bound) << group.omega[l] << ' ' << group.wave_number << ' ' << lower;
        EXPECT_NEAR((of.lambda + 2.0 * of.mu) * w_z + of.lambda * (u_r + hoop), 0.0, of.mu * 10.0 * bound)
            << group.omega[l] << ' ' << group.wave_number << ' ' << lower;
        if (lower) continue;
        const double phase = group.wave_number * r;
        const double surface = -group.upper[l] * (its.strip ? std::cos(phase) : std::cyl_bessel_j(0.0, phase));
        EXPECT_NEAR(at.normal[4], surface, 1e-12 * group.upper[l]);
      }
    }
  }
}

TEST_P(FieldInPlate, SurfaceGivesWayAsTheBodySays) {
  test::expect_surface_gives_way(body, contact, [&](const auto& distance, const auto& coordinate, const auto& force) {
    return its.field(body, contact, {distance, {0.0}}).at(coordinate, force);
  });
}

constexpr double infinity = std::numeric_limits<double>::infinity();

INSTANTIATE_TEST_SUITE_P(
    Plate, FieldInPlate,
    testing::Values(FieldPlate{"thin", {.thickness = 0.05, .poisson = 0.3}},
                    FieldPlate{"half", {.thickness = 0.5, .poisson = 0.25}},
                    FieldPlate{"thick", {.thickness = 2.0, .poisson = -0.5}},
                    FieldPlate{"strip", {.thickness = 0.4, .poisson = 0.33}, true},
                    FieldPlate{"without_end", {.thickness = 20.0, .poisson = 0.3}},
                    FieldPlate{"laminated",
                               {.thickness = 0.2,
                                .poisson = 0.23,
                                .below = {{.thickness = 0.05, .poisson = 0.45, .young = 0.01, .density = 0.4},
                                          {.thickness = 0.3, .poisson = 0.23}}}},
                    FieldPlate{"coated",
                               {.thickness = 0.1,
                                .poisson = 0.3,
                                .below = {{.thickness = infinity, .poisson = 0.2, .young = 0.3, .density = 0.5}}}}),
    [](const auto& its) { return std::string(its.param.name); });

TEST(PlateField, RefusesWhatItCannotBe) {
  const Plate plate{.thickness = 0.5, .poisson = 0.3};
  const Body body = stoss::plate(plate, 4.0, 2.0);
  const ContactPoints contact = rings(4, 0.1);
  EXPECT_THROW(PlateField(Plate{.thickness = 0.4, .poisson = 0.3}, body, contact, {{0.0}, {0.0}}), InvalidInput);
  EXPECT_THROW(PlateField(plate, sphere(Sphere{.poisson = 0.3}, 8.0), contact, {{0.0}, {0.0}}), InvalidInput);
  EXPECT_THROW(PlateField(plate, body, contact, {{0.0}, {0.51}}), InvalidInput);
  EXPECT_THROW(PlateField(plate, body, contact, {{-1.0}, {0.0}}), InvalidInput);
  EXPECT_THROW(PlateField(plate, body, contact, {{}, {0.0}}), InvalidInput);
  const PlateField field(plate, body, contact, {{0.0}, {0.0}});
  EXPECT_THROW((void)field.at(std::vector<double>(mode_count(body) - 1), std::vector<double>(4)), InvalidInput);
  EXPECT_THROW((void)field.at(std::vector<double>(mode_count(body)), std::vector<double>(3)), InvalidInput);
}

}  // namespace
}  // namespace stoss::bodies::plate
