#include "bodies/plate/pressed_plate.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "bodies/half_space/point_force.hpp"
#include "bodies/plate/driven_waves.hpp"
#include "bodies/plate/wave_profiles.hpp"
#include "numeric/bessel.hpp"
#include "numeric/quadrature.hpp"

namespace stoss::bodies::plate {
namespace {

double last_instant(const Instants& its) {
  return its.step * static_cast<double>(its.outputs * its.stride + its.before);
}

/// For which the quadrature over wave numbers must be good, so that it is for the distance, too.
double duration_of(const Lamina& plate, double distance, const Instants& instants) {
  constexpr double across = 0.2;  // of the speed, in layers of which others are far slower (wave_numbers)
  const double slowest = plate.shear_speed * (plate.sheets.size() > 1 ? across : 1.0);
  return (last_instant(instants) + distance / slowest) / share_of_duration;
}

/// 3 (sin x − x cos x)/x³
double spread(double x) {
  constexpr double small = 0.1;
  const double square = x * x;
  if (x < small) return 1.0 - square * (0.1 - square * (1.0 / 280.0 - square / 15120.0));
  return 3.0 * (std::sin(x) - x * std::cos(x)) / (x * square);
}

/// Of a half-space, under a static load of the wave number, per load: as J₀(kr) into the depth and J₁(kr) outwards.
half_space::Displaced at_rest(double poisson, double modulus, double k, double depth) {
  const double phase = k * depth, over = std::exp(-phase) / (4.0 * std::numbers::pi * modulus);
  return {over * (2.0 - 2.0 * poisson + phase), over * (phase - 1.0 + 2.0 * poisson)};
}

/// Share in which waves follow slowly: none of the slower half, more and more up to the cutoff, so that none of what is
/// fast is seen before it arrives.
double tapered(double omega) {
  const double above = std::clamp(2.0 * omega - 1.0, 0.0, 1.0);
  return 0.5 - 0.5 * std::cos(std::numbers::pi * above);
}

class Sum {
 public:
  Sum(const Lamina& plate, double poisson, double distance, double depth, const Instants& instants,
      const std::vector<PressedLoad>& loads)
      : plate_(plate),
        poisson_(poisson),
        distance_(distance),
        depth_(depth),
        instants_(instants),
        loads_(loads),
        near_(depth < 0.5 * plate.sheets.front().thickness),
        slow_(loads.size(), Slow{std::vector<double>(loads.front().force.size()), {}}),
        made_{std::vector<Motion>(loads.size(), Motion(instants.outputs)), Motion(instants.outputs)} {
    for (Slow& its : slow_) its.radial = its.normal;
  }

  /// Waves of a wave number, with what those above the cutoff add.
  void add(const WaveProfiles& profiles, double weight, const std::vector<Amplitude>& waves, double cutoff) {
    const double k = profiles.wave_number;
    const numeric::BesselJ01 shape = numeric::bessel_j01(k * distance_);
    half_space::Displaced rest{profiles.others(1), profiles.others(0)};
    if (near_) {
      const half_space::Displaced known = at_rest(poisson_, plate_.sheets.front().shear_modulus, k, depth_);
      rest.normal -= weight * known.normal, rest.radial -= weight * known.radial;
    }
    DrivenWaves driven(instants_);
    for (std::size_t l = 0; l < waves.size(); ++l) {
      const auto column = static_cast<Eigen::Index>(l);
      const double strength = -std::abs(waves[l].normal);  // a coordinate moves the surface against the depth
      driven.add(waves[l].omega, strength * shape.zeroth * profiles.kept(1, column),
                 strength * shape.first * profiles.kept(0, column), tapered(waves[l].omega / cutoff));
    }
    std::vector<double> force(loads_.front().force.size());
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      for (std::size_t j = 0; j < force.size(); ++j) {
        force[j] = loads_[i].force[j] * (loads_[i].radius[j] > 0.0 ? spread(k * loads_[i].radius[j]) : 1.0);
        slow_[i].normal[j] += shape.zeroth * rest.normal * force[j];
        slow_[i].radial[j] += shape.first * rest.radial * force[j];
      }
      if (!waves.empty()) driven.move(force, made_.motions[i], i == 0 ? &made_.unresolved : nullptr);
    }
  }

