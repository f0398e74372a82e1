// An encounter that is read is written as a document that reads back as the same.
#include "oracle.hpp"
#include "stoss/encounter/document.hpp"

using namespace stoss;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Encounter encounter;
  if (!fuzz::reads([&] { encounter = encounter_from_json(fuzz::text_of(data, size)); })) return 0;
  const std::string written = to_json(encounter);
  // The modes of a body by its file are written in Hz and read in rad/s, which rounds.
  if (encounter.first.modal || encounter.against.modal) {
    (void)encounter_from_json(written);
  } else {
    fuzz::hold(to_json(encounter_from_json(written)) == written, "written as it was read");
  }
  return 0;
}
