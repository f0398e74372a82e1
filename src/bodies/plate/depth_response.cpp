#include "bodies/plate/depth_response.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/plate/slab.hpp"

namespace stoss::bodies::plate {
namespace {

template <typename T>
using Matrix2 = Eigen::Matrix<T, 2, 2>;

/// How many equal slabs a piece is cut into so that none has a vibration, whatever of it is held; and one of them.
template <typename T>
ThinSlab<T, 2> thin_slab(const Sheet& sheet, double thickness, double k, T z, int& count) {
  constexpr double thinnest = 0.0075, thickest = 1.0;  // phases
  const double square = magnitude(z) * sheet.density / sheet.shear_modulus;
  const double phase = thickness * std::max(k, std::sqrt(square));
  count = std::max(1, static_cast<int>(std::ceil(phase / thickest)));
  const int doublings = std::max(0, static_cast<int>(std::ceil(std::log2(phase / count / thinnest))));
  ThinSlab<T, 2> slab = series<T, 2>(equations<2, T>(sheet, k, z), std::ldexp(thickness / count, -doublings));
  for (int n = 0; n < doublings; ++n) slab = doubled(slab);
  return slab;
}

/// Puts a slab on what has a stiffness. @return how it moves its lower face
template <typename T>
Matrix2<T> put_on(const ThinSlab<T, 2>& slab, Matrix2<T>& stiffness) {
  const Matrix2<T> softened = Matrix2<T>::Identity() + slab.compliance * stiffness;
  const Matrix2<T> inverse = softened.inverse(), moved = inverse * slab.transfer;
  stiffness = slab.stiffness + slab.transfer.transpose() * (stiffness * moved);
  return moved;
}

/// The same of the lowest slab, of whose lower face one component is held.
template <typename T>
Matrix2<T> put_on_floor(const ThinSlab<T, 2>& slab, int held, Matrix2<T>& stiffness) {
  stiffness = held_below(slab, held).stiffness;
  const T over = T(1.0) / slab.compliance(held, held);
  Matrix2<T> moved = slab.transfer;
  moved -= slab.compliance.col(held) * (over * slab.transfer.row(held));
  moved.row(held).setZero();
  return moved;
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
  Matrix2<T> stiffness = Matrix2<T>::Zero();
  std::vector<Matrix2<T>> through(pieces_.size() + 1, Matrix2<T>::Zero());
  for (std::size_t i = end; i-- > 0;) {
    int count = 0;
    const auto slab = thin_slab<T>(part_.all[pieces_[i].sheet], pieces_[i].thickness, wave_number, z, count);
    through[i + 1] = Matrix2<T>::Identity();
    for (int n = 0; n < count; ++n) {
      const bool lowest = i + 1 == end && n == 0 && held >= 0;
      const Matrix2<T> moved = lowest ? put_on_floor<T>(slab, held, stiffness) : put_on<T>(slab, stiffness);
      through[i + 1] = (through[i + 1] * moved).eval();
    }
  }
  through[0] = Matrix2<T>::Identity();
  for (std::size_t i = 0; i < end; ++i) through[i + 1] = (through[i + 1] * through[i]).eval();
  Depths<T> depths{stiffness, {}};
  for (const Place& place : places_) {
    Matrix2<T> transfer = through[place.pieces];
    transfer.row(0) *= T(place.along);
    transfer.row(1) *= T(place.into);
    depths.transfer.push_back(transfer);
  }
  return depths;
}

template Depths<double> DepthResponse::at<double>(double, double, double) const;
template Depths<Complex> DepthResponse::at<Complex>(double, Complex, double) const;

}  // namespace stoss::bodies::plate
