#include "contact/contact_cache.hpp"

namespace stoss {

SetUp make_set_up(const Contact& contact, const ContactGrid& grid, ResidualMotion::Inertia inertia, double step,
                  const Poll& poll) {
  Residuals residuals(contact, grid, inertia, step, poll);
  auto compliance = std::make_shared<const FactoredCompliance>(residuals.compliance(poll), grid.recess.size(), poll);
  return {std::move(residuals), std::move(compliance)};
}

ContactCache::Grid ContactCache::key_of(const Contact& contact, const ContactGrid& grid, double step) {
  return {contact.first.get(),
          contact.second.get(),
          contact.cutoff,
          contact.radius,
          grid.points.spacing,
          grid.points.count,
          step};
}

std::shared_ptr<const SetUp> ContactCache::of(const Contact& contact, const ContactGrid& grid,
                                              ResidualMotion::Inertia inertia, double step, const Poll& poll) {
  // Some eight matrices between the nodes each: 16 MB are 60 set-ups of 64 nodes.
  const std::size_t size = 8 * sizeof(double) * grid.points.count * grid.points.count;
  return cached_.of({key_of(contact, grid, step), inertia}, size,
                    [&] { return make_set_up(contact, grid, inertia, step, poll); });
}

std::shared_ptr<const ModeTables> ContactCache::modes(const Contact& contact, const ContactGrid& grid, double step,
                                                      Kicks kicks) {
  const std::size_t size = sizeof(double) * (6 * mode_count(contact) + 2 * grid.shape.size());
  return modes_.of({key_of(contact, grid, step), kicks}, size, [&] { return ModeTables(contact, grid, step, kicks); });
}

std::shared_ptr<const ModeTables> mode_tables(const Contact& contact, const ContactGrid& grid, double step,
                                              Kicks kicks) {
  if (contact.cache != nullptr) return contact.cache->modes(contact, grid, step, kicks);
  return std::make_shared<const ModeTables>(contact, grid, step, kicks);
}

}  // namespace stoss
