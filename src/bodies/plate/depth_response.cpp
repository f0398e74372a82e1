#include "bodies/plate/depth_response.hpp"

#include <algorithm>
#include <cmath>

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

template Depths<double> DepthResponse::at<double>(double, double, double) const;
template Depths<Complex> DepthResponse::at<Complex>(double, Complex, double) const;

}  // namespace stoss::bodies::plate
