#include "stoss/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss {

double Relaxation::relaxed() const {
  double left = 1.0;
  for (const RelaxationTerm& term : terms) left -= term.share;
  return std::max(0.0, left);
}

void validate(const Relaxation& relaxation) {
  constexpr double rounding = 1e-12;
  if (relaxation.terms.size() > most_relaxation_terms) {
    throw InvalidInput::out_of_range("relaxation", std::to_string(relaxation.terms.size()) + " terms",
                                     "up to " + std::to_string(most_relaxation_terms));
  }
  double sum = 0.0;
  for (const RelaxationTerm& term : relaxation.terms) {
    require("relaxation", term.share, {0.0, 1.0 + rounding, false, true, "shares of E(0) above 0, up to 1"},
            "E_j/E(0) of a term");
    require("relaxation", term.time, {1e-30, 1e30, true, true, "times above 0, 1e-30 to 1e30"}, "tau_j of a term");
    sum += term.share;
  }
  if (sum > 1.0 + rounding) {
    throw InvalidInput::out_of_range("relaxation", "shares of " + shown(sum) + " in sum", "at most 1",
                                     "what is left of it is E_inf/E(0)");
  }
}

void validate(const MaterialLoss& loss) {
  validate(loss.relaxation);
  require("loss_time", loss.loss_time, {0.0, std::numeric_limits<double>::max(), true, true, "finite, 0 or more"},
          "eta");
  if (loss.loss_time > 0.0 && !loss.relaxation.terms.empty()) {
    throw InvalidInput::conflict("relaxation", "the material has a loss_time too", "give one of both");
  }
}

std::complex<double> modulus(const MaterialLoss& loss, std::complex<double> s) {
  return modulus(loss.relaxation, s) + loss.loss_time * s;
}

std::complex<double> modulus(const Relaxation& relaxation, std::complex<double> s) {
  std::complex<double> sum = relaxation.relaxed();
  for (const RelaxationTerm& term : relaxation.terms) sum += term.share * (s * term.time) / (1.0 + s * term.time);
  return sum;
}

double modulus_after(const Relaxation& relaxation, double time) {
  double sum = relaxation.relaxed();
  for (const RelaxationTerm& term : relaxation.terms) sum += term.share * std::exp(-time / term.time);
  return sum;
}

Relaxation in_time(const Relaxation& relaxation, double factor) {
  Relaxation same = relaxation;
  for (RelaxationTerm& term : same.terms) term.time *= factor;
  return same;
}

MaterialLoss in_time(const MaterialLoss& loss, double factor) {
  return {loss.loss_time * factor, in_time(loss.relaxation, factor)};
}

}  // namespace stoss
