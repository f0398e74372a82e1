// Functions beside the class: what asks for single impacts alone need not have them.
#include "contact/rest.hpp"

#include "contact/hard_contact.hpp"

namespace stoss {

bool is_still(ContactResponse& response, double negligible) {
  const RadiatingTail* const tail = response.radiating();
  return tail != nullptr ? tail->is_still(negligible) : response.has_forgotten();
}

void rest(ContactResponse& response, double time) {
  if (RadiatingTail* const tail = response.radiating()) tail->rest(time);
}

}  // namespace stoss
