#include "bodies/half_space/surface_waves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "numeric/quadrature.hpp"

namespace stoss::bodies::half_space {
namespace {

using numeric::gauss_legendre;

/// Nodes of Gauss' rule that follow e^{iφ} over a range of the phase φ.
int nodes_for(double phase, double more) { return static_cast<int>(std::ceil(0.25 * phase + more)); }

/// ρ from 1, where it begins like √(x − 1), to `end` below the speed of pressure waves: Gauss' rule of twice as many
/// nodes in √(x − 1), of which half lie on either side of 0, is that of Jacobi with this weight; with one more node in
/// the middle, where nothing is, unless it begins like 1/√(x − 1).
void add_shear_part(const Continuum& its, double end, int nodes, Piece& piece) {
  const int middle = its.spectrum.steep ? 0 : 1;
  const auto& rule = gauss_legendre(2 * nodes + middle);
  const double length = end - 1.0;
  for (auto i = static_cast<std::size_t>(nodes) + static_cast<std::size_t>(middle); i < rule.node.size(); ++i) {
    const double u = rule.node[i], x = 1.0 + length * u * u;
    piece.x.push_back(x);
    piece.weight.push_back(its.density(x) * 2.0 * length * u * rule.weight[i]);
  }
}

/// ρ between two values of x, where it goes on like a series in √(x − root).
void add_root_part(const Continuum& its, double root, double begin, double end, int nodes, Piece& piece) {
  const auto& rule = gauss_legendre(nodes);
  const double low = std::sqrt(begin - root), high = std::sqrt(end - root);
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    const double u = 0.5 * (low + high) + 0.5 * (high - low) * rule.node[i], x = root + u * u;
    piece.x.push_back(x);
    piece.weight.push_back(its.density(x) * u * (high - low) * rule.weight[i]);
  }
}

void add_smooth_part(const Continuum& its, double begin, double end, int nodes, Piece& piece) {
  const auto& rule = gauss_legendre(nodes);
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    const double x = 0.5 * (begin + end) + 0.5 * (end - begin) * rule.node[i];
    piece.x.push_back(x);
    piece.weight.push_back(its.density(x) * 0.5 * (end - begin) * rule.weight[i]);
  }
}

/// Wave numbers up to which pressure, shear and Rayleigh waves are kept, and the speeds of the waves that turn fastest.
struct Panels {
  std::array<double, 4> end;
  std::array<double, 3> speed;
};

Panels panels(const Medium& medium, double cutoff) {
  const double rayleigh_speed = medium.kernel.rayleigh_root * medium.shear_speed;
  return {{0.0, cutoff / medium.pressure_speed, cutoff / medium.shear_speed, cutoff / rayleigh_speed},
          {medium.pressure_speed, medium.shear_speed, rayleigh_speed}};
}

constexpr double root_reach = 1.3;  // of the part with a root, in speeds of pressure waves

}  // namespace

double Continuum::pressure_speed() const { return 1.0 / std::sqrt(kernel.squared_ratio); }

Piece Continuum::up_to(double end, double turns) const {
  Piece piece;
  if (end <= 1.0) return piece;
  const double pressure = pressure_speed();
  const auto nodes = [turns](double length, double more) { return nodes_for(turns * length, more); };
  const double shear_end = std::min(end, pressure);
  add_shear_part(*this, shear_end, nodes(shear_end - 1.0, 4.0 + 5.0 * shear_end), piece);
  if (end <= pressure) return piece;
  const double root_end = std::min(end, root_reach * pressure);
  add_root_part(*this, pressure, pressure, root_end, nodes(2.0 * (root_end - pressure), 6.0), piece);
  // Its moments fall as powers of x: none of the parts is much longer than it is far from 0.
  constexpr double widest = 4.0;
  for (double from = root_end; from < end;) {
    const double to = end < 1.5 * widest * from ? end : widest * from;
    add_smooth_part(*this, from, to, nodes(to - from, 4.0), piece);
    from = to;
  }
  return piece;
}

