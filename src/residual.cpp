#include "residual.hpp"

#include "stoss/errors.hpp"

namespace stoss {

std::vector<double> residual_matrix(const Body& body,
                                    const std::function<std::vector<double>(const ContactGrid&)>& residual,
                                    const ContactGrid& grid) {
  std::vector<double> matrix = residual(grid);
  if (matrix.size() != grid.recess.size() * grid.recess.size()) {
    throw InvalidInput("body: got a residual of '" + body.name + "' of another size, allowed nodes x nodes values");
  }
  return matrix;
}

}  // namespace stoss
