#include "prediction/idealized.hpp"

#include <utility>

#include "encounter/participant.hpp"
#include "stoss/encounter/kinds.hpp"

namespace stoss::prediction {

Encounter without_yield(Encounter encounter) {
  for (Participant* each : {&encounter.first, &encounter.against}) {
    std::erase_if(each->values, [](const auto& of) { return of.first.starts_with("yield"); });
  }
  return encounter;
}

Encounter as_it_yields(Encounter encounter) {
  for (Participant* each : {&encounter.first, &encounter.against}) {
    if (parameter(kind(each->kind), "yield_strength") == nullptr) continue;
    if (const auto strength = strength_of(*each)) each->values["yield_strength"] = *strength;
  }
  return with_smooth_faces(std::move(encounter));
}

Encounter with_smooth_faces(Encounter encounter) {
  for (Participant* each : {&encounter.first, &encounter.against}) {
    std::erase_if(each->values, [](const auto& of) { return is_of_face(of.first) && !of.first.starts_with("yield"); });
  }
  return encounter;
}

}  // namespace stoss::prediction
