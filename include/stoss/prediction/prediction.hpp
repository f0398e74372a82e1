#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stoss/encounter/encounter.hpp"
#include "stoss/restitution/restitution.hpp"
#include "stoss/table/adaptive.hpp"

/// What a drop test of a real ball would show: ε with all that takes energy, channel by channel.
///
/// Ringing, radiation and loss in the material are *computed* from elasticity, with a numerical error. Yield and
/// adhesion are *modelled*, with a spread of published models. What is not known of the constants is a third
/// uncertainty, and often the largest: the three stand side by side and are never added. All channels but adhesion
/// are of one impact, in which bodies yield by their law (elastic_plastic.hpp); adhesion takes its work as they part. A
/// named material has one quality Q at all frequencies, and loses what such a material
/// loses in a slow impact (docs/theory/loss.md); one with a loss time is Kelvin and Voigt's.
namespace stoss {

/// What takes energy, in the order of `Prediction::shares`.
enum class Channel { ringing, radiation, material, yield, adhesion };

inline constexpr std::array<std::string_view, 5> channel_names{"ringing", "radiation", "material", "yield", "adhesion"};

/// Whether a channel is a model.
[[nodiscard]] constexpr bool is_model(Channel channel) {
  return channel == Channel::yield || channel == Channel::adhesion;
}

/// How ε answers to a constant that is known within a factor.
struct Influence {
  std::string constant;      ///< as "young" of the first body, "against.young" of what it meets
  double uncertainty = 0.0;  ///< u: the constant is known within a factor of 1 + u
  double change = 0.0;       ///< of ε, where the constant is larger by this factor
};

/// ε of one impact, with its parts.
struct Prediction {
  double speed = 0.0;                 ///< of approach, m/s
  Estimate restitution;               ///< ε with all channels, and its numerical error; 0 where the bodies stick
  double by_models = 0.0;             ///< spread of the models: how far the farthest of them is from ε
  double by_constants = 0.0;          ///< what uncertain constants do, root of the sum of the squares of all changes
  double models_low = 0.0;            ///< the lowest ε of the models, without the other two uncertainties
  double models_high = 0.0;           ///< the highest
  Estimate without_models;            ///< ε without yield and adhesion, with what waves and the material take
  std::array<double, 5> shares{};     ///< of each channel in the energy before the impact
  Channel dominant{};                 ///< the largest of them
  double drop_height = 0.0;           ///< from which a ball falls to this speed without air, v²/2g, m
  double rebound_height = 0.0;        ///< to which it rises, ε² of that, m
  double contact_time = 0.0;          ///< s; infinite where the bodies stick
  std::vector<Influence> influences;  ///< the largest change first
  std::vector<std::string> warnings;  ///< what ends within the range of what was computed, with the speeds

  [[nodiscard]] double share(Channel channel) const { return shares[static_cast<std::size_t>(channel)]; }
};

/// Speed in m/s of a fall from a height in m, without air: √(2gh), g = 9.80665 m/s².
/// @throws InvalidInput unless the height is finite and 0 or more
[[nodiscard]] double speed_of_drop(double height);

/// rms height of the asperities of a bearing ball, among the smoothest of balls, m (docs/reference/roughness.md).
inline constexpr double bearing_ball_roughness = 24e-9;

/// Speeds at which models begin to matter, m/s.
struct Thresholds {
  std::optional<double> yield{};       ///< yielding begins above it; nothing without a yield strength
  std::optional<double> impression{};  ///< the impression is no longer small beside the radius above it
  double sticking = 0.0;               ///< bodies stick below it, as far as adhesion alone goes
  double adhesion = 0.0;               ///< adhesion takes more than a hundredth of the energy below it
  double rough = 0.0;  ///< below it asperities count: u₀ is more than a hundredth of the compression. Of faces without
                       ///< a roughness as if they had bearing_ball_roughness
};

/// How a prediction is made.
struct PredictionOptions {
  /// w, J/m². Default: 2√(γ₁γ₂) of both surface energies (a wall has that of the body), 0 where one has none.
  std::optional<double> work_of_adhesion{};
  /// u of constants, by name, in place of those of named materials, 0 (exactly known) to 10.
  std::map<std::string, double, std::less<>> uncertainties{};
  bool influences = true;   ///< whether constants are varied, which takes most of the time
  double tolerance = 1e-3;  ///< of the computed channels, as `restitution` has it
  int threads = 0;          ///< 0: as many as the machine has; results do not depend on it
  Poll poll{};
};

/// Predicts ε of a ball at each of the speeds.
/// @param encounter an elastic or rigid sphere with a material, against a wall, its like, a sphere, half-space or plate
/// @param speeds    m/s, 1e-8 to 1 c of the ball
/// @throws InvalidInput for other bodies, without materials, and as `restitution`, for numbers out of range
[[nodiscard]] std::vector<Prediction> predict(const Encounter& encounter, const std::vector<double>& speeds,
                                              const PredictionOptions& options = {});

/// ε of `predict` as a function, with what the errors of the function leave out.
struct PredictedFunction {
  RestitutionFunction function;  ///< its errors are those of computation and of the interpolation
  double by_models = 0.0;        ///< the largest spread of the models at the speeds at which ε was computed
};

/// ε of `predict` as a function of the speed in c of the ball, for other programs, as `restitution_function` makes it.
/// @param options error 1e-4 … 0.1; Beyond::law has no law here
/// @throws InvalidInput as predict and restitution_function; NotConverged as the latter
[[nodiscard]] PredictedFunction predicted_function(const Encounter& encounter, double slowest, double fastest,
                                                   const FunctionOptions& options = {}, PredictionOptions models = {});

/// Speeds at which the models of an encounter begin to matter. @throws InvalidInput as predict
[[nodiscard]] Thresholds thresholds(const Encounter& encounter, const PredictionOptions& options = {});

}  // namespace stoss
