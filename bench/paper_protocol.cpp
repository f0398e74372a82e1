#include "paper_protocol.hpp"

#include <cmath>
#include <numbers>

// Function multiversioning as in src/numeric/kernels.cpp, so that the comparison is one of methods; AVX-512 is 13 %
// faster here.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__ELF__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define BENCH_MULTIVERSION __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define BENCH_MULTIVERSION
#endif

namespace bench {
namespace {

constexpr double mass = std::numbers::pi;

using Array = std::vector<double>;

/// Amplitudes of one order: of the edge, Σ C Q and Σ S Q, or of the force on the edge.
struct Edge {
  double radial = 0.0;
  double tangential = 0.0;
};

BENCH_MULTIVERSION
Edge sum_modes(std::size_t begin, std::size_t end, const double* real, const double* imaginary, const double* cosine,
               const double* sine, const double* radial, const double* tangential) {
  double sum_radial = 0.0;
  double sum_tangential = 0.0;
#pragma omp simd reduction(+ : sum_radial, sum_tangential)
  for (std::size_t k = begin; k < end; ++k) {
    const double coordinate = real[k] * cosine[k] - imaginary[k] * sine[k];
    sum_radial += radial[k] * coordinate;
    sum_tangential += tangential[k] * coordinate;
  }
  return {sum_radial, sum_tangential};
}

BENCH_MULTIVERSION
void add_shape(std::size_t angles, Edge edge, const double* radial, const double* tangential, double* position) {
#pragma omp simd
  for (std::size_t i = 0; i < angles; ++i) position[i] += edge.radial * radial[i] + edge.tangential * tangential[i];
}

BENCH_MULTIVERSION
Edge project(std::size_t angles, const double* force, const double* radial, const double* tangential) {
  double sum_radial = 0.0;
  double sum_tangential = 0.0;
#pragma omp simd reduction(+ : sum_radial, sum_tangential)
  for (std::size_t i = 0; i < angles; ++i) {
    sum_radial += force[i] * radial[i];
    sum_tangential += force[i] * tangential[i];
  }
  return {sum_radial, sum_tangential};
}

/// dq/dt of one order's modes; adds it to the step's result and makes the argument of the next stage.
struct Stage {
  double weight;   // of this stage in the result, times Δt
  double advance;  // from the beginning of the step to the next stage
};
struct Amplitudes {  // q: at the beginning of the step, at the stage, and the result
  const double* real;
  const double* imaginary;
  double* stage_real;
  double* stage_imaginary;
  double* next_real;
  double* next_imaginary;
};
BENCH_MULTIVERSION
void evolve(std::size_t begin, std::size_t end, Stage stage, Edge force, const double* cosine, const double* sine,
            const double* radial, const double* tangential, Amplitudes q) {
#pragma omp simd
  for (std::size_t k = begin; k < end; ++k) {
    const double push = radial[k] * force.radial + tangential[k] * force.tangential;  // has the factor 1/mω
    const double rate_real = push * sine[k];
    const double rate_imaginary = push * cosine[k];
    q.next_real[k] += stage.weight * rate_real;
    q.next_imaginary[k] += stage.weight * rate_imaginary;
    q.stage_real[k] = q.real[k] + stage.advance * rate_real;
    q.stage_imaginary[k] = q.imaginary[k] + stage.advance * rate_imaginary;
  }
}

BENCH_MULTIVERSION
void rotate(std::size_t count, const double* turn_cosine, const double* turn_sine, double* cosine, double* sine) {
#pragma omp simd
  for (std::size_t k = 0; k < count; ++k) {
    const double next = cosine[k] * turn_cosine[k] - sine[k] * turn_sine[k];
    sine[k] = sine[k] * turn_cosine[k] + cosine[k] * turn_sine[k];
    cosine[k] = next;
  }
}

class Disk {
 public:
  Disk(const std::vector<stoss::ModeGroup>& modes, const PaperSettings& settings)
      : settings_(settings), angles_(static_cast<std::size_t>(settings.angles)) {
    for (const stoss::ModeGroup& group : modes) {
      begin_.push_back(omega_.size());
      for (std::size_t l = 0; l < group.omega.size(); ++l) {
        const double omega = group.omega[l];
        omega_.push_back(omega);
        radial_.push_back(group.upper[l] + group.lower[l]);
        tangential_.push_back(group.upper[l] - group.lower[l]);
        radial_force_.push_back(radial_.back() / (mass * omega));
        tangential_force_.push_back(tangential_.back() / (mass * omega));
        turn_cosine_.push_back(std::cos(0.5 * omega * settings.step));
        turn_sine_.push_back(std::sin(0.5 * omega * settings.step));
      }
    }
    begin_.push_back(omega_.size());
    for (Array* q : {&real_, &imaginary_, &stage_real_, &stage_imaginary_, &next_real_, &next_imaginary_, &sine_}) {
      q->assign(omega_.size(), 0.0);
    }
    cosine_.assign(omega_.size(), 1.0);

    const double interval = 0.5 * std::numbers::pi / settings.angles;
    measure_ = 2.0 * interval;  // an angle stands for its mirror image too
    for (int i = 0; i < settings.angles; ++i) angle_cosine_.push_back(std::cos((i + 0.5) * interval));
    int order = -1;
    for (const stoss::ModeGroup& group : modes) {  // one table for neighbouring groups of the same order
      for (int i = 0; i < settings.angles && group.order != order; ++i) {
        const double phi = (i + 0.5) * interval;
        radial_shape_.push_back(std::cos(group.order * phi) * std::cos(phi));
        tangential_shape_.push_back(-std::sin(group.order * phi) * std::sin(phi));
      }
      order = group.order;
      shape_.push_back(radial_shape_.size() - angles_);
    }
    position_.resize(angles_);
    force_.resize(angles_);
  }

