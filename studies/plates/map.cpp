// ε of a ball on a plate of its own material, ν = 0.3, and by Zener's theory over thickness and speed.
#include <fmt/os.h>

#include <cstddef>

#include "study.hpp"

namespace study {

void write_map(const std::string& name) {
  auto out = fmt::output_file(name);
  out.print(
      "# A ball on a plate of its own material, nu = 0.3, elastic; tolerance 1e-3 of 1-eps^2; made by `make "
      "results`.\n");
  out.print(
      "thickness[R],speed[c],restitution,restitution_error,lost_fraction,lost_fraction_error,contact_time[R/c],"
      "impulse_time[R/c],contact_radius[R],inelasticity,zener,zener_contact_time[R/c],deflection[h],converged\n");
  const Pair pair;
  const std::vector<double> speeds = series(1e-6, 0.1, 11);
  for (const double h : series(0.1, 20.0, 25)) {
    const std::vector<stoss::Restitution> all = on_plate(pair, h, speeds);
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const stoss::Restitution& r = all[i];
      const Zener thin = zener(pair, h, speeds[i]);
      out.print("{:.6g},{:.6g},{:.7g},{:.1e},{:.7g},{:.1e},{:.6g},{:.6g},{:.5g},{:.6g},{:.7g},{:.6g},{:.3g},{}\n", h,
                speeds[i], r.restitution.value, r.restitution.error, r.lost_fraction.value, r.lost_fraction.error,
                r.contact_time.value, r.impulse_time.value, r.finest.max_half_width, thin.inelasticity,
                thin.restitution, thin.contact_time, deflection(pair, h, speeds[i], r.restitution.value), r.converged);
    }
  }
}

}  // namespace study
