#include "bodies/plate/energy_shares.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/plate/stack.hpp"

namespace stoss::bodies::plate {

template <int N>
std::vector<double> energy_shares(const Sheets& sheets, double wave_number, double omega,
                                  const Eigen::Matrix<double, N, 1>& amplitude, std::size_t kinds) {
  std::vector<double> shares(kinds, 0.0);
  double sum = 0.0;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    const auto varied = [kind](int each) {
      return Differentiable{1.0, static_cast<std::size_t>(each) == kind ? 1.0 : 0.0};
    };
    const auto stiffness = stack_of_factors<N>(sheets, wave_number, Differentiable{omega * omega}, varied);
    shares[kind] = std::max(0.0, amplitude.dot(second(stiffness) * amplitude));
    sum += shares[kind];
  }
  // A wave at the other face, which moves this one by less than rounding, has them alike.
  for (double& share : shares) share = std::isnormal(sum) ? share / sum : 1.0 / static_cast<double>(kinds);
  return shares;
}

template <int N>
std::vector<double> static_energies(const Sheets& sheets, double wave_number, std::size_t kinds) {
  std::vector<double> energies;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    const auto varied = [kind](int each) {
      return Differentiable{1.0, static_cast<std::size_t>(each) == kind ? 1.0 : 0.0};
    };
    const auto stiffness = stack_of_factors<N>(sheets, wave_number, Differentiable{0.0}, varied);
    energies.push_back(std::max(0.0, -second(inverse(stiffness))(N - 1, N - 1)));
  }
  return energies;
}

template std::vector<double> static_energies<1>(const Sheets&, double, std::size_t);
template std::vector<double> static_energies<2>(const Sheets&, double, std::size_t);
template std::vector<double> energy_shares<1>(const Sheets&, double, double, const Eigen::Matrix<double, 1, 1>&,
                                              std::size_t);
template std::vector<double> energy_shares<2>(const Sheets&, double, double, const Eigen::Matrix<double, 2, 1>&,
                                              std::size_t);

}  // namespace stoss::bodies::plate
