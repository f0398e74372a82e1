#include "bodies/plate/plate_waves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>

#include "bodies/plate/branches.hpp"
#include "bodies/plate/energy_shares.hpp"

namespace stoss::bodies::plate {
namespace {

/// Frequencies of modes at the last wave numbers, as far as they tell those at the next.
class Track {
 public:
  /// Those of the parabolas through the last three.
  [[nodiscard]] std::vector<double> ahead(double k) const {
    std::vector<double> guess = past_.empty() ? std::vector<double>{} : past_.back().omega;
    for (const Past& each : past_) guess.resize(std::min(guess.size(), each.omega.size()));
    for (double& omega : guess) omega = 0.0;
    for (const Past& each : past_) {
      double weight = 1.0;
      for (const Past& other : past_) {
        if (other.k != each.k) weight *= (k - other.k) / (each.k - other.k);
      }
      for (std::size_t m = 0; m < guess.size(); ++m) guess[m] += weight * each.omega[m];
    }
    std::sort(guess.begin(), guess.end());
    return guess;
  }

  void add(double k, const std::vector<double>& omega) {
    constexpr std::size_t most = 5;
    past_.push_back({k, omega});
    if (past_.size() > most) past_.erase(past_.begin());
  }

 private:
  struct Past {
    double k;
    std::vector<double> omega;
  };
  std::vector<Past> past_;
};

/// Of each part of a plate.
using Tracks = std::vector<Track>;

/// Along k it is the motion towards −k that goes with motion into the depth (PlaneWaves).
Flexibility flexibility(const Eigen::Matrix2d& response, double weight) {
  return {weight * response(1, 1), -weight * response(0, 1), weight * response(0, 0)};
}

void add(const Flexibility& more, Flexibility& sum) {
  sum.radial += more.radial;
  sum.mixed += more.mixed;
  sum.tangential += more.tangential;
}

/// The moduli of modes in each kind of layers at first: shares of their energy over those that the layers have here.
///
/// Modes that are slow enough to swing in the impact have their own shares. Together the others follow the force, in a
/// field in which each by itself would have too much: they share what the energy of the static field leaves for them.
/// Beside long waves, whose bending is nearly all of it, that has no digits.
template <int N>
void add_moduli(const Lamina& plate, const Sheets& sheets, double k, const Branches<N>& its,
                std::vector<double>& moduli) {
  const std::size_t kinds = plate.stiffness.size();
  if (kinds == 0) return;
  constexpr double digits = 1e-4;
  std::vector<double> left = static_energies<N>(sheets, k, kinds);
  double sum = std::accumulate(left.begin(), left.end(), 0.0);
  const double least = digits * sum;
  std::size_t m = 0;
  const auto add = [&](const std::vector<double>& shares) {
    for (std::size_t i = 0; i < kinds; ++i) moduli.push_back(shares[i] / plate.stiffness[i]);
  };
  for (; m < its.omega.size() && its.omega[m] <= plate.swinging; ++m) {
    const std::vector<double> own = energy_shares<N>(sheets, k, its.omega[m], its.amplitude[m], kinds);
    const double compliance = std::pow(its.amplitude[m](N - 1) / its.omega[m], 2);
    for (std::size_t i = 0; i < kinds; ++i) left[i] -= compliance * own[i];
    add(own);
  }
  for (double& energy : left) energy = std::max(energy, 0.0);
  sum = std::accumulate(left.begin(), left.end(), 0.0);
  const bool has_digits = sum > least;
  for (double& energy : left) energy /= sum;
  for (; m < its.omega.size(); ++m) {
    add(has_digits ? left : energy_shares<N>(sheets, k, its.omega[m], its.amplitude[m], kinds));
  }
}

PlaneWaves waves_of(const Lamina& plate, const WaveNumber& number, double cutoff, Tracks& tracks, const Poll& poll) {
  const double weight = plate.weight(number.k) * number.weight;
  PlaneWaves waves{number.k, number.weight, {}, {}, {}, {}, {}};
  const std::vector<Sheets>& parts = plate.parts(number.k);
  if (tracks.size() != parts.size()) tracks.assign(parts.size(), {});
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const Sheets sheets = reached(parts[part], number.k, cutoff);
    const Branches<2> its = branches<2>(sheets, number.k, cutoff, tracks[part].ahead(number.k), poll);
    const double share = weight * sheets.share, scale = std::sqrt(share);
    for (std::size_t m = 0; m < its.omega.size(); ++m) {
      waves.omega.push_back(its.omega[m]);
      waves.normal.push_back(scale * its.amplitude[m](1));
      waves.along.push_back(-scale * its.amplitude[m](0));
    }
    add_moduli(plate, sheets, number.k, its, waves.moduli);
    add(flexibility(its.compliance, share), waves.residual_compliance);
    add(flexibility(its.second_moment, share), waves.residual_second_moment);
    tracks[part].add(number.k, its.omega);
  }
  return waves;
}

template <typename Response>
Flexibility sum_over_parts(const Lamina& plate, double k, const Response& response) {
  Flexibility sum;
  for (const Sheets& part : plate.parts(k)) add(flexibility(response(part, k), plate.weight(k) * part.share), sum);
  return sum;
}

/// Of waves polarised along the surface.
template <typename Response>
double sum_across(const Lamina& plate, double k, const Response& response) {
  double sum = 0.0;
  for (const Sheets& part : plate.parts(k)) sum += plate.weight(k) * part.share * response(part, k)(0, 0);
  return sum;
}

}  // namespace

