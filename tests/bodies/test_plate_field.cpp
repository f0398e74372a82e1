// The field inside a plate: each wave obeys Newton and leaves both faces free; thin plates bend, thick ones are
// half-spaces until the echo.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/replay.hpp"
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

double second_derivative(const std::vector<double>& u, std::size_t first, std::size_t stride, double h) {
  constexpr std::array<double, 9> weights{-1.0 / 560.0, 8.0 / 315.0, -0.2,        1.6,         -205.0 / 72.0,
                                          1.6,          -0.2,        8.0 / 315.0, -1.0 / 560.0};
  double sum = 0.0;
  for (std::size_t i = 0; i < 9; ++i) sum += weights[i] * u[first + i * stride];
  return sum / (h * h);
}

/// Derivatives of a component at the middle of a 9 × 9 stencil.
struct Derivatives {
  double value, r, z, rr, rz, zz;

  Derivatives(const std::vector<double>& u, double across, double deep) : value(u[40]) {
    std::vector<double> along(9), down(9);
    for (std::size_t i = 0; i < 9; ++i) {
      along[i] = test::derivative(u, 9 * i, 1, across);
      down[i] = test::derivative(u, i, 9, deep);
    }
    r = along[4];
    z = down[4];
    rz = test::derivative(along, 0, 1, deep);
    rr = second_derivative(u, 36, 1, across);
    zz = second_derivative(u, 4, 9, deep);
  }
};

class FieldInPlate : public testing::TestWithParam<FieldPlate> {
 protected:
  const FieldPlate its = GetParam();
  const Body body = its.body(5.0, 6.0);
  const ContactPoints contact = rings(24, 0.3);
  const std::vector<double> no_force = std::vector<double>(contact.count, 0.0);

