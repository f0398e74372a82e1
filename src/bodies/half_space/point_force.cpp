#include "bodies/half_space/point_force.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "numeric/quadrature.hpp"

namespace stoss::bodies::half_space {
namespace {

using Complex = std::complex<double>;
constexpr double squared_pi = std::numbers::pi * std::numbers::pi;

Displaced operator+(const Displaced& a, const Displaced& b) { return {a.normal + b.normal, a.radial + b.radial}; }
Displaced operator*(double factor, const Displaced& of) { return {factor * of.normal, factor * of.radial}; }

template <typename Function>
Displaced gauss(const Function& function, double from, double to, int nodes) {
  const auto& rule = numeric::gauss_legendre(nodes);
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  Displaced sum;
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    sum = sum + half * rule.weight[i] * function(middle + half * rule.node[i]);
  }
  return sum;
}

constexpr int nodes_of_panel = 10;

/// By halves until both agree with the whole.
template <typename Function>
Displaced halved(const Function& function, double from, double to, const Displaced& whole, double small, int depth) {
  const double middle = 0.5 * (from + to);
  const Displaced left = gauss(function, from, middle, nodes_of_panel),
                  right = gauss(function, middle, to, nodes_of_panel);
  const Displaced both = left + right;
  const double apart = std::max(std::abs(both.normal - whole.normal), std::abs(both.radial - whole.radial));
  if (depth == 0 || !(apart > small)) return both;
  return halved(function, from, middle, left, small, depth - 1) + halved(function, middle, to, right, small, depth - 1);
}

template <typename Function>
Displaced integral(const Function& function, double from, double to, double small) {
  constexpr int most_halvings = 24;
  if (!(to > from)) return {};
  return halved(function, from, to, gauss(function, from, to, nodes_of_panel), small, most_halvings);
}

constexpr double accuracy = 1e-11;  // of integrals of the order of 1

/// (f_z, f_r) of a wave at slownesses q and p.
struct Kernel {
  Complex normal, radial, eta;  ///< η of the wave itself
};

Kernel kernel_at(Complex q, double p, double slowness, bool shear) {
  const Complex square = p * p - q * q, eta_s = std::sqrt(1.0 + square);
  Complex eta_p = std::sqrt(slowness * slowness + square);
  if (q.imag() == 0.0 && eta_p.real() == 0.0) eta_p = Complex(0.0, -std::abs(eta_p.imag()));  // above the cut
  const Complex sum = 2.0 * square + 1.0, product = eta_p * eta_s;
  const Complex over = 1.0 / (sum * sum - 4.0 * square * product);
  if (shear) return {-2.0 * square * eta_p * over, -2.0 * q * product * over, eta_s};
  return {eta_p * sum * over, q * sum * over, eta_p};
}

}  // namespace

PointForce::PointForce(double poisson, double distance, double depth)
    : kernel_(lamb_kernel(poisson)),
      distance_(distance),
      depth_(depth),
      range_(std::hypot(distance, depth)),
      slowness_(std::sqrt(kernel_.squared_ratio)) {
  const double x = kernel_.rayleigh_root, square = x * x, eta = kernel_.squared_ratio;
  const double a = std::sqrt(1.0 - eta * square), b = std::sqrt(1.0 - square);
  const double slope = 4.0 * x * (eta * b / a + a / b - 2.0 + square);
  radial_weight_ = -2.0 * x * (2.0 - square - 2.0 * a * b) / ((1.0 - poisson) * slope);
  constexpr double shallow = 1e-9;
  if (depth_ < shallow * distance_) depth_ = 0.0;
  arrivals_ = {slowness_ * range_, range_};
  if (distance_ > x * slowness_ * range_) arrivals_.push_back(distance_ / x);
  if (depth_ > 0.0 && distance_ > slowness_ * range_) {
    head_ = slowness_ * distance_ + std::sqrt(1.0 - eta) * depth_;
    const double last = distance_ * distance_ - eta * range_ * range_;  // p² z² at which P and S arrive together
    head_end_ = range_ * std::sqrt(1.0 + last / (depth_ * depth_));
    arrivals_.insert(arrivals_.end(), {head_, head_end_});
  }
  std::sort(arrivals_.begin(), arrivals_.end());
}

Displaced PointForce::at(double time) const {
  if (time <= arrivals_.front()) return {};
  if (depth_ == 0.0) return on_surface(time);
  // Long after the waves the answers of both cancel in more and more digits, and what is left falls as 1/t².
  constexpr double late = 25.0;
  const double end = late * range_ / kernel_.rayleigh_root;
  if (time > end) {
    const double share = (end / time) * (end / time);
    return share * at(end) + (1.0 - share) * at_rest();
  }
  Displaced sum = of_front(time, false);
  if (time > range_) sum = sum + of_front(time, true);
  if (head_ >= 0.0 && time > head_ && time < head_end_) sum = sum + of_head_wave(time);
  return sum;
}

Displaced PointForce::at_rest() const {
  const double nu = kernel_.poisson, over = 1.0 / (4.0 * std::numbers::pi * range_), sine = depth_ / range_;
  return {over * (2.0 * (1.0 - nu) + sine * sine),
          over * (distance_ / range_) * (sine - (1.0 - 2.0 * nu) / (1.0 + sine))};
}