double Lamina::weight(double wave_number) const {
  return contour == Contour::ball ? 0.5 * wave_number / std::numbers::pi : 1.0 / std::numbers::pi;
}

Lamina lamina(Contour contour, std::vector<Sheet> sheets, std::vector<double> stiffness, double swinging) {
  Lamina plate{};
  plate.stiffness = std::move(stiffness);
  plate.swinging = swinging;
  plate.contour = contour;
  plate.whole = {{sheets}};
  plate.halves = parts_of(sheets);
  plate.sheets = std::move(sheets);
  for (const Sheet& sheet : plate.sheets) {
    plate.thickness += sheet.thickness;
    plate.pressure_speed = std::max(plate.pressure_speed, std::sqrt(sheet.pressure_modulus / sheet.density));
    plate.shear_speed = std::max(plate.shear_speed, std::sqrt(sheet.shear_modulus / sheet.density));
  }
  return plate;
}

std::vector<PlaneWaves> plane_waves(const Lamina& plate, double cutoff, double duration, const Poll& poll) {
  Tracks tracks;
  std::vector<PlaneWaves> all;
  for (const WaveNumber& number : wave_numbers(plate, cutoff, duration, poll)) {
    if (poll) poll();
    all.push_back(waves_of(plate, number, cutoff, tracks, poll));
  }
  return all;
}

std::vector<SurfaceWaves> normal_waves(const std::vector<PlaneWaves>& waves) {
  std::vector<SurfaceWaves> all;
  for (const PlaneWaves& from : waves) {
    SurfaceWaves normal{from.wave_number,
                        from.weight,
                        from.omega,
                        {},
                        from.residual_compliance.radial,
                        from.residual_second_moment.radial,
                        from.moduli};
    for (const double amplitude : from.normal) normal.strength.push_back(amplitude * amplitude);
    all.push_back(std::move(normal));
  }
  return all;
}

std::vector<SurfaceWaves> waves_along(const std::vector<PlaneWaves>& waves, const Lamina& plate, double cutoff,
                                      const Poll& poll) {
  constexpr double half = 0.5;
  Tracks tracks;
  std::vector<SurfaceWaves> all;
  for (const PlaneWaves& from : waves) {
    if (poll) poll();
    SurfaceWaves along{from.wave_number,
                       from.weight,
                       from.omega,
                       {},
                       half * from.residual_compliance.tangential,
                       half * from.residual_second_moment.tangential,
                       from.moduli};
    for (const double amplitude : from.along) along.strength.push_back(half * amplitude * amplitude);
    const std::vector<Sheets>& parts = plate.parts(from.wave_number);
    if (tracks.size() != parts.size()) tracks.assign(parts.size(), {});
    for (std::size_t part = 0; part < parts.size(); ++part) {
      const Sheets sheets = reached(parts[part], from.wave_number, cutoff);
      const Branches<1> across =
          branches<1>(sheets, from.wave_number, cutoff, tracks[part].ahead(from.wave_number), poll);
      add_moduli(plate, sheets, from.wave_number, across, along.moduli);
      const double share = half * from.weight * plate.weight(from.wave_number) * parts[part].share;
      for (std::size_t m = 0; m < across.omega.size(); ++m) {
        along.omega.push_back(across.omega[m]);
        along.strength.push_back(share * across.amplitude[m](0) * across.amplitude[m](0));
      }
      along.residual_compliance += share * across.compliance(0, 0);
      along.residual_second_moment += share * across.second_moment(0, 0);
      tracks[part].add(from.wave_number, across.omega);
    }
    all.push_back(std::move(along));
  }
  return all;
}

Flexibility plane_compliance(const Lamina& plate, double wave_number) {
  return sum_over_parts(plate, wave_number, static_compliance<2>);
}

Flexibility plane_second_moment(const Lamina& plate, double wave_number) {
  return sum_over_parts(plate, wave_number, static_second_moment<2>);
}

double compliance_along(const Lamina& plate, double wave_number) {
  return 0.5 * (plane_compliance(plate, wave_number).tangential + sum_across(plate, wave_number, static_compliance<1>));
}

double second_moment_along(const Lamina& plate, double wave_number) {
  return 0.5 *
         (plane_second_moment(plate, wave_number).tangential + sum_across(plate, wave_number, static_second_moment<1>));
}

double cutoff_of_count(const Lamina& plate, double count, double duration) {
  // count = (a ω + b)(c ω + d): wave numbers, and modes of each.
  double modes = 0.0;
  for (const Sheet& sheet : plate.sheets) {
    modes += sheet.thickness / std::numbers::pi *
             (std::sqrt(sheet.density / sheet.pressure_modulus) + std::sqrt(sheet.density / sheet.shear_modulus));
  }
  const double a = 0.6 * share_of_duration * duration, b = 24.0, c = 0.6 * modes, d = 2.0;
  const double half = 0.5 * (a * d + b * c);
  return (std::sqrt(half * half + a * c * std::max(0.0, count - b * d)) - half) / (a * c);
}

}  // namespace stoss::bodies::plate
