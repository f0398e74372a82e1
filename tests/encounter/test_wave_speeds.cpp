// Materials by the speeds of their waves.
#include <gtest/gtest.h>

#include <cmath>

#include "stoss/encounter/document.hpp"
#include "stoss/errors.hpp"
#include "stoss/material.hpp"

namespace {

using stoss::InvalidInput;
using stoss::material_of_wave_speeds;

/// Speeds by Lamé's constants: ρc_p² = λ + 2μ, ρc_s² = μ.
TEST(WaveSpeeds, ComeBack) {
  for (const double poisson : {-0.5, 0.0, 0.25, 0.3, 0.49}) {
    const double young = 7e10, density = 2500.0, shear = young / (2.0 * (1.0 + poisson));
    const double lame = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
    const stoss::Material made =
        material_of_wave_speeds(std::sqrt((lame + 2.0 * shear) / density), std::sqrt(shear / density), density);
    EXPECT_NEAR(made.young / young, 1.0, 1e-12);
    EXPECT_NEAR(made.poisson, poisson, 1e-12);
  }
}

TEST(WaveSpeeds, AreRefusedWhereNoSolidHasThem) {
  EXPECT_THROW((void)material_of_wave_speeds(1.15 * 3000.0, 3000.0, 2500.0), InvalidInput);
  EXPECT_NO_THROW((void)material_of_wave_speeds(1.16 * 3000.0, 3000.0, 2500.0));
  for (const double wrong : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW((void)material_of_wave_speeds(wrong, 3000.0, 2500.0), InvalidInput);
    EXPECT_THROW((void)material_of_wave_speeds(6000.0, wrong, 2500.0), InvalidInput);
    EXPECT_THROW((void)material_of_wave_speeds(6000.0, 3000.0, wrong), InvalidInput);
  }
}

TEST(WaveSpeeds, StandInDocuments) {
  const auto read = [](const std::string& material) {
    return stoss::encounter_from_json(R"({"first": {"kind": "sphere", "radius": 0.01, "material": )" + material + "}}");
  };
  const stoss::Material known = material_of_wave_speeds(5900.0, 3200.0, 7850.0);
  const auto of_speeds = read(R"({"c_p": 5900, "c_s": 3200, "density": 7850})");
  EXPECT_EQ(of_speeds.first.material->young, known.young);
  EXPECT_EQ(of_speeds.first.material->poisson, known.poisson);
  EXPECT_THROW((void)read(R"({"c_p": 5900, "density": 7850})"), InvalidInput);
  EXPECT_THROW((void)read(R"({"c_p": 5900, "c_s": 3200})"), InvalidInput);
  EXPECT_THROW((void)read(R"({"c_p": 5900, "c_s": 3200, "density": 7850, "young": 2e11})"), InvalidInput);
}

}  // namespace
