#include "bodies/plate/given.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "bodies/half_space/medium.hpp"
#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::plate {

double Given::speed() const { return std::sqrt(layers.front().young / layers.front().density); }

Given given_of(const Plate& plate) {
  Given given{Contour::ball, {{plate.thickness, plate.poisson, plate.young, plate.density}}, plate.loss_time};
  given.layers.insert(given.layers.end(), plate.below.begin(), plate.below.end());
  given.losses = plate.losses;
  return given;
}

Given given_of(const Strip& strip) {
  return {Contour::cylinder, {{strip.thickness, strip.poisson, strip.young, strip.density}}, strip.loss_time};
}

namespace {

/// Of layers far less like each other the waves are too many, and the slower ones lost in rounding.
void require_like(const Given& given, const char* name, double Layer::*number, const Range& allowed) {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const Layer& layer : given.layers) {
    least = std::min(least, layer.*number);
    most = std::max(most, layer.*number);
  }
  require(name, most / least, allowed, "of the largest to the smallest in the layers of the plate");
}

}  // namespace

void require_given(const Given& given) {
  constexpr long most_layers = 64;
  constexpr Range positive{0.0, std::numeric_limits<double>::max(), false, true, "a positive finite number"};
  require("layers", static_cast<long>(given.layers.size()), 1, most_layers, "of the plate");
  for (const Layer& layer : given.layers) {
    bodies::half_space::require_poisson(given.contour, layer.poisson);
    const bool below_others = given.layers.size() > 1 && &layer == &given.layers.back();
    if (!(below_others && layer.thickness > std::numeric_limits<double>::max())) {
      require("thickness", layer.thickness, positive, "of the plate; infinite only of a layer below others");
    }
    require("young", layer.young, positive, "Young's modulus of the plate");
    require("density", layer.density, positive, "of the plate");
  }
  require_like(given, "young ratio", &Layer::young, {1.0, 1e9, true, true, "up to 1e9"});
  require_like(given, "density ratio", &Layer::density, {1.0, 1e6, true, true, "up to 1e6"});
  require_loss_time(given.own_loss_time());
  if (given.losses.empty()) return;
  if (given.losses.size() != given.layers.size()) {
    throw InvalidInput::out_of_range("losses", std::to_string(given.losses.size()),
                                     std::to_string(given.layers.size()) + ", one for each layer", "or none");
  }
  if (given.loss_time != 0.0) throw InvalidInput::conflict("loss_time", "the layers have their own", "leave it out");
  for (const MaterialLoss& its : given.losses) {
    validate(its);
    require_loss_time(in_own_time(its.loss_time, given.speed()));
  }
}

double turning_frequency(const Given& given, double duration) {
  constexpr double steps = 4.0;
  const double crossings = duration / given.layers.front().thickness;
  return 2.0 * std::numbers::pi * std::exp2(std::round(steps * std::log2(crossings)) / -steps) /
         given.layers.front().thickness;
}

LayerKinds kinds_of(const Given& given, double duration) {
  LayerKinds kinds;
  for (const MaterialLoss& loss : given.losses) {
    const MaterialLoss own = in_time(loss, given.speed());
    const auto known = std::find(kinds.all.begin(), kinds.all.end(), own);
    kinds.of.push_back(static_cast<std::size_t>(known - kinds.all.begin()));
    if (known == kinds.all.end()) kinds.all.push_back(own);
  }
  if (kinds.all.empty()) kinds.all.push_back({given.own_loss_time(), {}});
  kinds.of.resize(given.layers.size(), 0);
  constexpr double least = 1e-6;
  const std::complex<double> frequency{0.0, turning_frequency(given, duration)};
  for (const MaterialLoss& own : kinds.all) {
    const double size = std::max(least, std::abs(modulus(own, frequency)));
    kinds.stiffness.push_back(kinds.stiffness.empty() ? size : size / kinds.stiffness.front());
  }
  kinds.stiffness.front() = 1.0;
  return kinds;
}

std::string name_of(const Given& given) {
  std::string name = given.kind();
  for (const Layer& layer : given.layers) {
    if (&layer != &given.layers.front()) name += " /";
    name += " thickness=";
    name += std::isinf(layer.thickness) ? "inf" : shown(layer.thickness);
    name += " poisson=" + shown(layer.poisson);
    if (layer.young != 1.0) name += " young=" + shown(layer.young);
    if (layer.density != 1.0) name += " density=" + shown(layer.density);
  }
  if (given.loss_time != 0.0) name += " loss_time=" + shown(given.loss_time);
  if (!given.losses.empty()) name += " losses=" + std::to_string(given.losses.size());
  return name;
}

std::vector<Sheet> sheets_of(const Given& given, const LayerKinds& kinds, double duration) {
  const Layer& top = given.layers.front();
  std::vector<Sheet> sheets;
  for (const Layer& layer : given.layers) {
    const std::size_t kind = kinds.of[sheets.size()];
    const double young = layer.young / top.young * kinds.stiffness[kind], poisson = layer.poisson;
    Sheet sheet{layer.thickness, 0.5 * young / (1.0 + poisson), 0.0, layer.density / top.density,
                static_cast<int>(kind)};
    sheet.pressure_modulus = given.contour == Contour::ball
                                 ? young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
                                 : young / (1.0 - poisson * poisson);
    const double farthest = 0.5 * duration * std::sqrt(sheet.pressure_modulus / sheet.density);
    sheet.thickness = std::min(sheet.thickness, farthest);
    sheets.push_back(sheet);
    if (layer.thickness >= farthest) break;
  }
  return sheets;
}

bool is_thick(const Given& given, double duration) {
  const Layer& its = given.layers.front();
  const double speed = bodies::half_space::medium(given.contour, its.poisson).pressure_speed;
  return given.layers.size() == 1 && 2.0 * its.thickness >= speed * duration;
}

}  // namespace stoss::bodies::plate
