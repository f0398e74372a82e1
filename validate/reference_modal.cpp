// Reference values for bodies by their modes at a point: spheres, of which all is known.
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "judgement.hpp"
#include "modal_points.hpp"
#include "reference.hpp"
#include "runs.hpp"

namespace validate {
namespace {

constexpr int impacts = 64;

/// Point i of an additive sequence, with the roots of the primes.
double spread(int i, std::size_t dimension) {
  constexpr std::array primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61};
  const double step = 0.5 + (i + 1) * std::sqrt(primes.at(dimension));
  return step - std::floor(step);
}

double between(double low, double high, double share) { return rounded("%.3g", low * std::pow(high / low, share)); }

/// Every third without χ; half of them not quite spheres; four of ten with errors as those of finite elements, which
/// are off by −1 to 1 of them, frequencies by 0 to 1 as all are too high.
std::vector<ModalCase> design() {
  constexpr std::array kinds{"wall", "sphere", "half_space", "wall", "sphere", "plate", "its like"};
  std::vector<ModalCase> all;
  for (int i = 0; i < impacts; ++i) {
    ModalCase its;
    its.against = kinds.at(static_cast<std::size_t>(i) % kinds.size());
    its.poisson = rounded("%.2f", 0.47 * spread(i, 0));
    its.complete_to = between(4.0, 20.0, spread(i, 1));
    its.speed = between(1e-6, 0.03, spread(i, 2));
    its.bends = i % 3 != 1;
    its.size = its.against == "plate" ? between(0.3, 10.0, spread(i, 3)) : between(0.3, 3.0, spread(i, 3));
    its.its_poisson = rounded("%.2f", 0.47 * spread(i, 4));
    its.its_young = between(0.1, 10.0, spread(i, 5));
    its.its_density = between(0.1, 10.0, spread(i, 6));
    if (spread(i, 7) < 0.5) its.flatter = rounded("%.3f", -0.125 + 0.375 * spread(i, 8));
    if (spread(i, 9) < 0.4) {
      its.compliance_error = between(1e-3, 3e-2, spread(i, 10));
      its.frequency_error = between(1e-4, 1e-2, spread(i, 11));
      its.displacement_error = between(1e-3, 3e-2, spread(i, 12));
      its.compliance_off = rounded("%.3g", its.compliance_error * (2.0 * spread(i, 13) - 1.0));
      its.frequency_off = rounded("%.3g", its.frequency_error * spread(i, 14));
      its.displacement_off = rounded("%.3g", its.displacement_error * (2.0 * spread(i, 15) - 1.0));
    }
    all.push_back(its);
  }
  return all;
}

std::string place_of(const ModalCase& its) {
  std::ostringstream place;
  place << its.poisson << ',' << its.complete_to << ',' << its.bends << ',' << its.flatter << ','
        << its.compliance_error << ',' << its.compliance_off << ',' << its.frequency_error << ',' << its.frequency_off
        << ',' << its.displacement_error << ',' << its.displacement_off << ',' << its.against << ',' << its.size << ','
        << its.its_poisson << ',' << its.its_young << ',' << its.its_density << ',' << its.speed;
  return place.str();
}

void write(std::ostream& out, const stoss::Estimate& estimate) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), ",%.8g,%.1e", estimate.value, estimate.error);
  out << text.data();
}

void write_row(std::ostream& out, const ModalCase& its) {
  constexpr double fine = 1e-4;  // of 1 − ε², a tenth of the default tolerance
  try {
    (void)best(given(its), its.speed, {});  // of contacts that are too wide there is nothing to judge
    const stoss::Restitution found = best(exact(its), its.speed, {.tolerance = fine, .absolute = 0.0});
    out << place_of(its);
    for (const auto* each :
         {&found.lost_fraction, &found.contact_time, &found.impulse_time, &found.max_force, &found.max_compression}) {
      write(out, *each);
    }
    out << std::endl;  // one may look on
  } catch (const std::exception& error) {
    std::cerr << place_of(its) << ": " << error.what() << '\n';
  }
}

}  // namespace

void make_modal_reference(const std::string& path) {
  std::ofstream file(path);
  file
      << "# Impacts of spheres that are given by their modes at a point, in units of the sphere. Values: of the sphere "
         "itself\n"
         "# by restitution() to 1e-4 of 1 - eps^2, with their errors. Made by: stoss_validate --make-modal-reference "
         "FILE\n"
         "# flatter: its surface is recessed by so much H^3 r^4 more. _error: as given; _off: by which what is given "
         "is off.\n"
         "# Left out: contacts that are too wide for what is known of the point.\n"
         "poisson,complete_to,bends,flatter,compliance_error,compliance_off,frequency_error,frequency_off,"
         "displacement_error,displacement_off,against,size,its_poisson,its_young,its_density,speed," +
             quantity_columns + '\n';
  for (const ModalCase& its : design()) write_row(file, its);
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace validate
