#include "relaxation/spaced.hpp"

#include <cmath>

namespace stoss {

std::complex<double> modulus_of_term(double frequency, double time) {
  const std::complex<double> s(0.0, frequency * time);
  return s / (1.0 + s);
}

std::vector<double> spaced(double low, double high, int count) {
  std::vector<double> all;
  all.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) all.push_back(low * std::pow(high / low, i / (count - 1.0)));
  return all;
}

Relaxation of_moduli(const Eigen::VectorXd& moduli, const std::vector<double>& times) {
  Relaxation made;
  for (std::size_t j = 0; j < times.size(); ++j) {
    const double share = moduli(static_cast<Eigen::Index>(j)) / moduli.sum();
    if (share > 0.0) made.terms.push_back({share, times[j]});
  }
  return made;
}

}  // namespace stoss
