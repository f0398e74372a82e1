// What modes and quasistatic answer is what the library gives.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "answers.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/quasistatic.hpp"
#include "stoss/quasistatic/quantities.hpp"

namespace stoss::cli {
namespace {

TEST(Answers, OfModesAreThoseOfTheLibrary) {
  const auto expect_modes = [](const Case& of, const auto& quantities, const auto& modes) {
    const auto document = answer("modes", of, "--cutoff 4");
    ASSERT_EQ(document.at("records").size(), modes.size());
    for (std::size_t i = 0; i < modes.size(); ++i) {
      expect_all(document, i, quantities, modes[i], {.first = of.encounter().first});
    }
  };
  expect_modes({"--body disk --poisson 0.3", R"({"first":{"kind":"disk","poisson":0.3}})", ""},
               bodies::disk::mode_quantities(), bodies::disk::modes(0.3, 4.0));
  expect_modes(ball, bodies::sphere::mode_quantities(), bodies::sphere::modes(0.3, 4.0));
}

TEST(Answers, OfSlowImpactsAreThoseOfTheLibrary) {
  using namespace quasistatic;
  const auto expect_rows = [](const Case& of, const std::string& law, const auto& quantities, const auto& make) {
    const auto document = answer("quasistatic", of, "--cutoff 8 --law " + law + " --speed " + of.speed + ",1e-6");
    expect_all(document, 0, quantities, make(of.speed_in_c()), of.encounter());
    EXPECT_EQ(document.at("inputs").at("law"), law);
  };
  const auto disk_modes = bodies::disk::modes(0.33, 8.0), strained = bodies::disk::modes(0.25 / 0.75, 8.0);
  expect_rows({"--body disk --poisson 0.33", R"({"first":{"kind":"disk","poisson":0.33}})", "0.01"}, "diameter",
              rayleigh_quantities(), [&](double v) { return rayleigh(CompressionLaw::diameter, 0.33, v, disk_modes); });
  expect_rows(solid_disk, "center", rayleigh_quantities(),
              [&](double v) { return rayleigh(CompressionLaw::center, 0.25 / 0.75, v, strained); });
  const auto modes = bodies::sphere::modes(0.3, 8.0);
  for (const auto& [law, name] : {std::pair{PointLaw::center, "center"}, std::pair{PointLaw::hertz, "hertz"}}) {
    const PointLaw its = law;
    expect_rows(ball, name, point_rayleigh_quantities(), [&](double v) { return rayleigh(its, 0.3, v, modes); });
  }
}

TEST(Answers, OfBlocksAreThoseOfTheLibrary) {
  using namespace quasistatic;
  const auto expect_row = [](const Case& of, const std::string& block, const BallOnHalfSpace& bodies) {
    const auto document =
        answer("quasistatic", of, "--against half-space" + block + " --law hertz --speed " + of.speed);
    expect_all(document, 0, half_space_radiation_quantities(),
               half_space_radiation(PointLaw::hertz, bodies, of.speed_in_c()), of.encounter());
    EXPECT_FALSE(document.contains("modes") || document.at("inputs").contains("cutoff"));
  };
  const Case ratios{"--body sphere --poisson 0.3",
                    R"({"first":{"kind":"sphere","poisson":0.3},"against":{"kind":"half-space"}})", "0.01"};
  expect_row(ratios, "", {.poisson = 0.3, .half_space_poisson = 0.3});
  expect_row(ratios, ",poisson=0.2,young=0.5,density=0.4",
             {.poisson = 0.3, .half_space_poisson = 0.2, .young = 0.5, .density = 0.4});
}

TEST(Answers, OfCompressionsAreThoseOfTheLibrary) {
  using namespace quasistatic;
  const Json line = answer("quasistatic", {"--body disk --poisson 0.33", "", ""}, "--compression 0.01")["records"][0];
  const double force = compression_force(CompressionLaw::center, 0.33, 0.01);
  expect_number(line, "force", force);
  expect_number(line, "energy", compression_energy(CompressionLaw::center, 0.33, force));
  expect_number(line, "half_width", hertz_half_width(force));
  expect_number(line, "static_force", static_contact(0.33, 0.01).force);
  const Json point = answer("quasistatic", ball, "--compression 0.01 --law hertz")["records"][0];
  const double its = compression_force(PointLaw::hertz, 0.3, 0.01);
  expect_number(point, "force", its);
  expect_number(point, "energy", compression_energy(PointLaw::hertz, 0.3, its));
  expect_number(point, "contact_radius", contact_radius(PointLaw::hertz, 0.3, its));
  EXPECT_NEAR(point.at("static_force"),
              static_contact(Sphere{.poisson = 0.3}, 0.01, StaticContactOptions{80, {}}).force, 1e-15);
}

}  // namespace
}  // namespace stoss::cli