Rest Continuum::beyond(double x) const {
  constexpr int nodes = 32;
  const double pressure = pressure_speed();
  Piece piece;
  double from = std::max(x, 1.0);
  if (from < pressure) {
    add_root_part(*this, 1.0, from, pressure, nodes, piece);
    from = pressure;
  }
  if (from < root_reach * pressure) {
    add_root_part(*this, pressure, from, root_reach * pressure, nodes, piece);
    from = root_reach * pressure;
  }
  Rest rest;
  for (std::size_t i = 0; i < piece.x.size(); ++i) {
    const double square = piece.x[i] * piece.x[i];
    rest.compliance += piece.weight[i] / square;
    rest.moment += piece.weight[i] / (square * square);
  }
  // In 1/x, where ρ is smooth.
  const auto& rule = gauss_legendre(nodes);
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    const double inverse = 0.5 * (1.0 + rule.node[i]) / from;
    const double weight = density(1.0 / inverse) * 0.5 * rule.weight[i] / from;
    rest.compliance += weight;
    rest.moment += weight * inverse * inverse;
  }
  return rest;
}

std::vector<WaveNumber> wave_numbers(const Medium& medium, double cutoff, double duration) {
  constexpr double surplus = 1.1, more = 8.0;
  const double time = share_of_duration * duration;
  const auto [end, speed] = panels(medium, cutoff);
  std::vector<WaveNumber> all;
  for (std::size_t p = 0; p < speed.size(); ++p) {
    const double middle = 0.5 * (end[p] + end[p + 1]), half = 0.5 * (end[p + 1] - end[p]);
    const auto& rule = gauss_legendre(nodes_for(surplus * 2.0 * half * speed[p] * time, more));
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      all.push_back({middle + half * rule.node[i], half * rule.weight[i]});
    }
  }
  return all;
}

namespace {

SurfaceWaves waves_of(const Medium& medium, double wave_number, double weight, double cutoff, double time) {
  const double unit = medium.shear_speed * wave_number;  // ω of x = 1
  const double whole = medium.compliance(wave_number) * weight;
  SurfaceWaves waves{wave_number, weight, {}, {}, 0.0, 0.0};
  for (const Spectrum& spectrum : medium.spectra) {
    const double compliance = whole * spectrum.share;
    const auto keep = [&](double x, double share) {
      waves.omega.push_back(std::min(unit * x, cutoff));  // rounding
      waves.strength.push_back(compliance * unit * unit * share);
    };
    const double end = cutoff / unit;
    const Continuum its{medium.kernel, spectrum};
    const Piece kept = its.up_to(end, unit * time);
    waves.omega.reserve(waves.omega.size() + 1 + kept.x.size());
    waves.strength.reserve(waves.strength.size() + 1 + kept.x.size());
    if (spectrum.rayleigh_weight > 0.0) keep(medium.kernel.rayleigh_root, spectrum.rayleigh_weight);
    for (std::size_t i = 0; i < kept.x.size(); ++i) keep(kept.x[i], kept.weight[i]);
    const Rest rest = its.beyond(end);
    waves.residual_compliance += compliance * rest.compliance;
    waves.residual_second_moment += compliance * rest.moment / (unit * unit);
  }
  return waves;
}

}  // namespace

std::vector<SurfaceWaves> surface_waves(const Medium& medium, double cutoff, double duration, const Poll& poll) {
  const double time = share_of_duration * duration;
  std::vector<SurfaceWaves> all;
  for (const auto& [k, weight] : wave_numbers(medium, cutoff, duration)) {
    if (poll) poll();
    all.push_back(waves_of(medium, k, weight, cutoff, time));
  }
  return all;
}

double cutoff_of_count(const Medium& medium, double count, double duration) {
  // count = (2.3 turns + wave_numbers)(turns + nodes), turns = ¼ H ω
  const double nodes = 5.0 / std::sqrt(medium.kernel.squared_ratio) + 16.0;
  constexpr double surplus = 2.3, wave_numbers = 24.0;
  const double half = 0.5 * (nodes + wave_numbers / surplus);
  const double turns = std::sqrt(half * half + (count - wave_numbers * nodes) / surplus) - half;
  return 4.0 * turns / (share_of_duration * duration);
}

}  // namespace stoss::bodies::half_space
