// The loss on plates over that on a block against thickness over c_p T/2, T the contact time on the block.
#include <fmt/os.h>

#include <utility>

#include "study.hpp"

namespace study {
namespace {

struct Named {
  const char* name;
  Pair pair;
  std::vector<double> speeds;
};

}  // namespace

void write_block(const std::string& name) {
  const std::vector<double> decades{1e-5, 1e-4, 1e-3, 1e-2, 1e-1}, few{1e-4, 1e-2};
  const std::vector<Named> all{
      {"one material nu=0.3", {}, decades},
      {"one material nu=0", {.ball_poisson = 0.0, .poisson = 0.0}, few},
      {"one material nu=0.2", {.ball_poisson = 0.2, .poisson = 0.2}, few},
      {"one material nu=0.45", {.ball_poisson = 0.45, .poisson = 0.45}, few},
      {"rigid ball", {.rigid = true}, few},
      {"plate of 1/3 of the modulus", {.poisson = 0.22, .young = 1.0 / 3.0, .density = 0.32}, few},
      {"plate of 3 times the modulus", {.young = 3.0, .density = 2.0}, few},
      {"plate of twice the density", {.density = 2.0}, few},
  };
  auto out = fmt::output_file(name);
  out.print(
      "# Balls on plates and on a block, elastic; x: thickness over c_p T/2 with T of the block; tolerance 1e-3 of "
      "1-eps^2; made by `make results`.\n");
  out.print(
      "pair,poisson,young,density,rigid,speed[c],contact_time[R/c],impulse_time[R/c],half_way[R],x,thickness[R],"
      "lost_fraction,lost_fraction_error,on_block,on_block_error,converged\n");
  for (const auto& [what, pair, speeds] : all) {
    const std::vector<stoss::Restitution> blocks = on_block(pair, speeds);
    for (const stoss::Restitution& block : blocks) {
      const double speed = block.finest.speed, half = 0.5 * pair.pressure_speed() * block.contact_time.value;
      for (int i = 5; i <= 20; ++i) {
        const double x = 0.05 * i, h = x * half;
        const stoss::Restitution r = on_plate(pair, h, {speed}).front();
        out.print("{},{},{:.4g},{},{},{:.4g},{:.6g},{:.6g},{:.6g},{:.2f},{:.6g},{:.7g},{:.1e},{:.7g},{:.1e},{}\n", what,
                  pair.poisson, pair.young, pair.density, pair.rigid, speed, block.contact_time.value,
                  block.impulse_time.value, half, x, h, r.lost_fraction.value, r.lost_fraction.error,
                  block.lost_fraction.value, block.lost_fraction.error, r.converged);
      }
    }
  }
}

}  // namespace study
