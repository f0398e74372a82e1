// Impacts of round bodies that relax, by Ting's law: limits, first order, constant quality, two bodies.
#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "quasistatic/lossy_motion.hpp"
#include "quasistatic/relaxing_motion.hpp"
#include "stoss/errors.hpp"
#include "stoss/quasistatic/point_lossy_impact.hpp"
#include "stoss/quasistatic/relaxing_impact.hpp"
#include "support/refusal.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

constexpr double ball_mass = 4.0 * std::numbers::pi / 3.0;

RelaxingContact ball_that_relaxes(const Relaxation& relaxation, double poisson = 0.3) {
  return {1.0, {{{1.0 - poisson * poisson, relaxation}}}, ball_mass};
}

RelaxingMotion motion_of(const Relaxation& relaxation, double error = 2e-15) {
  return relaxing_motion(Rates(relaxation), error);
}

Relaxation twenty_terms() {
  Relaxation relaxation;
  for (int j = 0; j < 20; ++j) relaxation.terms.push_back({0.04, 1e-6 * std::pow(4.0, j)});
  return relaxation;
}

TEST(PointRelaxingImpact, OfNoTermsIsHertz) {
  for (const double speed : {1e-8, 1e-3}) {
    const RelaxingImpact impact = relaxing_impact(ball_that_relaxes({}), speed);
    const LossyImpact hertz = lossy_impact(LossyLaw::ting, {{1.0, 0.91}, ball_mass, 0.0}, speed);
    EXPECT_NEAR(impact.restitution, 1.0, 1e-14);
    EXPECT_NEAR(impact.contact_time / hertz.contact_time, 1.0, 1e-14);
    EXPECT_NEAR(impact.max_compression / hertz.max_compression, 1.0, 1e-14);
    EXPECT_NEAR(impact.max_force / (4.0 / 2.73 * std::pow(impact.max_compression, 1.5)), 1.0, 1e-14);
  }
}

TEST(PointRelaxingImpact, IsElasticFarFromItsTimes) {
  const RelaxingMotion hertz = motion_of({}), slow = motion_of({{{0.5, 1e12}}}), fast = motion_of({{{0.5, 1e-12}}});
  EXPECT_NEAR(slow.restitution, 1.0, 1e-11);
  EXPECT_NEAR(slow.contact_time, hertz.contact_time, 1e-11);
  EXPECT_NEAR(fast.restitution, 1.0, 1e-11);
  EXPECT_NEAR(fast.contact_time / hertz.contact_time, std::pow(2.0, 0.4), 1e-11);  // that of E∞
  EXPECT_NEAR(fast.max_force / hertz.max_force, std::pow(2.0, -0.4), 1e-11);
  for (const double time : {1e-30, 1e30}) EXPECT_NEAR(motion_of({{{0.5, time}}}).restitution, 1.0, 1e-14);
}

// E∞ with a fast term is a spring and a dashpot, η = E_jτ/E∞, but for the first power of τ and what is left of it.
TEST(PointRelaxingImpact, OfAFastTermIsThatOfKelvinAndVoigt) {
  for (const double x : {0.01, 0.1, 1.0, 10.0}) {
    const double loss_time = x / 1.5;  // in the unit of time of E∞
    const auto value = [&](double time) {
      const double whole = 1.0 + loss_time / time;
      return motion_of({{{1.0 - 1.0 / whole, time * std::pow(whole, 0.4)}}}).restitution;
    };
    const double viscous = lossy_motion(LossyLaw::ting, x).restitution;
    constexpr double time = 1e-4;
    const double one = value(time), half = value(0.5 * time), quarter = value(0.25 * time);
    EXPECT_NEAR(one, viscous, 0.3 * time);
    EXPECT_NEAR((one - 6.0 * half + 8.0 * quarter) / 3.0, viscous, 1e-11) << x;
  }
}

