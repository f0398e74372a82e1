// Who meets whom: materials, modes, encounters and the contacts that are made of them.
#include <algorithm>
#include <map>
#include <optional>

#include "stoss/bodies/disk/modes.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/encounter/collision.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/inputs.hpp"
#include "stoss/encounter/laws.hpp"
#include "stoss/encounter/materials.hpp"
#include "stoss/encounter/relaxing.hpp"
#include "stoss/encounter/roughness.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/encounter/waves.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/relaxation/measurement.hpp"
#include "stoss/restitution/ladder.hpp"
#include "support.hpp"

namespace stoss::python {
namespace {

/// Pairs of shares and times, or None.
std::optional<std::vector<std::pair<double, double>>> terms_of(const std::optional<Relaxation>& relaxation) {
  if (!relaxation) return std::nullopt;
  std::vector<std::pair<double, double>> terms;
  for (const RelaxationTerm& each : relaxation->terms) terms.emplace_back(each.share, each.time);
  return terms;
}

py::list all_materials() {
  py::list all;
  for (const NamedMaterial& each : named_materials()) {
    const Material& its = each.material;
    all.append(py::make_tuple(
        each.name, its.young, its.poisson, its.density, its.yield_strength, its.surface_energy, its.quality,
        its.frequency == usual_frequency ? std::nullopt : std::optional(its.frequency), terms_of(its.relaxation)));
  }
  return all;
}

/// At one cutoff, with some or all of the modes of a body at a wall.
Contact contact_at(const Encounter& encounter, double cutoff, double slowest) {
  return computed([&](const Poll& poll) {
    const BodyMaker second = second_maker(encounter);
    if (second) return contact(first_maker(encounter), second, cutoff, slowest, poll);
    return contact(first_maker(encounter)(cutoff, poll), wall_of(encounter));
  });
}

py::tuple to_tuple(const Scales& si) { return py::make_tuple(si.length, si.speed, si.time, si.frequency, si.force); }

/// Numbers of an input of a question, in units of the first body.
auto in_units_of_first(const Encounter& encounter, const std::string& question, const std::string& name,
                       const Doubles& given) {
  const auto asked =
      std::find_if(questions().begin(), questions().end(), [&](const auto& each) { return each.second == question; });
  if (asked == questions().end()) throw std::invalid_argument("question: one of the table");
  const Input& its = input(asked->first, name);
  const auto scales = si_scales(encounter);
  const UnitSystem system = unit_system(encounter);
  return over([&](double each) { return in_own_units(its, each, scales, system); }, given);
}

/// Collisions, a row each, in units of the first body: speed, tangential, spin, second spin, friction.
/// @param given numbers of each, by the names of the inputs
auto collisions(const Encounter& encounter, const std::map<std::string, Doubles>& given) {
  std::vector<double> rows;
  const py::ssize_t count = given.at("speed").size();
  for (py::ssize_t i = 0; i < count; ++i) {
    const auto number = [&](const char* name) {
      const auto found = given.find(name);
      return found == given.end() ? std::nullopt : std::optional(found->second.data()[i]);
    };
    const auto [speed, before] = own_units(
        encounter, {number("speed").value(), number("tangential").value_or(0.0), number("angle"),
                    number("spin").value_or(0.0), number("second_spin").value_or(0.0), number("friction").value()});
    rows.insert(rows.end(), {speed, before.tangential, before.spin, before.second_spin, before.friction});
  }
  return take(std::move(rows), {count, 5});
}

/// The modes of a kind of body, and the displacement of one of them.
template <typename Mode, typename Displacement>
void bind_modes(py::module_& module, const std::string& body, std::vector<Mode> (*modes)(double, double, const Poll&),
                std::vector<Displacement> (*displacement)(double, const Mode&, const std::vector<double>&,
                                                          const Poll&)) {
  def(module, (body + "_modes").c_str(), {"poisson", "cutoff"}, [modes](double poisson, double cutoff) {
    return take(computed([&](const Poll& poll) { return modes(poisson, cutoff, poll); }));
  });
  def(module, (body + "_displacement").c_str(), {"poisson", "order", "omega", "radial", "tangential", "radii"},
      [displacement](double poisson, int order, double omega, double radial, double tangential, const Doubles& radii) {
        const std::vector<double> at = to_vector(radii);
        return take(computed([&](const Poll& poll) {
          return displacement(poisson, {order, 0, omega, radial, tangential}, at, poll);
        }));
      });
}

void bind_contacts(py::module_& module) {
  py::class_<SlowLaw> law(module, "SlowLaw", "What the restitution is below the range of a function.");
  py::class_<Contact> contact(module, "Contact", "What meets what, with its kept modes.");
  py::class_<RefinableContact> refinable(module, "RefinableContact", "What meets what, at any of a ladder of cutoffs.");
  seal(law);
  seal(contact);
  seal(refinable);
  def(contact, "with_modes", {"keep"}, [](const Contact& all, const py::array_t<bool, py::array::c_style>& keep) {
    const std::vector<bool> kept(keep.data(), keep.data() + keep.size());
    return stoss::contact(with_modes(*all.first, kept), all.wall);
  });
  def(module, "no_law", [] { return SlowLaw(); });
}

}  // namespace

void bind_encounters(py::module_& module) {
  bind_contacts(module);
  def(module, "meets", {"first", "against"},
      [](const std::string& first, const std::string& against) { return meets(kind(first), kind(against)); });
  def(module, "series", {"name", "text"},
      [](const std::string& name, const std::string& text) { return parse_series(name, text); });
  def(module, "who_meets_whom", &who_meets_whom);
  def(module, "note_of_staying", &note_of_staying);
  def(module, "note_of_a_plate", {"restitution"}, &note_of_a_plate);
  def(module, "check_solid", {"kind", "numbers"},
      [](const std::string& of, const Values& numbers) { (void)maker(kind(of).solid(numbers)); });
  def(module, "check_wall", {"hardness", "strength"}, [](double hardness, double strength) {
    validate(Wall(ExponentialWall{hardness, strength}));
  });
  def(module, "check_face", {"roughness", "u0"}, [](double roughness, double u0) {
    (void)asperities_of(Participant{.kind = "wall", .values = {{"roughness", roughness}, {"u0", u0}}});
  });
  py::class_<Encounter> handle(module, "Encounter", "Who meets whom, by its JSON document.");
  seal(handle);
  def(module, "encounter", {"document"}, [](const std::string& document) { return encounter_from_json(document); });
  def(module, "participant", {"where", "text"},
      [](const std::string& where, const std::string& text) { return to_json(participant_from_json(where, text)); });
  def(module, "check_losses", {"document"}, [](const std::string& document) {
    const Participant its = participant_from_json("body", document);
    (void)losses_of(its);
    return its.material ? std::optional(its.material->young) : std::nullopt;
  });
  def(handle, "to_json", [](const Encounter& self) { return to_json(self); });
  def(handle, "own", {"question", "name", "given"}, &in_units_of_first);
  def(handle, "collisions", {"given"}, &collisions);
  def(handle, "in_c", {"speeds"}, [](const Encounter& self, const Doubles& speeds) {
    return over([unit = speed_unit(self)](double each) { return each / unit; }, speeds);
  });
  def(handle, "contact", {"cutoff", "slowest"}, &contact_at);
  def(handle, "usual_cutoff", {"speed", "most"}, [](const Encounter& self, double speed, double most) {
    return computed([&](const Poll& poll) { return usual_cutoff(self, speed, most, poll); });
  });
  def(handle, "refinable", [](const Encounter& self) { return refinable(self); });
  def(handle, "slow_law", [](const Encounter& self) { return slow_law(self); });
  def(handle, "yield_speed", [](const Encounter& self) { return yield_speed(self); });
  def(handle, "yield_warning", {"speed"},
      [](const Encounter& self, double speed) { return yield_warning(self, speed); });
  def(handle, "shell_warnings", {"fastest"},
      [](const Encounter& self, double fastest) { return shell_warnings(self, fastest); });
  def(handle, "sound_warnings", [](const Encounter& self) { return sound_warnings(self); });
  def(handle, "scales", [](const Encounter& self) { return to_tuple(si_scales(self).value()); });
  def(handle, "wave_speeds", [](const Encounter& self) {
    const auto [pressure, shear, rayleigh] = wave_speeds(self);
    return std::tuple(pressure, shear, rayleigh);
  });
  def(module, "relaxation_of_measurement", {"frequency", "storage", "loss"},
      [](const Doubles& frequency, const Doubles& storage, const Doubles& loss) {
        const FittedRelaxation its =
            relaxation_of_measurement({to_vector(frequency), to_vector(storage), to_vector(loss)});
        return py::make_tuple(terms_of(its.relaxation), its.instantaneous, its.storage_misfit, its.loss_misfit);
      });
  def(module, "shifted", {"relaxation", "c1", "c2", "reference", "temperature"},
      [](const std::vector<std::pair<double, double>>& terms, double c1, double c2, double reference,
         double temperature) {
        Relaxation given;
        for (const auto& [share, time] : terms) given.terms.push_back({share, time});
        return terms_of(shifted(given, c1, c2, reference, temperature));
      });
  def(module, "named_materials", &all_materials);
  def(module, "units_of_rigid",
      [] { return std::map<std::string, double>(units_of_rigid.begin(), units_of_rigid.end()); });
  def(module, "material_of_wave_speeds", {"c_p", "c_s", "density"}, [](double c_p, double c_s, double density) {
    const Material its = material_of_wave_speeds(c_p, c_s, density);
    return py::make_tuple(its.young, its.poisson);
  });
  def(module, "uncertainties_of_material", {"name"}, [](const std::string& name) {
    const Uncertainties& its = material_of_the_list(name).uncertainties;
    return std::map<std::string, double>{{"young", its.young},
                                         {"density", its.density},
                                         {"poisson", its.poisson},
                                         {"loss", its.loss},
                                         {"yield_strength", its.yield_strength}};
  });
  def(module, "material_of_the_list", {"name"},
      [](const std::string& name) { return std::string(material_of_the_list(name).name); });
  def(module, "plane_poisson", {"young", "poisson", "density", "strain"},
      [](double young, double poisson, double density, bool strain) {
        return plane_poisson({young, poisson, density}, strain ? Plane::strain : Plane::stress);
      });
  PYBIND11_NUMPY_DTYPE(bodies::Mode, order, index, omega, radial, tangential);
  PYBIND11_NUMPY_DTYPE(bodies::Displacement, radial, tangential);
  bind_modes<bodies::disk::Mode, bodies::disk::Displacement>(module, "disk", &bodies::disk::modes,
                                                             &bodies::disk::displacement);
  bind_modes<bodies::sphere::Mode, bodies::sphere::Displacement>(module, "sphere", &bodies::sphere::modes,
                                                                 &bodies::sphere::displacement);
}

}  // namespace stoss::python
