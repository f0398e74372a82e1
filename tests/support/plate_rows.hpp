#pragma once

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "stoss/bodies/plate.hpp"
#include "support/csv.hpp"

namespace stoss::test {

/// The plate of a row of plate_restitution.csv.
inline Plate plate_of(const CsvRow& row) {
  std::vector<Layer> layers;
  std::istringstream all(row.text("layers"));
  for (std::string one; std::getline(all, one, ';');) {
    std::istringstream numbers(one);
    Layer layer;
    char colon = ':';
    numbers >> layer.thickness >> colon >> layer.young >> colon >> layer.poisson >> colon >> layer.density;
    layers.push_back(layer);
  }
  const Layer& top = layers.front();
  return {
      top.thickness, top.poisson, top.young, top.density, row.number("loss_time"), {layers.begin() + 1, layers.end()}};
}

}  // namespace stoss::test
