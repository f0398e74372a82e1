// Motions of rows for docs/understand/findings/rows.md: stoss_rows FOLDER DIAGRAM writes waves.csv, speeds.csv,
// delays.csv and walls.csv into a folder, and the forces of a space-time diagram into a file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "stoss/encounter/row.hpp"
#include "stoss/row/row.hpp"

namespace {

using stoss::GivenRow, stoss::RowImpact, stoss::RowSnapshot, stoss::RowWatch;

constexpr double cutoff = 16.0;  // c/R

GivenRow balls(int count, const std::string& keys = {}, const std::string& ends = {}) {
  std::string text;
  for (int b = 0; b < count; ++b) {
    text += fmt::format("{}{{\"kind\": \"sphere\", \"poisson\": 0.3{}}}", b == 0 ? "" : ", ", keys);
  }
  return stoss::row_from_json(fmt::format("{{\"format\": \"stoss row 1\", \"bodies\": [{}]{}}}", text, ends));
}

std::ofstream table(const std::string& path, const std::string& about, const std::string& columns) {
  std::ofstream file(path);
  file << "# " << about << "; made by `make results`. Columns: docs/understand/findings/rows.md.\n" << columns << '\n';
  return file;
}

/// The force at one contact in time: its greatest value and when it is, by a parabola, and how long it is above half.
struct Pulse {
  double force = 0.0, time = 0.0, width = 0.0;
};

struct Trace {
  std::vector<double> time;
  std::vector<std::vector<double>> force;  // of each instant

  [[nodiscard]] double at(std::size_t instant, std::size_t contact) const { return force[instant][contact]; }