// Terms of t^−α by the trapezium rule, as in studies/loss/constant_quality.py.
TEST(PointRelaxingImpact, OfOneQualityAtAllFrequenciesLosesWhatTheStudyHas) {
  for (const auto& [quality, product] : std::vector<std::pair<double, double>>{
           {300.0, 2.40140}, {100.0, 2.38534}, {30.0, 2.32960}, {10.0, 2.17471}, {3.0, 1.69829}}) {
    const double alpha = 2.0 / std::numbers::pi * std::atan(1.0 / quality), step = 0.7;
    Rates rates;
    double sum = 0.0;
    for (int power = -23; power < 30; ++power) {
      rates.rate.push_back(std::exp(step * power));
      rates.share.push_back(step * std::pow(rates.rate.back(), alpha) / std::tgamma(alpha));
      sum += rates.share.back();
    }
    rates.relaxed = rates.share.front() / std::expm1(step * alpha);  // of all that are slower
    sum += rates.relaxed;
    for (double& share : rates.share) share /= sum;
    rates.relaxed /= sum;
    const double restitution = relaxing_motion(rates).restitution;
    EXPECT_NEAR((1.0 - restitution * restitution) * quality, product, 8e-5 * product) << quality;
  }
}

// (1 − ε²)mv²/4 = Σ_springs ∫₀^∞ (dω/2π) ω E″|û|², which is Σ_springs ½∫∫ E_j e^(−(t − t′)/τ_j) u̇ u̇′ dt′ dt. A pair of
// times has the springs of the smaller √δ; with the time s from touch to δ and all of T it is, with the share e,
// 1 − ε² = 6e ∫dδ ∫_0^δ dδ′ √δ′ [e^(−(s − s′)/τ) − e^(−(T − s − s′)/τ)].
TEST(PointRelaxingImpact, HasItsFirstOrder) {
  const double deepest = std::pow(1.25, 0.4), duration = 0.8 * deepest * boost::math::beta(0.4, 0.5);
  const auto since = [&](double place) {
    return 0.5 * duration * boost::math::ibeta(0.4, 0.5, std::min(1.0, std::pow(place / deepest, 2.5)));
  };
  boost::math::quadrature::tanh_sinh<double> outer, inner;
  constexpr double share = 1e-7;
  for (const double time : {0.03, 0.3, 1.0, 10.0, 1e3}) {
    const auto springs = [&](double place) {
      const double s = since(place);
      return inner.integrate(
          [&](double before) {
            const double earlier = since(before);
            return std::sqrt(before) * (std::exp(-(s - earlier) / time) - std::exp(-(duration - s - earlier) / time));
          },
          0.0, place, 1e-9);
    };
    const double expected = 6.0 * share * outer.integrate(springs, 0.0, deepest, 1e-8);
    const double restitution = motion_of({{{share, time}}}).restitution;
    EXPECT_NEAR((1.0 - restitution) * (1.0 + restitution), expected, 4.0 * share * expected + 1e-14) << time;
  }
}

// 1 − ε to 1e-8 of itself, even with errors of a step that are 500 times as large.
TEST(PointRelaxingImpact, HasConverged) {
  for (const Relaxation& its : {Relaxation{{{0.5, 1.0}}},
                                {{{1e-3, 1.0}}},
                                {{{0.5, 1e-3}}},
                                {{{0.4, 0.3}, {0.4, 5.0}}},
                                {{{0.999, 0.1}}},
                                {{{0.3, 1.0}, {0.3, 1.0 + 1e-7}}},
                                {{{0.5, 1.0}, {0.5, 4.0}}},
                                twenty_terms()}) {
    const RelaxingMotion best = motion_of(its);
    for (const double error : {1e-12, 1e-10}) {
      const RelaxingMotion coarse = motion_of(its, error);
      EXPECT_NEAR((1.0 - coarse.restitution) / (1.0 - best.restitution), 1.0, error == 1e-10 ? 1e-6 : 1e-8);
      EXPECT_NEAR(coarse.max_force / best.max_force, 1.0, 1e-8);
      EXPECT_NEAR(coarse.contact_time / best.contact_time, 1.0, 1e-8);
    }
  }
}

