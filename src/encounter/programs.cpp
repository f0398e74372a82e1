// One table of laws, and one of programs, from which the options of the command, the checks of the Python package and
// the tests of the documentation follow.
#include "stoss/encounter/programs.hpp"

namespace stoss {

const std::vector<FittedLaw>& fitted_laws() {
  static const std::vector<FittedLaw> laws{
      {"linear", "spring and dashpot"},
      {"tsuji", "Hertz with a constant alpha"},
      {"viscoelastic", "Kuwabara and Kono, Brilliantov and Poeschel"},
      {"hunt-crossley", "Hertz times (1 + lambda v)"},
      {"thornton", "elastic-plastic spheres"},
      {"walton", "three numbers: e, mu, beta0; without friction one e"},
      {"mujoco", "solref"},
      {"table", "rows of speed and eps"},
      {"polynomial", "both coefficients by the angle of impact, at one speed"},
  };
  return laws;
}

const std::vector<FittedProgram>& fitted_programs() {
  constexpr auto never = "never run";
  static const std::vector<FittedProgram> programs{
      {"lammps", "LAMMPS", {"linear", "tsuji", "viscoelastic"}, "pair_style granular", "in tests, 29 Sep 2021"},
      {"liggghts", "LIGGGHTS", {"linear", "tsuji", "viscoelastic"}, "pair_style gran", "in tests, 3.8.0"},
      {"yade", "Yade", {"linear", "tsuji"}, "a material and its contact", "in tests, 2023.02a"},
      {"mercurydpm", "MercuryDPM", {"linear", "tsuji"}, "a species", never},
      {"kratos", "Kratos DEM", {"tsuji"}, "MaterialsDEM.json", never},
      {"mfix", "MFIX", {"linear"}, "keywords of mfix.dat", never},
      {"lethe", "Lethe", {"tsuji"}, "Lagrangian physical properties", never},
      {"chrono", "Chrono", {"linear", "viscoelastic"}, "a material for smooth contacts", never},
      {"simbody", "Simbody", {"hunt-crossley"}, "a ContactMaterial of both bodies", "in tests, 3.7"},
      {"drake", "Drake", {"hunt-crossley"}, "proximity properties of both bodies, for point contact", never},
      {"mujoco", "MuJoCo", {"mujoco"}, "solref of a default geometry", "in tests, 2.2.2"},
      {"gazebo", "Gazebo Classic", {"walton"}, "SDF of both surfaces: one e", never},
      {"physx", "PhysX", {"walton"}, "a material and the threshold of the scene: one e", never},
      {"isaac", "Isaac Sim", {"walton"}, "the same in USD", never},
      {"newton", "Newton", {"walton"}, "a ShapeConfig: one e", never},
      {"acutrace", "Altair AcuTrace", {"table"}, "rows of speed and eps", never},
      {"aspherix", "Aspherix", {"table"}, "rows of speed and eps", never},
      {"fluent", "Ansys Fluent", {"polynomial"}, "coefficients for the wall of the discrete phase", never},
  };
  return programs;
}

}  // namespace stoss