  /// Up to this wave number the plate is not like a half-space.
  [[nodiscard]] double last_wave_number() const {
    constexpr double like = 15.0, gone = 30.0;
    return near_ ? like / plate_.sheets.front().thickness : gone / depth_;
  }

  PressedPlate taken() {
    const double largest = *std::max_element(loads_.front().radius.begin(), loads_.front().radius.end());
    const Cross cross(largest);
    const auto known = [&](double distance) { return half_space::PointForce(poisson_, distance, depth_).at_rest(); };
    const double unit = 1.0 / plate_.sheets.front().shear_modulus;
    half_space::Displaced middle, around;
    if (near_) {
      middle = known(distance_);
      cross.around(distance_, [&](double distance, double normal, double radial) {
        const half_space::Displaced its = known(distance);
        around.normal += normal * its.normal, around.radial += radial * its.radial;
      });
    }
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      for (std::size_t j = 0; j < loads_[i].force.size(); ++j) {
        const double share = cross.share(loads_[i].radius[j]), force = unit * loads_[i].force[j];
        slow_[i].normal[j] += force * ((1.0 - share) * middle.normal + share * around.normal);
        slow_[i].radial[j] += force * ((1.0 - share) * middle.radial + share * around.radial);
      }
      add_slow(slow_[i].normal, made_.motions[i].normal, made_.motions[i].normal_velocity);
      add_slow(slow_[i].radial, made_.motions[i].radial, made_.motions[i].radial_velocity);
    }
    return std::move(made_);
  }

 private:
  struct Slow {
    std::vector<double> normal, radial;
  };

  void add_slow(const std::vector<double>& place, std::vector<double>& to, std::vector<double>& velocity) const {
    for (std::size_t i = 0; i < instants_.outputs; ++i) {
      const std::size_t j = i * instants_.stride + instants_.before;
      if (j >= place.size()) return;
      to[i] += place[j];
      if (j > 0 && j + 1 < place.size()) velocity[i] += 0.5 * (place[j + 1] - place[j - 1]) / instants_.step;
    }
  }

  const Lamina& plate_;
  double poisson_, distance_, depth_;
  const Instants& instants_;
  const std::vector<PressedLoad>& loads_;
  bool near_;
  std::vector<Slow> slow_;
  PressedPlate made_;
};

}  // namespace

PressedPlate pressed_plate(const Lamina& plate, double poisson, double distance, double depth, const Instants& instants,
                           const std::vector<PressedLoad>& loads, double cutoff, const Poll& poll) {
  const double duration = duration_of(plate, distance, instants);
  const ProfileMaker make(plate, {depth});
  Sum sum(plate, poisson, distance, depth, instants, loads);
  for (const PlaneWaves& waves : plane_waves(plate, cutoff, duration, poll)) {
    if (poll) poll();
    std::vector<Amplitude> amplitudes;
    for (std::size_t l = 0; l < waves.omega.size(); ++l) {
      amplitudes.push_back({waves.omega[l], waves.normal[l], waves.along[l]});
    }
    sum.add(make.of({waves.wave_number, waves.weight}, amplitudes, cutoff), waves.weight, amplitudes, cutoff);
  }
  constexpr double turn = 16.0;  // of a shape in a panel
  const auto& rule = numeric::gauss_legendre(16);
  const double last = sum.last_wave_number();
  for (double from = highest_kept(plate, cutoff, poll); from < last;) {
    if (poll) poll();
    const double to = std::min({last, 2.0 * from, from + (distance > 0.0 ? turn / distance : last)});
    const double half = 0.5 * (to - from);
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      const WaveNumber number{from + half * (1.0 + rule.node[i]), half * rule.weight[i]};
      sum.add(make.of(number), number.weight, {}, cutoff);
    }
    from = to;
  }
  return sum.taken();
}

double count_of_waves(const Lamina& plate, double distance, const Instants& instants, double cutoff) {
  double crossings = 0.0;
  for (const Sheet& sheet : plate.sheets) crossings += sheet.thickness * std::sqrt(sheet.density / sheet.shear_modulus);
  const double modes = 2.0 + 0.5 * cutoff * crossings / std::numbers::pi * 1.6;
  return modes * (24.0 + 0.3 * cutoff * duration_of(plate, distance, instants));
}

}  // namespace stoss::bodies::plate
