#include "bodies/plate/wave_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "bodies/plate/branches.hpp"
#include "bodies/plate/slab.hpp"

namespace stoss::bodies::plate {
namespace {

/// How many equal slabs a piece is cut into so that none has a vibration, whatever of it is held; and one of them.
template <typename T>
ThinSlab<T, 2> slab_of(const Sheet& sheet, double thickness, double k, T z, int& count) {
  constexpr double thickest = 0.96;  // phase
  const double square = magnitude(z) * sheet.density / sheet.shear_modulus;
  const double phase = thickness * std::max(k, std::sqrt(square));
  count = std::max(1, static_cast<int>(std::ceil(phase / thickest)));
  return thin_slab(equations<2, T>(sheet, k, z, thickness / count));
}

/// Puts a slab on what has a stiffness. @return how it moves its lower face
template <typename T>
SmallMatrix<T, 2> put_on(const ThinSlab<T, 2>& slab, SmallMatrix<T, 2>& stiffness) {
  const SmallMatrix<T, 2> moved = inverse(plus(1.0, slab.compliance * stiffness)) * slab.transfer;
  stiffness = slab.stiffness + transposed(slab.transfer) * (stiffness * moved);
  return moved;
}

/// The same of the lowest slab, of whose lower face one component is held.
template <typename T>
SmallMatrix<T, 2> put_on_floor(const ThinSlab<T, 2>& slab, int held, SmallMatrix<T, 2>& stiffness) {
  stiffness = held_below(slab, held).stiffness;
  const T over = 1.0 / slab.compliance(held, held);
  return matrix_of<2>([&](int i, int j) {
    return i == held ? T(0.0) : slab.transfer(i, j) - slab.compliance(i, held) * over * slab.transfer(held, j);
  });
}

}  // namespace

DepthResponse::DepthResponse(const Sheets& part, const std::vector<double>& depths) : part_(part) {
  std::vector<double> faces{0.0};
  for (const Sheet& sheet : part.all) faces.push_back(faces.back() + sheet.thickness);
  const double thickness = faces.back();
  const bool half = part.floor != Floor::free;
  const auto inside = [&](double depth) {
    return std::clamp(half && depth > thickness ? 2.0 * thickness - depth : depth, 0.0, thickness);
  };
  std::vector<double> levels = faces;
  for (const double depth : depths) levels.push_back(inside(depth));
  std::sort(levels.begin(), levels.end());
  constexpr double rounding = 1e-13;
  const auto same = [&](double a, double b) { return b - a <= rounding * thickness; };
  levels.erase(std::unique(levels.begin(), levels.end(), same), levels.end());
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    const double middle = 0.5 * (levels[i] + levels[i + 1]);
    const auto sheet = std::upper_bound(faces.begin(), faces.end() - 1, middle) - faces.begin() - 1;
    pieces_.push_back({static_cast<std::size_t>(sheet), levels[i + 1] - levels[i]});
  }
  for (const double depth : depths) {
    const bool mirrored = half && depth > thickness;
    const double place = inside(depth);
    const auto level = std::find_if(levels.begin(), levels.end(),
                                    [&](double each) { return same(std::min(each, place), std::max(each, place)); });
    const double sign = part.floor == Floor::symmetric ? 1.0 : -1.0;
    places_.push_back(
        {static_cast<std::size_t>(level - levels.begin()), mirrored ? sign : 1.0, mirrored ? -sign : 1.0});
  }
}

template <typename T>
Depths<T> DepthResponse::at(double wave_number, T z, double deepest) const {
  std::size_t end = 0;  // pieces that are not below the deepest
  for (double depth = 0.0; end < pieces_.size() && depth < deepest; ++end) depth += pieces_[end].thickness;
  const int held = end < pieces_.size() || part_.floor == Floor::free ? -1 : part_.floor == Floor::symmetric ? 1 : 0;
  SmallMatrix<T, 2> stiffness;
  const SmallMatrix<T, 2> unchanged = plus(1.0, SmallMatrix<T, 2>{});
  std::vector<SmallMatrix<T, 2>> through(pieces_.size() + 1);
  for (std::size_t i = end; i-- > 0;) {
    int count = 0;
    const auto slab = slab_of<T>(part_.all[pieces_[i].sheet], pieces_[i].thickness, wave_number, z, count);
    through[i + 1] = unchanged;
    for (int n = 0; n < count; ++n) {
      const bool lowest = i + 1 == end && n == 0 && held >= 0;
      const SmallMatrix<T, 2> moved = lowest ? put_on_floor<T>(slab, held, stiffness) : put_on<T>(slab, stiffness);
      through[i + 1] = through[i + 1] * moved;
    }
  }
  through[0] = unchanged;
  for (std::size_t i = 0; i < end; ++i) through[i + 1] = through[i + 1] * through[i];
  Depths<T> depths{stiffness, {}};
  for (const Place& place : places_) {
    const SmallMatrix<T, 2>& transfer = through[place.pieces];
    depths.transfer.push_back(
        matrix_of<2>([&](int i, int j) { return (i == 0 ? place.along : place.into) * transfer(i, j); }));
  }
  return depths;
}

bool DepthResponse::are_on_faces() const {
  return std::all_of(places_.begin(), places_.end(), [](const Place& place) { return place.pieces == 0; });
}

Depths<double> DepthResponse::on_faces() const {
  Depths<double> depths;
  for (const Place& place : places_) depths.transfer.push_back({{{{place.along, 0.0}, {0.0, place.into}}}});
  return depths;
}

template Depths<double> DepthResponse::at<double>(double, double, double) const;
template Depths<Complex> DepthResponse::at<Complex>(double, Complex, double) const;

namespace {

using Eigen::Index;

constexpr double as_deep_as_it_is = std::numeric_limits<double>::infinity();

std::vector<DepthResponse> all_of(const std::vector<Sheets>& parts, const std::vector<double>& depths) {
  std::vector<DepthResponse> all;
  all.reserve(parts.size());
  for (const Sheets& part : parts) all.emplace_back(part, depths);
  return all;
}

/// How one wave moves all depths. Along k it is the motion towards −k that goes with motion into the depth
/// (PlaneWaves).
Eigen::VectorXd profile(const DepthResponse& response, double k, const Amplitude& wave) {
  const Depths<double> depths =
      response.are_on_faces() ? response.on_faces() : response.at<double>(k, wave.omega * wave.omega, as_deep_as_it_is);
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
