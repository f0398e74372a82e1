// The errata of the paper (docs/theory/errata.md) that no other test shows; those of its modes are in
// test_errata_modes.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/quasistatic.hpp"

namespace stoss {
using namespace bodies::disk;
using namespace quasistatic;
namespace {

using std::numbers::pi;

/// The paper's equations of motion, eqs. (43) and (44), by Runge and Kutta, with the sign of (43) to choose.
class InteractionPicture {
 public:
  InteractionPicture(const Body& body, const ExponentialWall& wall, double sign)
      : body_(body), wall_(wall), sign_(sign), q_(mode_count(body)) {}

  struct Outcome {
    double lost_fraction = std::numeric_limits<double>::quiet_NaN();  // unless the disk has come back
    double energy_error = std::numeric_limits<double>::infinity();
  };

  Outcome collide(double speed, double step) {
    velocity_ = speed;
    center_ = start_ = -1.0 - 40.0 / wall_.hardness;  // where the wall's potential is e⁻⁴⁰
    const double before = energy();
    for (int i = 0; i < 100000 && center_ >= start_ && std::isfinite(center_); ++i) advance(step);
    if (!(center_ < start_)) return {};
    return {1.0 - velocity_ * velocity_ / (speed * speed), std::abs(energy() / before - 1.0)};
  }

 private:
  using Amplitudes = std::vector<std::complex<double>>;
  struct Rates {
    double acceleration;
    Amplitudes q;
  };

  /// Calls act(shape, value of e^{αx}) for the angles of the upper half and their mirror images.
  template <typename Act>
  void at_the_edge(double time, double center, const Amplitudes& q, const Act& act) const {
    for (int i = 0; i < angles; ++i) {
      const double phi = (i + 0.5) * 0.5 * pi / angles;
      double x = center + std::cos(phi);
      std::vector<double> shape;
      for (const ModeGroup& group : body_.groups) {
        for (std::size_t l = 0; l < group.omega.size(); ++l) {
          const std::complex<double> turn = std::polar(1.0, group.omega[l] * time);
          shape.push_back(group.upper[l] * std::cos((group.order + 1) * phi) +
                          group.lower[l] * std::cos((group.order - 1) * phi));
          x += shape.back() * (q[shape.size() - 1] * turn).real();
        }
      }
      act(shape, std::exp(wall_.hardness * x) * pi / angles);
    }
  }

  Rates rates(double time, double center, const Amplitudes& q) const {
    Rates result{0.0, Amplitudes(q.size())};
    std::vector<double> drive(q.size(), 0.0);
    at_the_edge(time, center, q, [&](const std::vector<double>& shape, double weight) {
      const double force = wall_.hardness * wall_.strength * weight;
      result.acceleration -= force / body_.mass;
      for (std::size_t k = 0; k < shape.size(); ++k) drive[k] += shape[k] * force;
    });
    std::size_t k = 0;
    for (const ModeGroup& group : body_.groups) {
      for (const double omega : group.omega) {
        result.q[k] =
            sign_ * std::complex<double>(0.0, drive[k] / (body_.mass * omega)) * std::polar(1.0, -omega * time);
        ++k;
      }
    }
    return result;
  }

  void advance(double h) {
    const auto moved = [&](const Rates& by, double length) {
      Amplitudes result = q_;
      for (std::size_t k = 0; k < q_.size(); ++k) result[k] += length * by.q[k];
      return result;
    };
    const Rates a = rates(time_, center_, q_);
    const Rates b = rates(time_ + 0.5 * h, center_ + 0.5 * h * velocity_, moved(a, 0.5 * h));
    const Rates c =
        rates(time_ + 0.5 * h, center_ + 0.5 * h * (velocity_ + 0.5 * h * a.acceleration), moved(b, 0.5 * h));
    const Rates d = rates(time_ + h, center_ + h * (velocity_ + 0.5 * h * b.acceleration), moved(c, h));
    center_ += h * (velocity_ + h * (a.acceleration + b.acceleration + c.acceleration) / 6.0);
    velocity_ += h * (a.acceleration + 2.0 * b.acceleration + 2.0 * c.acceleration + d.acceleration) / 6.0;
    for (std::size_t k = 0; k < q_.size(); ++k) q_[k] += h * (a.q[k] + 2.0 * b.q[k] + 2.0 * c.q[k] + d.q[k]) / 6.0;
    time_ += h;
  }

  double energy() const {
    double sum = 0.5 * body_.mass * velocity_ * velocity_;
    std::size_t k = 0;
    for (const ModeGroup& group : body_.groups) {
      for (const double omega : group.omega) sum += 0.5 * body_.mass * omega * omega * std::norm(q_[k++]);
    }
    at_the_edge(time_, center_, q_, [&](const auto&, double weight) { sum += wall_.strength * weight; });
    return sum;
  }

  static constexpr int angles = 64;
  const Body& body_;
  ExponentialWall wall_;
  double sign_;
  Amplitudes q_;
  double center_ = 0.0, start_ = 0.0, velocity_ = 0.0, time_ = 0.0;
};

TEST(Errata, E6PrintedSignMakesTheWallAttractTheEdge) {
  const Body body = disk(0.33, 3.0);
  const ExponentialWall wall{.hardness = 50.0};
  const auto reversed = InteractionPicture(body, wall, +1.0).collide(0.1, 0.01);
  EXPECT_LT(reversed.energy_error, 1e-6);
  const Impact expected = impact(body, wall, 0.1, {.resolution = {.step = 0.002, .tail = Tail::none}});
  EXPECT_NEAR(reversed.lost_fraction, expected.lost_fraction, 1e-4);
  const auto printed = InteractionPicture(body, wall, -1.0).collide(0.1, 0.01);
  EXPECT_FALSE(printed.energy_error < 10.0);
}

TEST(Errata, E11AllLawsHaveTheSameWaveAtOtherSpeeds) {
  // The estimate depends on v/F* only, with F* the limit force of the law.
  const double poisson = 0.33;
  const std::vector<Mode> modes = bodies::disk::modes(poisson, 25.0);
  const auto law = CompressionLaw::diameter;
  for (const double speed : {1e-8, 1e-4, 0.0012, 0.009}) {
    const double other = speed * limit_force(law, poisson) / limit_force(CompressionLaw::center, poisson);
    const double expected = rayleigh(CompressionLaw::center, poisson, speed, modes).lost_fraction;
    EXPECT_NEAR(rayleigh(law, poisson, other, modes).lost_fraction / expected, 1.0, 1e-9) << speed;
  }
}

TEST(Errata, E12FewModesGiveLessThanAllDo) {
  // ε at ν = 0.9, v = 0.3 c and αR = 500 with the modes below a cutoff; the paper prints 0.65, all modes give 0.7477.
  const auto restitution = [](double cutoff) {
    return impact(disk(0.9, cutoff), ExponentialWall{500.0}, 0.3, {.resolution = {.step = 0.001, .tail = Tail::none}})
        .restitution;
  };
  EXPECT_EQ(mode_count(disk(0.9, 3.0)), 5U);
  EXPECT_NEAR(restitution(3.0), 0.63, 0.005);
  EXPECT_NEAR(restitution(6.0), 0.74, 0.005);
}

}  // namespace
}  // namespace stoss
