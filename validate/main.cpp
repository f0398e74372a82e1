// Judges the errors of restitution() by finer references, or makes those references. Exit code: 0 if the errors are
// honest, 1 if they are not or something failed, 2 for a wrong argument, 4 for a file that cannot be written.
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "calibrate.hpp"
#include "modal_report.hpp"
#include "plate_report.hpp"
#include "reference.hpp"
#include "report.hpp"

namespace {

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

int run(int argc, char** argv) {
  const std::string markdown = "--markdown=";
  const std::string first = argc > 1 ? argv[1] : "";
  if (first == "--make-reference" && argc == 3) {
    validate::make_reference(argv[2]);
    return 0;
  }
  if (first == "--make-unseen-reference" && argc == 3) {
    validate::make_unseen_reference(argv[2]);
    return 0;
  }
  if (first == "--make-pair-reference" && argc == 3) {
    validate::make_pair_reference(argv[2]);
    return 0;
  }
  if (first == "--make-sphere-reference" && argc == 3) {
    validate::make_sphere_reference(argv[2]);
    return 0;
  }
  if (first == "--make-half-space-reference" && argc == 3) {
    validate::make_half_space_reference(argv[2]);
    return 0;
  }
  if (first == "--make-plate-reference" && argc == 3) {
    validate::make_plate_reference(argv[2]);
    return 0;
  }
  if (first == "--make-unseen-plate-reference" && argc == 3) {
    validate::make_unseen_plate_reference(argv[2]);
    return 0;
  }
  if (first == "--make-modal-reference" && argc == 3) {
    validate::make_modal_reference(argv[2]);
    return 0;
  }
  if (first == "--make-lossy-reference" && argc == 3) {
    validate::make_lossy_reference(argv[2]);
    return 0;
  }
  if (first == "--make-relaxing-reference" && argc == 3) {
    validate::make_relaxing_reference(argv[2]);
    return 0;
  }
  if (first == "--relaxing" && argc == 2) return validate::write_relaxing(std::cout) ? 0 : 1;
  if (first == "--make-vibrating-reference" && argc == 3) {
    validate::make_vibrating_reference(argv[2]);
    return 0;
  }
  if (first == "--make-oblique-reference" && argc == 3) {
    validate::make_oblique_reference(argv[2]);
    return 0;
  }
  if (first == "--calibrate" && argc == 2) return validate::write_calibration(std::cout) ? 0 : 1;
  if (first == "--plates" && argc == 2) return plates() ? 0 : 1;
  if (first == "--modal" && argc == 2) return validate::write_modal(std::cout) ? 0 : 1;
  if (argc == 1) return report("");
  if (argc == 2 && first.rfind(markdown, 0) == 0) return report(first.substr(markdown.size()));
  std::cerr << "usage: stoss_validate [--markdown=FILE | --calibrate | --plates | --modal | --relaxing]\n       "
               "stoss_validate "
               "--make-reference FILE\n"
               "       stoss_validate --make-unseen-reference FILE\n"
               "       stoss_validate --make-pair-reference FILE\n"
               "       stoss_validate --make-sphere-reference FILE\n"
               "       stoss_validate --make-half-space-reference FILE\n"
               "       stoss_validate --make-plate-reference FILE\n"
               "       stoss_validate --make-unseen-plate-reference FILE\n"
               "       stoss_validate --make-modal-reference FILE\n"
               "       stoss_validate --make-lossy-reference FILE\n"
               "       stoss_validate --make-relaxing-reference FILE\n"
               "       stoss_validate --make-vibrating-reference FILE\n"
               "       stoss_validate --make-oblique-reference FILE\n";
  return 2;
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
