#include "restitution/layer_doubt.hpp"

#include <algorithm>
#include <complex>
#include <numbers>

#include "contact/unit_ratios.hpp"

namespace stoss {

double doubt_of_layers(const Contact& contact, const Run& run) {
  constexpr double of_tangent = 0.1, most = 0.04;
  double doubt = 0.0;
  for (int number = 0; number < 2; ++number) {
    const auto body = body_of(contact, number);
    if (body == nullptr || body->layers.empty()) continue;
    const std::complex<double> frequency{0.0, std::numbers::pi / run.contact_time * units_of(contact, number).time};
    for (const MaterialLoss& layer : body->layers) {
      const std::complex<double> its = modulus(layer, frequency);
      doubt = std::max(doubt, std::min(of_tangent * its.imag() / its.real(), most));
    }
  }
  return doubt * run.dissipated;
}

}  // namespace stoss
