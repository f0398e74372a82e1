// Free motion of damped oscillators, and their answer to kicks.
#include <gtest/gtest.h>

#include <cmath>

#include "numeric/damped_oscillator.hpp"

namespace stoss::numeric {
namespace {

// Computed with 60 digits (mpmath) from M = e^{At}, A = (0, ω; −ω, −2γ): under-, nearly critically, critically and
// overdamped ones, at up to κt = 1e4.
struct Reference {
  double omega, gamma, time;
  double position, coupling, velocity;
  double beside;  // 1 − ωt [(1 − M)⁻¹M]₁₂
  double due;     // −[(1 − M)⁻¹M]₂₂
};

const Reference references[] = {{3, 0.2, 0.7, -0.38510418426982136, 0.75415819206891463, -0.48565860987900999,
                                 0.39702869076325343, 0.47265195362281693},
                                {3, 2.9999999, 0.7, 0.37961491498347725, 0.25715850473159065, -0.13470207733580376,
                                 0.29873397883946842, 0.19439165200399142},
                                {3, 3, 0.7, 0.37961492758424396, 0.25715849933126203, -0.1347020710782801,
                                 0.29873397448121892, 0.19439164644237043},
                                {3, 3.0000001, 0.7, 0.37961494018501015, 0.2571584939309337, -0.13470206482075681,
                                 0.29873397012296947, 0.19439164088074971},
                                {3, 3.5, 0.2, 0.88440490941759555, 0.30444888279779248, 0.17402418288941311,
                                 0.029221470743953031, 0.38568104332455889},
                                {2, 50, 0.05, 0.99839817596500364, 0.019840874210397428, 0.0063544654451322181,
                                 0.00061359214251225201, 0.19315996292346147},
                                {2, 5000, 0.3, 0.99988004719011767, 0.00019997601743706455, -3.9995205087221178e-8,
                                 5.9958804795056861e-5, 0.00033331336039760328},
                                {7, 1e-09, 11, -0.030975031247702517, 0.99952014758600956, -0.030975031533279702,
                                 -36.325371537601501, 0.49999999473449353},
                                {40, 39, 0.01, 0.93808890966285031, 0.27046630733593826, 0.41067961035777071,
                                 0.013234235234922689, 0.43531095420235617},
                                {1, 1000000.0, 3, 0.999998500001375, 4.999992500008125e-7, -2.4999962500046875e-13,
                                 7.49999562500375e-7, 1.6666654166678125e-7},
                                {0.5, 30, 400, 0.18886685804002279, 0.0015739997968000181, -1.3117575979378532e-5,
                                 0.61190727854666372, 1.6171653170024949e-5}};

}  // namespace

TEST(DampedOscillator, MovesAsTheMatrixExponential) {
  for (const auto& [omega, gamma, time, position, coupling, velocity, beside, due] : references) {
    SCOPED_TRACE(::testing::Message() << omega << " " << gamma << " " << time);
    const DampedMotion motion = damped_motion(omega, gamma, time);
    EXPECT_NEAR(motion.position, position, 1e-13 * std::abs(position) + 1e-16);
    EXPECT_NEAR(motion.coupling, coupling, 1e-13 * std::abs(coupling) + 1e-16);
    EXPECT_NEAR(motion.velocity, velocity, 1e-13 * std::abs(velocity) + 1e-16);
    EXPECT_NEAR(share_beside_kicks(omega, gamma, time), beside, 2e-13);
    EXPECT_NEAR(share_due(omega, gamma, time), due, 2e-13 * (1.0 + std::abs(due)));
  }
}

TEST(DampedOscillator, WithoutDampingRotates) {
  const DampedMotion motion = damped_motion(3.0, 0.0, 0.7);
  EXPECT_EQ(motion.position, std::cos(3.0 * 0.7));
  EXPECT_EQ(motion.velocity, std::cos(3.0 * 0.7));
  EXPECT_EQ(motion.coupling, std::sin(3.0 * 0.7));
  EXPECT_EQ(share_due(3.0, 0.0, 0.7), 0.5);
  for (const double gamma : {1e-6, 1e-9, 1e-12}) {
    EXPECT_NEAR(share_beside_kicks(3.0, gamma, 0.2), share_beside_kicks(3.0, 0.0, 0.2), gamma + 1e-13);
    EXPECT_NEAR(share_due(3.0, gamma, 0.2), 0.5, gamma + 1e-13);
  }
}

TEST(DampedOscillator, MovesForthAndBack) {
  for (const double gamma : {0.1, 2.0, 3.0, 8.0}) {
    const DampedMotion forth = damped_motion(3.0, gamma, 0.4), back = damped_motion(3.0, gamma, -0.4);
    const double scale = std::exp(0.8 * gamma);
    EXPECT_NEAR(back.position * forth.position - back.coupling * forth.coupling, 1.0, 1e-14 * scale);
    EXPECT_NEAR(back.position * forth.coupling + back.coupling * forth.velocity, 0.0, 1e-14 * scale);
    EXPECT_NEAR(forth.position * forth.velocity + forth.coupling * forth.coupling, std::exp(-0.8 * gamma), 1e-14);
  }
}

}  // namespace stoss::numeric