Displaced PointForce::of_front(double time, bool shear) const {
  const double slow = shear ? 1.0 : slowness_;
  const double arrival = slow * range_;
  const double most = std::sqrt((time - arrival) * (time + arrival)) / range_;  // of p
  const auto integrand = [&](double phase) -> Displaced {
    const double p = most * std::sin(phase);
    const Complex q(time * distance_ / (range_ * range_), depth_ / range_ * most * std::cos(phase));
    const Kernel its = kernel_at(q, p, slowness_, shear);
    return {(its.normal * its.eta).real(), (its.radial * its.eta).real()};
  };
  // The pole of the Rayleigh wave is nearest where q + 0i would meet it.
  const double along = time * distance_ / (range_ * range_), x = kernel_.rayleigh_root;
  const double pole = along * along - 1.0 / (x * x);
  const double nearest = pole > 0.0 && pole < most * most ? std::asin(std::sqrt(pole) / most) : 0.25 * std::numbers::pi;
  const double small = accuracy * std::max(1.0, time * time / (range_ * range_));
  const Displaced all =
      integral(integrand, 0.0, nearest, small) + integral(integrand, nearest, 0.5 * std::numbers::pi, small);
  return 1.0 / (squared_pi * range_) * all;
}

Displaced PointForce::of_head_wave(double time) const {
  const double eta = kernel_.squared_ratio;
  const double first = (time - std::sqrt(1.0 - eta) * depth_) / distance_;  // q where its front is
  const double end = std::sqrt(std::max(0.0, (first - slowness_) * (first + slowness_)));
  const double early = (range_ - time) * (range_ + time) / (range_ * range_);  // 1 − t²/R²
  constexpr double nearest = 1e-9;
  const double unit = std::max(nearest, std::sqrt(std::abs(early)));
  const bool before = early > 0.0;  // the arrival of shear waves
  if (!before && end <= unit) return {};
  const double reach = before ? std::asinh(end / unit) : std::acosh(end / unit);
  const auto integrand = [&](double place) -> Displaced {
    const double y = reach * (1.0 - place * place);  // η_p begins as a root at the end
    const double p = unit * (before ? std::sinh(y) : std::cosh(y));
    const double left = range_ * unit * (before ? std::cosh(y) : std::sinh(y));  // √(R²(1 + p²) − t²)
    const double q = (time * distance_ - depth_ * left) / (range_ * range_);
    const Kernel its = kernel_at(Complex(q, 0.0), p, slowness_, true);
    const double weight = 2.0 * place * reach;
    return {weight * (its.normal * its.eta).imag(), weight * (its.radial * its.eta).imag()};
  };
  return 1.0 / (squared_pi * range_) * integral(integrand, 0.0, 1.0, accuracy);
}

Displaced PointForce::on_surface(double time) const {
  const double tau = time / distance_, x_r = kernel_.rayleigh_root, fastest = 1.0 / slowness_;
  const double first = std::max(1.0, 1.0 / tau);
  const auto& weight = kernel_.rayleigh_weight;
  Displaced sum{1.0, 0.0};
  if (x_r * tau < 1.0) {
    sum.normal -= weight / (x_r * x_r) / std::sqrt((1.0 - x_r * tau) * (1.0 + x_r * tau));
  } else {
    sum.radial += radial_weight_ / x_r * tau / std::sqrt((x_r * tau - 1.0) * (x_r * tau + 1.0));
  }
  if (x_r * tau > 1.0 && tau > 1.0) sum.normal = 1.0;
  // Normal: x = 1 … 1/τ, which waves have not arrived; radial: those that have, up to pressure waves.
  if (tau < 1.0) {
    const double length = 1.0 / tau - 1.0;
    const auto missing = [&](double angle) -> Displaced {
      const double sine = std::sin(angle), x = 1.0 + length * sine * sine;
      return {kernel_.density(x) / (x * x) * 2.0 * sine * std::sqrt(length / (tau * (1.0 + x * tau))), 0.0};
    };
    sum.normal -= integral(missing, 0.0, 0.5 * std::numbers::pi, accuracy).normal;
  }
  const double length = fastest - first;
  const auto radial = [&](double angle) -> Displaced {
    const double sine = std::sin(angle), cosine = std::cos(angle), square = sine * sine;
    const double x = first + length * square;
    const double a = std::sqrt((1.0 + slowness_ * x) * slowness_ * length) * cosine;
    const double b = std::sqrt((first - 1.0 + length * square) * (x + 1.0));
    const double bend = 2.0 - x * x, divisor = bend * bend * bend * bend + 16.0 * a * a * b * b;
    const double density = -4.0 / std::numbers::pi * x * x * x * a * b * bend / ((1.0 - kernel_.poisson) * divisor);
    const double late = std::max(0.0, tau - 1.0) + tau * length * square;  // xτ − 1
    return {0.0, density / x * tau / std::sqrt(late * (x * tau + 1.0)) * 2.0 * length * sine * cosine};
  };
  sum.radial += integral(radial, 0.0, 0.5 * std::numbers::pi, accuracy).radial;
  return (1.0 - kernel_.poisson) / (2.0 * std::numbers::pi * distance_) * sum;
}

}  // namespace stoss::bodies::half_space