  [[nodiscard]] Pulse pulse(std::size_t contact) const {
    std::size_t top = 0;
    for (std::size_t i = 0; i < time.size(); ++i) top = at(i, contact) > at(top, contact) ? i : top;
    if (top == 0 || top + 1 >= time.size()) return {};
    const double before = at(top - 1, contact), most = at(top, contact), after = at(top + 1, contact);
    const double shift = 0.5 * (before - after) / (before - 2.0 * most + after), step = time[top] - time[top - 1];
    Pulse its{most - 0.25 * (before - after) * shift, time[top] + shift * step, 0.0};
    const auto crossing = [&](std::ptrdiff_t way) {
      auto i = static_cast<std::ptrdiff_t>(top);
      while (i > 0 && i + 1 < std::ssize(time) && at(static_cast<std::size_t>(i), contact) > 0.5 * its.force) i += way;
      const auto outer = static_cast<std::size_t>(i), inner = static_cast<std::size_t>(i - way);
      const double share = (0.5 * its.force - at(outer, contact)) / (at(inner, contact) - at(outer, contact));
      return time[outer] + share * (time[inner] - time[outer]);
    };
    its.width = crossing(1) - crossing(-1);
    return its;
  }
};

Trace trace(const GivenRow& row, double speed, double until) {
  Trace its;
  RowWatch watch{.until = until};
  watch.observer = [&](const RowSnapshot& now) { its.time.push_back(now.time), its.force.push_back(now.force); };
  std::vector<double> speeds(row.bodies.size());
  speeds.front() = speed;
  (void)stoss::row_impact(row, speeds, cutoff, {}, watch);
  return its;
}

/// Time of the contact of two balls.
double contact_time(double speed, const std::string& keys = {}) {
  return stoss::row_impact(balls(2, keys), {speed, 0.0}, cutoff).contacts.front().last_touch;
}

struct Case {
  const char* material;
  const char* keys;
  double speed;
  int count;
};

void waves(const std::string& folder, const std::string& diagram) {
  std::ofstream file = table(folder + "/waves.csv", "The wave in rows of balls, nu = 0.3, of which the first moves",
                             "material,speed[c],contact,max_force[mc^2/R],time[R/c],wave_speed[c],width[balls]");
  constexpr const char *lossless = "", *lossy = ", \"quality\": 100";
  for (const auto& [material, keys, speed, count] :
       {Case{"elastic", lossless, 1e-3, 100}, Case{"elastic", lossless, 0.1, 100}, Case{"Q = 100", lossy, 1e-3, 30},
        Case{"Q = 100", lossy, 0.1, 30}}) {
    const bool drawn = keys == lossless && speed == 0.1;
    const Trace its = trace(balls(count, keys), speed, (drawn ? 0.75 : 0.55) * count * contact_time(speed));
    Pulse before;
    for (std::size_t k = 0; k + 1 < static_cast<std::size_t>(count); ++k) {
      const Pulse now = its.pulse(k);
      const double wave = k > 0 ? 2.0 / (now.time - before.time) : 0.0;
      file << fmt::format("{},{:g},{},{:.6g},{:.6g},{:.5g},{:.4g}\n", material, speed, k, now.force, now.time, wave,
                          0.5 * now.width * wave);
      before = now;
    }
    file.flush();
    if (!drawn) continue;
    std::ofstream forces(diagram);
    const std::size_t every = its.time.size() / 400;
    for (std::size_t i = 0; i < its.time.size(); i += every) {
      forces << fmt::format("{:.6g}", its.time[i]);
      for (const double each : its.force[i]) forces << fmt::format(",{:.4g}", each);
      forces << '\n';
    }
  }
}

void speeds(const std::string& folder) {
  std::ofstream file = table(folder + "/speeds.csv", "The wave half-way through a row of 40 balls, nu = 0.3",
                             "speed[c],max_force[mc^2/R],wave_speed[c],over_sixth_root,width[balls]");
  for (const double speed : {1e-5, 1e-4, 1e-3, 1e-2, 0.03, 0.1, 0.2}) {
    constexpr std::size_t count = 40, middle = 20;
    const Trace its = trace(balls(count), speed, 0.7 * count * contact_time(speed));
    const Pulse before = its.pulse(middle - 1), now = its.pulse(middle), after = its.pulse(middle + 1);
    const double wave = 4.0 / (after.time - before.time);
    file << fmt::format("{:g},{:.6g},{:.5g},{:.5g},{:.4g}\n", speed, now.force, wave,
                        wave / std::pow(now.force, 1.0 / 6.0), 0.5 * now.width * wave);
  }
}

void delays(const std::string& folder) {
  std::ofstream file =
      table(folder + "/delays.csv", "When the last ball leaves, of rows of which the first moves, nu = 0.3",
            "speed[c],balls,time[R/c],added[contacts]");
  for (const double speed : {1e-5, 1e-3, 0.1}) {
    const double first = contact_time(speed);
    double before = 0.0;
    for (int count = 2; count <= 10; ++count) {
      std::vector<double> velocities(static_cast<std::size_t>(count));
      velocities.front() = speed;
      const double last = stoss::row_impact(balls(count), velocities, cutoff, {}, {.until = (count + 1) * first})
                              .contacts.back()
                              .last_touch;
      file << fmt::format("{:g},{},{:.6g},{:.4f}\n", speed, count, last, (last - before) / first);
      before = last;
    }
  }
}

void walls(const std::string& folder) {
  std::ofstream file = table(folder + "/walls.csv", "A ball between two rigid walls, nu = 0.3, that starts at 0.1 c",
                             "gap[R],bounce,until[R/c],speed[c],restitution,vibration");
  for (const double gap : {0.5, 0.6}) {
    const GivenRow row =
        balls(1, "", fmt::format(", \"before\": \"wall\", \"after\": \"wall\", \"gaps\": [0, {:g}]", gap));
    double before = 0.1, speed = 0.1;
    int bounce = 0;
    std::ptrdiff_t wall = 0;  // at which it was last
    RowWatch watch{.until = 600.0};
    watch.observer = [&](const RowSnapshot& now) {
      const auto& force = now.force;
      const auto pushes = std::max_element(force.begin(), force.end());
      if (*pushes > 0.0 && pushes - force.begin() != wall) {
        if (bounce > 0) {
          file << fmt::format("{:g},{},{:.5g},{:.6g},{:.5f},{:.5f}\n", gap, bounce, now.time, speed, speed / before,
                              now.energy.vibration + now.energy.unresolved);
          before = speed;
        }
        wall = pushes - force.begin(), ++bounce;
      }
      speed = std::abs(now.velocity.front());
    };
    (void)stoss::row_impact(row, {0.1}, 32.0, {}, watch);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("usage: stoss_rows FOLDER DIAGRAM\n", stderr), 2;
  try {
    walls(argv[1]), delays(argv[1]), speeds(argv[1]), waves(argv[1], argv[2]);
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 1;
  }
}
