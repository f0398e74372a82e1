#pragma once

#include <optional>
#include <string>
#include <vector>

#include "points.hpp"
#include "stoss/bodies/plate.hpp"

namespace validate {

/// A ball that falls on a plate, or a disk on a strip, in units of the ball.
struct PlateCase {
  bool strip = false;
  bool rigid = false;  ///< is the ball
  double poisson = 0.0, loss_time = 0.0;
  std::vector<stoss::Layer> layers;  ///< of the plate, downwards
  double plate_loss_time = 0.0;
  double speed = 0.0;
};

/// What meets.
stoss::RefinableContact contact_of(const PlateCase& its);

/// A plate as text, h:ν:E:ρ of each layer, downwards.
std::string text_of(const std::vector<stoss::Layer>& layers);

/// An impact on a plate with reference values; their `error` is the uncertainty.
struct PlatePoint {
  PlateCase its;
  PerQuantity<std::optional<stoss::Estimate>> reference;
};

/// Those of validate/data/reference_plates.csv. @throws std::runtime_error as read_points
std::vector<PlatePoint> read_plates();

/// Those of validate/data/reference_plates_unseen.csv, to which no constant was fitted. @throws as read_plates
std::vector<PlatePoint> read_unseen_plates();

/// Those of finite elements, tests/data/plate_restitution.csv: 1 − ε². @throws std::runtime_error as read_points
std::vector<PlatePoint> read_plates_of_elements();

}  // namespace validate
