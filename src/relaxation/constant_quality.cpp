// M(iω) ∝ (iω)^{2γ/π}, γ = atan(1/Q): a quality that is the same at all frequencies.
#include "stoss/relaxation/constant_quality.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "check.hpp"
#include "relaxation/nonnegative.hpp"
#include "relaxation/spaced.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr double flat = 0.01;  // of 1/Q over the band

double exponent(double quality) { return 2.0 / std::numbers::pi * std::atan(1.0 / quality); }

/// Moduli at these times, and last E∞, that come nearest to the power law relative to E′ and E″.
Eigen::VectorXd fitted(double power, const std::vector<double>& frequencies, const std::vector<double>& times) {
  const auto rows = static_cast<Eigen::Index>(frequencies.size()), terms = static_cast<Eigen::Index>(times.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * rows, terms + 1);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double frequency = frequencies[static_cast<std::size_t>(i)];
    const std::complex<double> wanted = std::pow(std::complex<double>(0.0, frequency), power);
    for (Eigen::Index j = 0; j < terms; ++j) {
      const std::complex<double> its = modulus_of_term(frequency, times[static_cast<std::size_t>(j)]);
      matrix(i, j) = its.real() / wanted.real(), matrix(rows + i, j) = its.imag() / wanted.imag();
    }
    matrix(i, terms) = 1.0 / wanted.real();
  }
  return nonnegative_least_squares(matrix, Eigen::VectorXd::Ones(2 * rows));
}

/// How far 1/Q is off at the worst of these frequencies.
double worst(const Relaxation& relaxation, double quality, const std::vector<double>& frequencies) {
  double most = 0.0;
  for (const double frequency : frequencies) {
    const std::complex<double> its = modulus(relaxation, {0.0, frequency});
    most = std::max(most, std::abs(its.imag() / its.real() * quality - 1.0));
  }
  return most;
}

Relaxation made_for(double quality, double lowest, double highest) {
  const double decades = std::log10(highest / lowest);
  constexpr double in_decade = 12.0, margin = 2.0;
  const std::vector<double> band = spaced(lowest, highest, static_cast<int>(in_decade * decades) + 3);
  for (int count = 2; count <= static_cast<int>(most_relaxation_terms); ++count) {
    const std::vector<double> times = spaced(1.0 / (margin * highest), margin / lowest, count);
    Relaxation made = of_moduli(fitted(exponent(quality), band, times), times);
    if (worst(made, quality, band) <= flat) return made;
  }
  throw InvalidInput::out_of_range("highest", shown(highest) + " with a quality of " + shown(quality),
                                   "a band that " + std::to_string(most_relaxation_terms) + " terms cover",
                                   "from " + shown(lowest) + " on");
}

}  // namespace

Relaxation constant_quality(double quality, double lowest, double highest) {
  require("quality", quality, {3.0, 1e9, true, true, "3 to 1e9"},
          "Q, the same at all frequencies: steel has 1e3 to 1e4, rubber 5 to 20; a smaller one needs a relaxation");
  constexpr Range any{1e-30, 1e30, true, true, "above 0, 1e-30 to 1e30"};
  require("lowest", lowest, any, "of the band"), require("highest", highest, any, "of the band");
  if (!(lowest < highest)) throw InvalidInput::out_of_range("highest", shown(highest), "above the lowest frequency");
  // An encounter asks for that of its two bodies again and again; it takes 2 ms.
  constexpr std::size_t most = 64;
  thread_local std::map<std::array<double, 3>, Relaxation> known;
  const std::array asked{quality, lowest, highest};
  if (const auto found = known.find(asked); found != known.end()) return found->second;
  if (known.size() == most) known.clear();
  return known.emplace(asked, made_for(quality, lowest, highest)).first->second;
}

double instantaneous(const Relaxation& relaxation, double quality, double frequency) {
  if (relaxation.terms.empty()) return 1.0;
  const auto [least, most] =
      std::minmax_element(relaxation.terms.begin(), relaxation.terms.end(),
                          [](const RelaxationTerm& one, const RelaxationTerm& other) { return one.time < other.time; });
  const double middle = 1.0 / std::sqrt(least->time * most->time);
  return std::pow(middle / frequency, exponent(quality)) / std::abs(modulus(relaxation, {0.0, middle}));
}

}  // namespace stoss
