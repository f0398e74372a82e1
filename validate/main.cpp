// Judges the errors of restitution() by finer references, or makes those references. Exit code: 0 if the errors are
// honest, 1 if they are not or something failed, 2 for a wrong argument, 4 for a file that cannot be written.
#include <algorithm>
#include <array>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>

#include "calibrate.hpp"
#include "modal_report.hpp"
#include "plate_report.hpp"
#include "reference.hpp"
#include "report.hpp"
#include "sets.hpp"

namespace {

using Make = void (*)(const std::string& path);

const std::array<std::pair<const char*, Make>, 14> makers{{
    {"--make-reference", validate::make_reference},
    {"--make-unseen-reference", validate::make_unseen_reference},
    {"--make-pair-reference", validate::make_pair_reference},
    {"--make-sphere-reference", validate::make_sphere_reference},
    {"--make-hollow-reference", validate::make_hollow_reference},
    {"--make-half-space-reference", validate::make_half_space_reference},
    {"--make-plate-reference", validate::make_plate_reference},
    {"--make-unseen-plate-reference", validate::make_unseen_plate_reference},
    {"--make-modal-reference", validate::make_modal_reference},
    {"--make-lossy-reference", validate::make_lossy_reference},
    {"--make-relaxing-reference", validate::make_relaxing_reference},
    {"--make-face-reference", validate::make_face_reference},
    {"--make-vibrating-reference", validate::make_vibrating_reference},
    {"--make-oblique-reference", validate::make_oblique_reference},
}};

int report(const std::string& path) {
  std::ostringstream text;
  const bool honest = validate::write_report(text);
  std::cout << text.str();
  if (!path.empty()) {
    std::ofstream file(path);
    file << text.str();
    if (!file.flush()) {
      std::cerr << "stoss_validate: cannot write " << path << '\n';
      return 4;
    }
  }
  if (!honest) std::cerr << "stoss_validate: the errors are not what they are said to be\n";
  return honest ? 0 : 1;
}

bool plates() {
  const validate::JudgedPlates judged = validate::judge_plates();
  validate::write_plate_times(std::cout, judged);
  return validate::write_plates(std::cout, judged);
}

int refuse() {
  std::cerr << "usage: stoss_validate [--markdown=FILE | --calibrate | --plates | --modal | --set NAME]\n  of the sets";
  for (const validate::Set& set : validate::sets()) std::cerr << " '" << set.name << '\'';
  std::cerr << '\n';
  for (const auto& [option, make] : makers) std::cerr << "       stoss_validate " << option << " FILE\n";
  return 2;
}

int run(int argc, char** argv) {
  const std::string markdown = "--markdown=", first = argc > 1 ? argv[1] : "", second = argc > 2 ? argv[2] : "";
  if (argc == 1) return report("");
  if (argc == 2 && first.rfind(markdown, 0) == 0) return report(first.substr(markdown.size()));
  if (argc == 2 && first == "--calibrate") return validate::write_calibration(std::cout) ? 0 : 1;
  if (argc == 2 && first == "--plates") return plates() ? 0 : 1;
  if (argc == 2 && first == "--modal") return validate::write_modal(std::cout) ? 0 : 1;
  if (argc != 3) return refuse();
  for (const validate::Set& set : validate::sets()) {
    if (first == "--set" && second == set.name) return validate::write_set(std::cout, set) ? 0 : 1;
  }
  const auto making =
      std::find_if(makers.begin(), makers.end(), [&first](const auto& its) { return its.first == first; });
  if (making == makers.end()) return refuse();
  making->second(second);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "stoss_validate: " << error.what() << '\n';
    return 1;
  }
}