  PaperResult collide() {
    const double energy = 0.5 * mass * settings_.speed * settings_.speed;
    const double negligible = 1e-9 * energy;  // potential out of the wall's reach
    center_ = -1.0 - std::log(std::numbers::pi * settings_.strength / negligible) / settings_.hardness;
    velocity_ = settings_.speed;
    const double start = center_;
    PaperResult result;
    const long most = static_cast<long>(100.0 / settings_.step);
    while (result.steps < most && (center_ >= start || potential_ > negligible)) {
      step();
      ++result.steps;
    }
    result.lost_fraction = 1.0 - velocity_ * velocity_ / (settings_.speed * settings_.speed);
    const double error = std::abs(this->energy() / energy - 1.0);
    result.energy_error = result.steps < most && std::isfinite(error) ? error : 1.0;
    return result;
  }

 private:
  [[nodiscard]] double energy() const {
    double sum = 0.5 * mass * velocity_ * velocity_;
    for (std::size_t k = 0; k < omega_.size(); ++k) {
      sum += 0.5 * mass * omega_[k] * omega_[k] * (real_[k] * real_[k] + imaginary_[k] * imaginary_[k]);
    }
    return sum;
  }

  void step() {
    const double h = settings_.step;
    stage_real_ = next_real_ = real_;
    stage_imaginary_ = next_imaginary_ = imaginary_;
    double rate[4];   // dv/dt
    double drift[4];  // dx₀/dt
    const Stage stages[4] = {{h / 6.0, 0.5 * h}, {h / 3.0, 0.5 * h}, {h / 3.0, h}, {h / 6.0, 0.0}};
    double center = center_;
    double velocity = velocity_;
    for (std::size_t s = 0; s < 4; ++s) {
      if (s == 1 || s == 3) {
        rotate(omega_.size(), turn_cosine_.data(), turn_sine_.data(), cosine_.data(), sine_.data());
      }
      drift[s] = velocity;
      rate[s] = push(center);
      evolve_modes(stages[s]);
      center = center_ + stages[s].advance * drift[s];
      velocity = velocity_ + stages[s].advance * rate[s];
    }
    for (std::size_t s = 0; s < 4; ++s) {
      center_ += stages[s].weight * drift[s];
      velocity_ += stages[s].weight * rate[s];
    }
    real_.swap(next_real_);
    imaginary_.swap(next_imaginary_);
  }

  /// Forces on the angles for the modes' stage values; returns dv/dt.
  double push(double center) {
    for (std::size_t i = 0; i < angles_; ++i) position_[i] = center + angle_cosine_[i];
    for (std::size_t g = 0; g + 1 < begin_.size(); ++g) {
      const Edge edge = sum_modes(begin_[g], begin_[g + 1], stage_real_.data(), stage_imaginary_.data(), cosine_.data(),
                                  sine_.data(), radial_.data(), tangential_.data());
      add_shape(angles_, edge, &radial_shape_[shape_[g]], &tangential_shape_[shape_[g]], position_.data());
    }
    const double scale = settings_.hardness * settings_.strength * measure_;
    double total = 0.0;
    for (std::size_t i = 0; i < angles_; ++i) {
      force_[i] = scale * std::exp(settings_.hardness * position_[i]);
      total += force_[i];
    }
    potential_ = total / settings_.hardness;
    return -total / mass;
  }

  void evolve_modes(Stage stage) {
    const Amplitudes q{real_.data(),      imaginary_.data(),     stage_real_.data(), stage_imaginary_.data(),
                       next_real_.data(), next_imaginary_.data()};
    for (std::size_t g = 0; g + 1 < begin_.size(); ++g) {
      const Edge force = project(angles_, force_.data(), &radial_shape_[shape_[g]], &tangential_shape_[shape_[g]]);
      evolve(begin_[g], begin_[g + 1], stage, force, cosine_.data(), sine_.data(), radial_force_.data(),
             tangential_force_.data(), q);
    }
  }

  PaperSettings settings_;
  std::size_t angles_;
  std::vector<std::size_t> begin_;  // of each group, and the end
  std::vector<std::size_t> shape_;  // of each group's order in the tables
  Array omega_, radial_, tangential_, radial_force_, tangential_force_;
  Array turn_cosine_, turn_sine_, cosine_, sine_;  // e^{iωΔt/2}, e^{iωt}
  Array real_, imaginary_, stage_real_, stage_imaginary_, next_real_, next_imaginary_;
  Array angle_cosine_, radial_shape_, tangential_shape_, position_, force_;
  double measure_ = 0.0;
  double center_ = 0.0;
  double velocity_ = 0.0;
  double potential_ = 0.0;
};

}  // namespace

PaperResult paper_impact(const std::vector<stoss::ModeGroup>& modes, const PaperSettings& settings) {
  return Disk(modes, settings).collide();
}

}  // namespace bench
