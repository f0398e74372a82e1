// The errata of the paper (docs/theory/errata.md) that no other test shows.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/bessel_prime.hpp>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/field.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/quasistatic.hpp"
#include "support/body_tools.hpp"

namespace stoss {
using namespace bodies::disk;
using namespace quasistatic;
namespace {

using std::numbers::pi;
using Gauss = boost::math::quadrature::gauss<double, 30>;

/// ∫_0^1 f(r) dr.
template <typename Function>
double over_radius(const Function& f) {
  return Gauss::integrate(f, 0.0, 1.0);
}

TEST(Errata, E1EnergyOfAModeHasTheFactorOneHalf) {
  const double poisson = 0.33;
  const Body body = disk(poisson, 6.0);
  const ContactGrid contact = test::grid_of(body, 0.5, 20);
  const std::vector<double> no_force(contact.coordinate.size(), 0.0);
  constexpr int angles = 32;  // enough for the squares of all orders below the cutoff
  std::vector<double> angle;
  for (int i = 0; i < angles; ++i) angle.push_back(2.0 * pi * i / angles - pi);

  std::size_t mode = 0;
  for (const ModeGroup& group : body.groups) {
    for (const double omega : group.omega) {
      ASSERT_LT(2 * group.order, angles);
      std::vector<double> coordinate(mode_count(body), 0.0);
      coordinate[mode++] = 1.0;
      // ½ ∫ σ:ε of the mode at rest with Q = 1, with E = 1.
      const double energy = over_radius([&](double r) {
        const Field at = DiskField(poisson, body, contact.points, {{r}, angle}).at(coordinate, no_force);
        double sum = 0.0;
        for (std::size_t i = 0; i < angle.size(); ++i) {
          const double rr = at.stress_rr[i], pp = at.stress_pp[i], rp = at.stress_rp[i];
          sum += rr * rr + pp * pp - 2.0 * poisson * rr * pp + 2.0 * (1.0 + poisson) * rp * rp;
        }
        return 0.5 * r * sum * 2.0 * pi / angles;
      });
      EXPECT_NEAR(energy / (body.mass * omega * omega), 0.5, 1e-11) << "order " << group.order;
    }
  }
  EXPECT_GT(mode, 10U);
}

/// ∫ r u·u dr of the modes (n, 0) and (n, 1), normalised, with u from eq. (19), or with κ and κ′ exchanged in u_φ.
double overlap(int n, bool as_printed) {
  using boost::math::cyl_bessel_j;
  using boost::math::cyl_bessel_j_prime;
  const double poisson = 0.33;
  const auto field = [&](const Mode& mode, double r) {
    const double k = mode.omega * std::sqrt(1.0 - poisson * poisson);
    const double shear = mode.omega * std::sqrt(2.0 * (1.0 + poisson));
    // A : B from the vanishing shear stress at the edge, eq. (22).
    const double a =
        2.0 * shear * cyl_bessel_j_prime(n, shear) + (shear * shear - 2.0 * n * n) * cyl_bessel_j(n, shear);
    const double b = 2.0 * n * (k * cyl_bessel_j_prime(n, k) - cyl_bessel_j(n, k));
    const double first = as_printed ? shear : k;
    const double second = as_printed ? k : shear;
    return std::array{a * k * cyl_bessel_j_prime(n, k * r) + n * b * cyl_bessel_j(n, shear * r) / r,
                      -n * a * cyl_bessel_j(n, first * r) / r - b * second * cyl_bessel_j_prime(n, second * r)};
  };
  std::vector<Mode> modes;
  for (const Mode& mode : bodies::disk::modes(poisson, 12.0)) {
    if (mode.order == n) modes.push_back(mode);
  }
  const auto product = [&](const Mode& one, const Mode& other) {
    return over_radius([&](double r) {
      const auto u = field(one, r), w = field(other, r);
      return r * (u[0] * w[0] + u[1] * w[1]);
    });
  };
  return product(modes[0], modes[1]) / std::sqrt(product(modes[0], modes[0]) * product(modes[1], modes[1]));
}

TEST(Errata, E4PrintedFieldsAreNotOrthogonal) {
  constexpr std::array printed{0.04, 0.56, 0.71};
  for (const int n : {1, 2, 3}) {
    EXPECT_NEAR(std::abs(overlap(n, true)), printed[static_cast<std::size_t>(n - 1)], 0.005) << n;
    EXPECT_NEAR(overlap(n, false), 0.0, 1e-12) << n;
  }
}

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
  const Impact expected = impact(body, wall, 0.1, {.resolution = {.step = 0.002}});
  EXPECT_NEAR(reversed.lost_fraction, expected.lost_fraction, 1e-4);
  const auto printed = InteractionPicture(body, wall, -1.0).collide(0.1, 0.01);
  EXPECT_FALSE(printed.energy_error < 10.0);
}

TEST(Errata, E10DilatationHasTheOppositeSign) {
  // In the mode (0, l), u_r = A dJ_0(κr)/dr: the paper prints η = +Aκ²J_0.
  for (const Mode& mode : bodies::disk::modes(0.33, 12.0)) {
    if (mode.order != 0) continue;
    const double k = mode.omega * std::sqrt(1.0 - 0.33 * 0.33), r = 0.3, h = 1e-3;
    const auto field = displacement(0.33, mode, {r - h, r, r + h});
    const double dilatation = (field[2].radial - field[0].radial) / (2.0 * h) + field[1].radial / r;
    const double amplitude = field[1].radial / (k * boost::math::cyl_bessel_j_prime(0, k * r));
    const double printed = amplitude * k * k * boost::math::cyl_bessel_j(0, k * r);
    EXPECT_NEAR(dilatation / printed, -1.0, k * k * h * h);
  }
}

TEST(Errata, E11AllLawsHaveTheSameWaveAtOtherSpeeds) {
  // The estimate depends on v/F* only, with F* the limit force of the law.
  const double poisson = 0.33;
  const std::vector<Mode> modes = bodies::disk::modes(poisson, 25.0);
  for (const auto law : {CompressionLaw::printed, CompressionLaw::diameter}) {
    for (const double speed : {1e-8, 1e-4, 0.0012, 0.009}) {
      const double other = speed * limit_force(law, poisson) / limit_force(CompressionLaw::center, poisson);
      const double expected = rayleigh(CompressionLaw::center, poisson, speed, modes).lost_fraction;
      EXPECT_NEAR(rayleigh(law, poisson, other, modes).lost_fraction / expected, 1.0, 1e-9) << speed;
    }
  }
}

TEST(Errata, E12FewModesGiveLessThanAllDo) {
  // ε at ν = 0.9, v = 0.3 c and αR = 500 with the modes below a cutoff; the paper prints 0.65, all modes give 0.7477.
  const auto restitution = [](double cutoff) {
    return impact(disk(0.9, cutoff), ExponentialWall{500.0}, 0.3, {.resolution = {.step = 0.001}}).restitution;
  };
  EXPECT_EQ(mode_count(disk(0.9, 3.0)), 5U);
  EXPECT_NEAR(restitution(3.0), 0.63, 0.005);
  EXPECT_NEAR(restitution(6.0), 0.74, 0.005);
}

}  // namespace
}  // namespace stoss