TEST(PointRelaxingImpact, HasTheUnitsOfItsBodies) {
  // The speed enters with the times over (m/k)^{2/5} v^{−1/5} alone.
  const RelaxingImpact slow = relaxing_impact(ball_that_relaxes({{{0.5, 32.0}}}), 1e-7);
  const RelaxingImpact fast = relaxing_impact(ball_that_relaxes({{{0.5, 16.0}}}), 32e-7);
  EXPECT_NEAR(slow.restitution, fast.restitution, 1e-13);
  EXPECT_NEAR(slow.contact_time / fast.contact_time, 2.0, 1e-13);
  EXPECT_NEAR(slow.max_force / fast.max_force, std::pow(32.0, -1.2), 1e-13);
  EXPECT_NEAR(slow.dissipated, 1.0 - slow.restitution * slow.restitution, 1e-15);
}

TEST(PointRelaxingImpact, OfTwoBodiesAddsTheirCompliances) {
  const Relaxation its{{{0.4, 10.0}, {0.3, 80.0}}};
  // Two equal bodies that meet at 2v are one at a wall at v.
  const RelaxingImpact wall = relaxing_impact(ball_that_relaxes(its), 1e-5);
  const RelaxingImpact pair = relaxing_impact({2.0, {{{0.91, its}, {0.91, its}}}, 0.5 * ball_mass}, 2e-5);
  EXPECT_NEAR(pair.restitution, wall.restitution, 1e-13);
  EXPECT_NEAR(pair.max_compression / wall.max_compression, 2.0, 1e-13);
  EXPECT_NEAR(pair.max_force / wall.max_force, 1.0, 1e-13);
  // A spring in series with r + (1 − r) sτ/(1 + sτ) is one with r/p and τ/p, where p = (1/k + r/k′)/(1/k + 1/k′).
  const double relaxed = 0.4, time = 30.0, softness = 0.7, others = 0.2;
  const double p = (softness + relaxed * others) / (softness + others);
  for (const bool first : {true, false}) {
    const RelaxingSide lossy{softness, {{{1.0 - relaxed, time}}}}, elastic{others, {}};
    const RelaxingImpact both =
        relaxing_impact({1.0, {first ? lossy : elastic, first ? elastic : lossy}, ball_mass}, 1e-5);
    const RelaxingImpact one =
        relaxing_impact({1.0, {{{softness + others, {{{1.0 - relaxed / p, time / p}}}}}}, ball_mass}, 1e-5);
    EXPECT_NEAR(both.restitution, one.restitution, 1e-13);
    EXPECT_NEAR(both.contact_time / one.contact_time, 1.0, 1e-13);
  }
  // Both materials with forty terms in all.
  Relaxation shifted = twenty_terms();
  for (RelaxationTerm& term : shifted.terms) term.time *= 1.7;
  const RelaxingContact forty{1.0, {{{0.5, twenty_terms()}, {0.5, shifted}}}, ball_mass};
  EXPECT_NEAR(relaxing_impact(forty, 1.0).restitution, 0.9, 0.1);
}

TEST(PointRelaxingImpact, RefusesWhatIsOutOfRange) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto of = [](const RelaxingContact& contact, double speed = 1e-3) {
    return [contact, speed] { (void)relaxing_impact(contact, speed); };
  };
  test::expect_refusal(of(ball_that_relaxes({{{1.5, 1.0}}})), {"relaxation", "1.5"});
  test::expect_refusal(of(ball_that_relaxes({{{0.5, 0.0}}})), {"relaxation", "times above 0"});
  test::expect_refusal(of({1.0, {{{-1.0, {}}}}, ball_mass}), {"softness", "-1"});
  test::expect_refusal(of({1.0, {}, ball_mass}), {"softness", "1/E*"});
  test::expect_refusal(of({0.0, {{{1.0, {}}}}, ball_mass}), {"curvature"});
  test::expect_refusal(of({1.0, {{{1.0, {}}}}, nan}), {"mass", "nan"});
  test::expect_refusal(of(ball_that_relaxes({}), 0.0), {"speed"});
  EXPECT_THROW((void)motion_of({{{1.0, 1e-9}}}), NotConverged);  // it sinks in
}

}  // namespace
}  // namespace stoss
