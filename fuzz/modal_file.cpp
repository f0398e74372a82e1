// A body that is read is written as a document that reads back.
#include "stoss/encounter/modal_file.hpp"
#include "oracle.hpp"

using namespace stoss;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ModalBody body;
  if (!fuzz::reads([&] { body = modal_body_from_json(fuzz::text_of(data, size)); })) return 0;
  const ModalBody again = modal_body_from_json(to_json(body));
  fuzz::hold(again.modes.size() == body.modes.size() && again.mass == body.mass && again.name == body.name,
             "the same body");
  return 0;
}
