// A disk as a body: its modes by order, and the compliance of the modes above the cutoff,
//   W_ij = (1/m) Σ_n [R^CC c_i c_j + R^CS (c_i s_j + s_i c_j) + R^SS s_i s_j],   R_n = F_n − Σ_kept (C,S)(C,S)ᵀ/ω²,
// n up to the Nyquist order π/h of the nodes. cos nφ_i cos nφ_j = ½[cos n(φ_i−φ_j) + cos n(φ_i+φ_j)] and its like
// reduce the double sum to three one-dimensional tables, which one fast Fourier transform each provides.
#include "stoss/bodies/disk.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <numbers>
#include <sstream>
#include <unsupported/Eigen/FFT>

#include "check.hpp"
#include "stoss/modes.hpp"

namespace stoss {
namespace {

constexpr double mass = std::numbers::pi;

struct Disk {
  double poisson;
  std::vector<int> orders;            // of the groups
  std::vector<Flexibility> residual;  // R_n for n = 0 … highest kept order

  [[nodiscard]] Flexibility residual_flexibility(int order) const {
    const auto n = static_cast<std::size_t>(order);
    return n < residual.size() ? residual[n] : static_flexibility(poisson, order);
  }
};

/// Greatest number ≤ n (n ≥ 4) without prime factors above 5, for which the Fourier transform is fast.
int smooth_below(int n) {
  for (;; --n) {
    int rest = n;
    for (const int factor : {2, 3, 5}) {
      while (rest % factor == 0) rest /= factor;
    }
    if (rest == 1) return n;
  }
}

/// Number of node spacings in a half circle for about `nodes` nodes within half_width.
int spacings(double half_width, int nodes) {
  require("half_width", half_width, {0.0, 0.5 * std::numbers::pi, false, true, "above 0 and up to pi/2"},
          "half-width of the contact grid in R");
  const double wanted = std::numbers::pi * nodes / half_width;
  require("nodes", static_cast<long>(std::min(wanted, 1e9)), 4, 5'000'000,
          "nodes in a half circle: nodes * pi / half_width");
  return smooth_below(static_cast<int>(wanted));
}

ContactGrid make_grid(const Disk& disk, double half_width, int nodes) {
  const double h = std::numbers::pi / spacings(half_width, nodes);
  const double pressure_speed = 1.0 / std::sqrt(1.0 - disk.poisson * disk.poisson);
  const double shear_speed = 1.0 / std::sqrt(2.0 * (1.0 + disk.poisson));
  const auto count = static_cast<std::size_t>(nodes);
  ContactGrid grid;
  std::vector<double> cosine(count), sine(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double phi = (static_cast<double>(i) + 0.5) * h;
    cosine[i] = std::cos(phi);
    sine[i] = std::sin(phi);
    grid.coordinate.push_back(phi);
    grid.recess.push_back(2.0 * std::sin(0.5 * phi) * std::sin(0.5 * phi));
    grid.measure.push_back(2.0 * h);
    grid.impedance.push_back(2.0 * h / (cosine[i] * cosine[i] / pressure_speed + sine[i] * sine[i] / shear_speed));
  }
  // cos nφ and sin nφ by rotation from one order to the next.
  std::vector<double> cosine_n(count, 1.0), sine_n(count, 0.0);
  int n = 0;
  grid.radial_shape.reserve(disk.orders.size() * count);
  grid.tangential_shape.reserve(disk.orders.size() * count);
  for (const int order : disk.orders) {
    for (; n < order; ++n) {
      for (std::size_t i = 0; i < count; ++i) {
        const double next = cosine_n[i] * cosine[i] - sine_n[i] * sine[i];
        sine_n[i] = sine_n[i] * cosine[i] + cosine_n[i] * sine[i];
        cosine_n[i] = next;
      }
    }
    for (std::size_t i = 0; i < count; ++i) grid.radial_shape.push_back(cosine_n[i] * cosine[i]);
    for (std::size_t i = 0; i < count; ++i) grid.tangential_shape.push_back(-sine_n[i] * sine[i]);
  }
  return grid;
}

/// Σ_n R_n cos(nmh) for R^CC and R^SS and Σ_n R^CS_n sin(nmh), n = 0 … π/h, for all m.
struct Tables {
  std::vector<double> radial, mixed, tangential;
};

Tables residual_tables(const Disk& disk, int nyquist, std::size_t size) {
  const auto period = 2 * static_cast<std::size_t>(nyquist);
  // Even in n in the real and imaginary part; odd in n and imaginary: one transform gives each family of sums.
  std::vector<std::complex<double>> even(period), odd(period), sums;
  for (int n = 0; n <= nyquist; ++n) {
    const Flexibility r = disk.residual_flexibility(n);
    const double half = n == 0 || n == nyquist ? 1.0 : 0.5;
    const auto up = static_cast<std::size_t>(n);
    const auto down = (period - up) % period;
    even[up] = even[down] = {half * r.radial, half * r.tangential};
    if (up != down) {
      odd[up] = {0.0, 0.5 * r.mixed};
      odd[down] = {0.0, -0.5 * r.mixed};
    }
  }
  Tables tables;
  Eigen::FFT<double> transform;
  transform.fwd(sums, even);
  for (std::size_t m = 0; m < size; ++m) {
    tables.radial.push_back(sums[m % period].real());
    tables.tangential.push_back(sums[m % period].imag());
  }
  transform.fwd(sums, odd);
  for (std::size_t m = 0; m < size; ++m) tables.mixed.push_back(sums[m % period].real());
  return tables;
}

std::vector<double> residual_compliance(const Disk& disk, const ContactGrid& grid) {
  const std::size_t count = grid.coordinate.size();
  if (count == 0) return {};
  const int nyquist = static_cast<int>(std::lround(0.5 * std::numbers::pi / grid.coordinate.front()));
  const Tables table = residual_tables(disk, nyquist, 2 * count);
  std::vector<double> cosine(count), sine(count), compliance(count * count);
  for (std::size_t i = 0; i < count; ++i) {
    cosine[i] = std::cos(grid.coordinate[i]);
    sine[i] = std::sin(grid.coordinate[i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const std::size_t apart = i - j;
      const std::size_t sum = i + j + 1;
      const double radial = cosine[i] * cosine[j] * (table.radial[sum] + table.radial[apart]);
      const double mixed = cosine[i] * sine[j] * (table.mixed[sum] - table.mixed[apart]) +
                           sine[i] * cosine[j] * (table.mixed[sum] + table.mixed[apart]);
      const double tangential = sine[i] * sine[j] * (table.tangential[apart] - table.tangential[sum]);
      compliance[i * count + j] = compliance[j * count + i] = 0.5 * (radial - mixed + tangential) / mass;
    }
  }
  return compliance;
}

}  // namespace

Body disk(double poisson, double cutoff) {
  const std::vector<Mode> modes = disk_modes(poisson, cutoff);
  auto disk = std::make_shared<Disk>();
  disk->poisson = poisson;

  Body body;
  for (const Mode& mode : modes) {
    if (body.groups.empty() || body.groups.back().order != mode.order) {
      body.groups.push_back({mode.order, {}, {}, {}});
      disk->orders.push_back(mode.order);
    }
    while (static_cast<int>(disk->residual.size()) <= mode.order) {
      disk->residual.push_back(static_flexibility(poisson, static_cast<int>(disk->residual.size())));
    }
    ModeGroup& group = body.groups.back();
    group.omega.push_back(mode.omega);
    group.radial.push_back(mode.radial);
    group.tangential.push_back(mode.tangential);
    const double compliance = 1.0 / (mode.omega * mode.omega);
    Flexibility& residual = disk->residual.back();
    residual.radial -= mode.radial * mode.radial * compliance;
    residual.mixed -= mode.radial * mode.tangential * compliance;
    residual.tangential -= mode.tangential * mode.tangential * compliance;
  }

  std::ostringstream name;
  name.precision(17);
  name << "disk poisson=" << poisson;
  body.name = name.str();
  body.mass = mass;
  body.extent = 1.0;
  body.cutoff = cutoff;
  body.max_half_width = 0.5 * std::numbers::pi;
  // Hertz in the plane, a = 2√F, with a fit of the greatest force to the impacts in tests/data/contact_hard_wall.csv.
  body.expected_half_width = [](double speed) {
    return 2.0 * std::sqrt(speed / std::sqrt(1.0 + std::log1p(1.0 / speed)));
  };
  body.grid = [disk](double half_width, int nodes) { return make_grid(*disk, half_width, nodes); };
  body.residual_compliance = [disk](const ContactGrid& grid) { return residual_compliance(*disk, grid); };
  return body;
}

BodyMaker disk(double poisson) {
  return [poisson](double cutoff) { return disk(poisson, cutoff); };
}

}  // namespace stoss
