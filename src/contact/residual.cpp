#include "contact/residual.hpp"

#include "stoss/errors.hpp"

namespace stoss {

std::vector<double> residual_matrix(const Body& body,
                                    const std::function<std::vector<double>(const ContactGrid&, const Poll&)>& residual,
                                    const ContactGrid& grid, const Poll& poll) {
  std::vector<double> matrix = residual(grid, poll);
  if (matrix.size() != grid.recess.size() * grid.recess.size()) {
    throw InvalidInput("body: got a residual of '" + body.name + "' of another size, allowed nodes x nodes values");
  }
  return matrix;
}

}  // namespace stoss