  /// Of one wave by itself.
  [[nodiscard]] std::vector<double> only(std::size_t k) const {
    std::vector<double> coordinate(mode_count(body), 0.0);
    coordinate[k] = 1.0;
    return coordinate;
  }
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
        const Field at = field.at(only(k - 1), no_force);
        const Derivatives u(at.lateral, across, deep), w(at.normal, across, deep);
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
  constexpr std::array<double, 7> weights{-49.0 / 20.0, 6.0, -7.5, 20.0 / 3.0, -3.75, 1.2, -1.0 / 6.0};
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
        const Field at = field.at(only(k - 1), no_force);
        double u_z = 0.0, w_z = 0.0, size = 0.0;
        for (std::size_t i = 0; i < weights.size(); ++i) {
          u_z += weights[i] * at.lateral[9 * i + 4] / down;
          w_z += weights[i] * at.normal[9 * i + 4] / down;
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
  // Wherever the modes are: their own displacement of the contact points, and the residual compliance.
  std::vector<double> distance, coordinate, force;
  for (std::size_t i = 0; i < contact.count; ++i) {
    distance.push_back(std::sin(contact.angle(i)));
    force.push_back(1e-3 * std::sin(0.1 * static_cast<double>(i) + 0.2));
  }
  for (std::size_t k = 0; k < mode_count(body); ++k) coordinate.push_back(1e-3 * std::sin(static_cast<double>(k)));
  const Field at = its.field(body, contact, {distance, {0.0}}).at(coordinate, force);
  const Surface surface = body.surface(contact);
  const std::vector<double> compliance = body.residual_compliance(contact, {});
  std::vector<double> expected(contact.count, 0.0);
  double greatest = 0.0;
  for (std::size_t i = 0; i < contact.count; ++i) {
    std::size_t k = 0;
    for (const ModeGroup& group : body.groups) {
      const double shape = surface.shape[group.upper_row * contact.count + i];
      for (const double amplitude : group.upper) expected[i] -= amplitude * shape * coordinate[k++];
    }
    for (std::size_t j = 0; j < contact.count; ++j) expected[i] += compliance[i * contact.count + j] * force[j];
    greatest = std::max(greatest, std::abs(expected[i]));
  }
  // Each pair of contact points has its own highest wave number, the field only one.
  for (std::size_t i = 0; i < contact.count; ++i) EXPECT_NEAR(at.normal[i], expected[i], 2e-3 * greatest) << i;
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

TEST(PlateField, OfLongWavesBendsOrStretches) {
  // A bending wave: u_z as good as uniform, u_r = −(z − h/2) ∂u_z/∂r. A stretching one: u_r uniform, and the faces move
  // against each other.
  constexpr double thickness = 0.1;
  const Plate plate{.thickness = thickness, .poisson = 0.3};
  const Body body = stoss::plate(plate, 2.0, 10.0);
  const ContactPoints contact = rings(4, 0.1);
  const std::vector<double> none(contact.count, 0.0);
  constexpr double across = 0.01;
  const PlateField field(plate, body, contact, {test::stencil(1.0, across), {0.0, 0.5 * thickness, thickness}});
  std::size_t k = 0, bending = 0, stretching = 0;
  for (const ModeGroup& group : body.groups) {
    const double small = group.wave_number * thickness;
    for (const double omega : group.omega) {
      std::vector<double> coordinate(mode_count(body), 0.0);
      coordinate[k++] = 1.0;
      if (small > 0.2) continue;
      const Field at = field.at(coordinate, none);
      double size = 0.0;
      for (std::size_t i = 0; i < 27; ++i) size = std::max({size, std::abs(at.lateral[i]), std::abs(at.normal[i])});
      const double slow = group.wave_number * group.wave_number * thickness / std::sqrt(12.0 * (1.0 - 0.09));
      if (std::abs(omega - slow) < 0.2 * slow) {
        ++bending;
        const double slope = test::derivative(at.normal, 0, 1, across);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(at.normal[9 * i + 4], at.normal[4], small * small * size);
        EXPECT_NEAR(at.lateral[4], 0.5 * thickness * slope, small * small * size);
        EXPECT_NEAR(at.lateral[9 + 4], 0.0, 1e-9 * size);
        EXPECT_NEAR(at.lateral[18 + 4], -at.lateral[4], 1e-9 * size);
      } else {
        ++stretching;
        EXPECT_NEAR(omega, group.wave_number / std::sqrt(1.0 - 0.09), small * group.wave_number);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(at.lateral[9 * i + 4], at.lateral[4], small * small * size);
        EXPECT_NEAR(at.normal[9 + 4], 0.0, 1e-7 * size);
        EXPECT_NEAR(at.normal[18 + 4], -at.normal[4], 1e-7 * size);
      }
    }
  }
  EXPECT_GT(bending, 5U);
  EXPECT_GT(stretching, 5U);
}

/// Displacement inside what a sphere meets, some time after it does.
template <typename Inside>
Field after(double time, double cutoff, const Body& second, const Inside& inside) {
  const Contact meeting = contact(sphere(Sphere{.poisson = 0.3}, cutoff), second);
  const Impact impact = stoss::impact(meeting, 0.1, {}, {.modes = true});
  const ContactGrid grid = contact_grid(meeting, impact.resolution.half_width, impact.resolution.nodes);
  const BodyFrame seen = seen_by(meeting, grid, motion(meeting, impact, {time}).front(), 1);
  return inside(seen.points).at(seen.coordinate, seen.node_force);
}

TEST(PlateField, OfAThickPlateIsThatOfAHalfSpaceUntilTheEcho) {
  constexpr double cutoff = 10.0, duration = 12.0, thickness = 3.0;
  const Plate plate{.thickness = thickness, .poisson = 0.3};
  const PlaneGrid points{{0.0, 0.3, 0.8, 1.5}, {0.0, 0.1, 0.3, 0.7, 1.2}};
  const Body whole = stoss::plate(plate, cutoff, duration),
             half = stoss::half_space(HalfSpace{.poisson = 0.3}, cutoff, duration);
  ASSERT_NE(whole.groups.front().omega.size(), half.groups.front().omega.size());
  const double time = (2.0 * thickness - 1.3) / half_space::wave_speeds(Contour::ball, 0.3).pressure;
  const Field one =
      after(time, cutoff, whole, [&](const ContactPoints& at) { return PlateField(plate, whole, at, points); });
  const Field other = after(time, cutoff, half,
                            [&](const ContactPoints& at) { return half_space::HalfSpaceField(0.3, half, at, points); });
  const double greatest = *std::max_element(other.normal.begin(), other.normal.end());
  for (std::size_t i = 0; i < other.normal.size(); ++i) {
    EXPECT_NEAR(one.normal[i], other.normal[i], 3e-3 * greatest) << i;
    EXPECT_NEAR(one.lateral[i], other.lateral[i], 3e-3 * greatest) << i;
  }
}

TEST(PlateField, NothingRunsAheadOfThePressureWave) {
  constexpr double cutoff = 8.0, time = 6.0;
  const Plate plate{.thickness = 1.0, .poisson = 0.3};
  const double front = half_space::wave_speeds(Contour::ball, 0.3).pressure * time;
  const PlaneGrid points{{0.0, 0.3 * front, 1.05 * front, 1.5 * front}, {0.0, 0.5, 1.0}};
  const Body body = stoss::plate(plate, cutoff, 60.0);
  const Field at =
      after(time, cutoff, body, [&](const ContactPoints& its) { return PlateField(plate, body, its, points); });
  const double greatest = *std::max_element(at.normal.begin(), at.normal.end());
  for (std::size_t i = 0; i < points.depth.size(); ++i) {
    EXPECT_GT(std::abs(at.normal[4 * i]), 0.1 * greatest);
    for (const std::size_t j : {4 * i + 2, 4 * i + 3}) {
      EXPECT_NEAR(at.normal[j] / greatest, 0.0, 1e-3) << i;
      EXPECT_NEAR(at.lateral[j] / greatest, 0.0, 1e-3) << i;
    }
  }
}

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
