// The shares of a Prony series by non-negative least squares, and their shift with the temperature.
#include "stoss/relaxation/measurement.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>

#include "check.hpp"
#include "relaxation/nonnegative.hpp"
#include "relaxation/spaced.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr Range positive{1e-30, 1e30, true, true, "above 0, 1e-30 to 1e30"};

void validate(const Moduli& measured) {
  constexpr std::size_t fewest = 3;
  const std::size_t count = measured.frequency.size();
  if (count < fewest) throw InvalidInput::out_of_range("frequency", std::to_string(count) + " of them", "3 or more");
  if (measured.storage.size() != count || measured.loss.size() != count) {
    throw InvalidInput::conflict("frequency", "as many moduli as frequencies are needed");
  }
  for (std::size_t i = 0; i < count; ++i) {
    require("frequency", measured.frequency[i], positive, "of a measurement");
    require("storage", measured.storage[i], positive, "E' of a measurement");
    require("loss", measured.loss[i], positive, "E'' of a measurement");
    if (i > 0 && measured.frequency[i] <= measured.frequency[i - 1]) {
      throw InvalidInput::out_of_range(
          "frequency", shown(measured.frequency[i]) + " after " + shown(measured.frequency[i - 1]), "rising ones");
    }
  }
}

double root_mean_square(const Eigen::VectorXd& all) { return std::sqrt(all.squaredNorm() / double(all.size())); }

}  // namespace

FittedRelaxation relaxation_of_measurement(const Moduli& measured) {
  validate(measured);
  const double lowest = measured.frequency.front(), highest = measured.frequency.back();
  constexpr double in_decade = 3.0;
  const int count = std::min(static_cast<int>(most_relaxation_terms),
                             static_cast<int>(std::lround(in_decade * std::log10(highest / lowest))) + 1);
  const std::vector<double> times = spaced(1.0 / highest, 1.0 / lowest, std::max(count, 2));
  const auto rows = static_cast<Eigen::Index>(measured.frequency.size()),
             terms = static_cast<Eigen::Index>(times.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * rows, terms + 1);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (Eigen::Index j = 0; j < terms; ++j) {
      const std::complex<double> its = modulus_of_term(measured.frequency[at], times[static_cast<std::size_t>(j)]);
      matrix(i, j) = its.real() / measured.storage[at], matrix(rows + i, j) = its.imag() / measured.loss[at];
    }
    matrix(i, terms) = 1.0 / measured.storage[at];
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(2 * rows);
  const Eigen::VectorXd moduli = nonnegative_least_squares(matrix, ones);
  FittedRelaxation made{.relaxation = of_moduli(moduli, times), .instantaneous = moduli.sum()};
  const Eigen::VectorXd off = matrix * moduli - ones;
  made.storage_misfit = root_mean_square(off.head(rows)), made.loss_misfit = root_mean_square(off.tail(rows));
  return made;
}

Relaxation shifted(const Relaxation& relaxation, double c1, double c2, double reference, double temperature) {
  validate(relaxation);
  require("c1", c1, {0.0, 1e6, true, true, "0 to 1e6"}, "of Williams, Landel and Ferry");
  require("c2", c2, positive, "of Williams, Landel and Ferry");
  constexpr Range any{-1e6, 1e6, true, true, "-1e6 to 1e6"};
  require("reference", reference, any, "temperature"), require("temperature", temperature, any, "of the material");
  const double above = temperature - reference;
  if (c2 + above <= 0.0) {
    throw InvalidInput::out_of_range("temperature", shown(temperature), "above " + shown(reference - c2),
                                     "where the law of Williams, Landel and Ferry ends");
  }
  return in_time(relaxation, std::pow(10.0, -c1 * above / (c2 + above)));
}

}  // namespace stoss
