#include "bodies/plate/wave_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "bodies/plate/branches.hpp"

namespace stoss::bodies::plate {
namespace {

using Eigen::Index;

constexpr double as_deep_as_it_is = std::numeric_limits<double>::infinity();

std::vector<DepthResponse> all_of(const std::vector<Sheets>& parts, const std::vector<double>& depths) {
  std::vector<DepthResponse> all;
  for (const Sheets& part : parts) all.emplace_back(part, depths);
  return all;
}

/// How one wave moves all depths. Along k it is the motion towards −k that goes with motion into the depth
/// (PlaneWaves).
Eigen::VectorXd profile(const DepthResponse& response, double k, const Amplitude& wave) {
  const Depths<double> depths = response.at<double>(k, wave.omega * wave.omega, as_deep_as_it_is);
  Eigen::VectorXd all(2 * static_cast<Index>(depths.transfer.size()));
  for (std::size_t i = 0; i < depths.transfer.size(); ++i) {
    for (int row = 0; row < 2; ++row) {
      const auto& transfer = depths.transfer[i];
      all(2 * static_cast<Index>(i) + row) = wave.normal * transfer(row, 1) - wave.along * transfer(row, 0);
    }
  }
  // Where a wave at the other face moves this one by less than rounding.
  if (!all.allFinite()) all.setZero();
  return all;
}

/// Σ over a circle of the answer of all waves of a part less that of the kept ones.
/// @param share of the part in a load and in the displacement @param kept profiles of the waves
Eigen::VectorXd others(const DepthResponse& response, double k, double share, double radius, const Amplitude* waves,
                       const Eigen::Ref<const Eigen::MatrixXd>& kept) {
  constexpr int places = 8;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(kept.rows());
  for (int n = 0; n < places; ++n) {
    const double angle = std::numbers::pi * (n + 0.5) / places;
    const Complex z{radius * std::cos(angle), radius * std::sin(angle)};
    const Depths<Complex> depths = response.at<Complex>(k, z, as_deep_as_it_is);
    const SmallMatrix<Complex, 2> response_of_face = inverse(depths.stiffness);
    for (std::size_t i = 0; i < depths.transfer.size(); ++i) {
      const SmallMatrix<Complex, 2> moved = depths.transfer[i] * response_of_face;
      sum(2 * static_cast<Index>(i)) += share * moved(0, 1).a;
      sum(2 * static_cast<Index>(i) + 1) += share * moved(1, 1).a;
    }
    for (Index l = 0; l < kept.cols(); ++l) {
      const Complex over = 1.0 / (waves[l].omega * waves[l].omega - z);
      sum -= waves[l].normal * over.a * kept.col(l);
    }
  }
  return sum / places;
}

}  // namespace

ProfileMaker::ProfileMaker(const Lamina& plate, const std::vector<double>& depths)
    : plate_(plate),
      rows_(2 * static_cast<Index>(depths.size())),
      whole_(all_of(plate.whole, depths)),
      halves_(all_of(plate.halves, depths)) {}

const std::vector<DepthResponse>& ProfileMaker::responses(double wave_number) const {
  return &plate_.parts(wave_number) == &plate_.whole ? whole_ : halves_;
}

WaveProfiles ProfileMaker::of(const WaveNumber& number, const std::vector<Amplitude>& waves, double cutoff) const {
  constexpr double share_of_circle = 0.15;  // in that of the next singularity at least
  const std::vector<Sheets>& parts = plate_.parts(number.k);
  const std::vector<DepthResponse>& answers = responses(number.k);
  WaveProfiles made{number.k, Eigen::MatrixXd(rows_, static_cast<Index>(waves.size())), Eigen::VectorXd::Zero(rows_)};
  std::size_t first = 0;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const std::size_t below = part + 1 == parts.size()
                                  ? waves.size()
                                  : first + static_cast<std::size_t>(count_below<2>(parts[part], number.k, cutoff));
    const std::size_t end = std::min(below, waves.size());
    for (std::size_t l = first; l < end; ++l)
      made.kept.col(static_cast<Index>(l)) = profile(answers[part], number.k, waves[l]);
    const auto kept = made.kept.middleCols(static_cast<Index>(first), static_cast<Index>(end - first));
    const double share = number.weight * plate_.weight(number.k) * parts[part].share;
    made.others +=
        others(answers[part], number.k, share, share_of_circle * cutoff * cutoff, waves.data() + first, kept);
    first = end;
  }
  // A coordinate moves the surface against the depth, whatever the sign of the wave's amplitude.
  for (std::size_t l = 0; l < waves.size(); ++l) {
    if (waves[l].normal > 0.0) made.kept.col(static_cast<Index>(l)) *= -1.0;
  }
  return made;
}

WaveProfiles ProfileMaker::of(const WaveNumber& number) const {
  const bool deep = number.k * plate_.thickness > deepest_phase;
  const std::vector<Sheets>& parts = deep ? plate_.whole : plate_.parts(number.k);
  const std::vector<DepthResponse>& answers = deep ? whole_ : responses(number.k);
  WaveProfiles made{number.k, Eigen::MatrixXd(rows_, 0), Eigen::VectorXd::Zero(rows_)};
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const double share = number.weight * plate_.weight(number.k) * parts[part].share;
    const Depths<double> depths = answers[part].at<double>(number.k, 0.0, deepest_phase / number.k);
    const SmallMatrix<double, 2> response_of_face = inverse(depths.stiffness);
    for (std::size_t i = 0; i < depths.transfer.size(); ++i) {
      const SmallMatrix<double, 2> moved = depths.transfer[i] * response_of_face;
      made.others(2 * static_cast<Index>(i)) += share * moved(0, 1);
      made.others(2 * static_cast<Index>(i) + 1) += share * moved(1, 1);
    }
  }
  return made;
}

}  // namespace stoss::bodies::plate
