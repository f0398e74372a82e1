// What impacts share must not be seen in them: the same bits with it and without, in any order and on any thread.
#include "contact/contact_cache.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss {
namespace {

constexpr auto all = ResidualMotion::Inertia::all;

std::vector<Contact> contacts() {
  const Body lossy = disk(Disk{.poisson = 0.33, .loss_time = 0.02})(16.0, {});
  return {contact(disk(0.33)(16.0, {})), contact(sphere(0.3)(11.0, {})), contact(lossy),
          contact(disk(0.33)(16.0, {}), disk(0.2)(16.0, {}))};
}

TEST(ContactCache, AreNotSeenInImpacts) {
  for (const Contact& shared : contacts()) {
    Contact alone = shared;
    alone.cache = nullptr;
    for (const double speed : {0.1, 0.03, 0.1}) {
      const Impact with = impact(shared, speed), without = impact(alone, speed);
      EXPECT_EQ(with.restitution, without.restitution);
      EXPECT_EQ(with.max_force, without.max_force);
      EXPECT_EQ(with.energy.unresolved, without.energy.unresolved);
      EXPECT_EQ(with.energy.dissipated, without.energy.dissipated);
    }
  }
}

TEST(ContactCache, BelongToOneGridAndStep) {
  const Contact contact = contacts().front();
  const ContactGrid grid = contact_grid(contact, 0.4, 32), finer = contact_grid(contact, 0.4, 40);
  const auto made = contact.cache->of(contact, grid, all, 0.02, {});
  EXPECT_EQ(contact.cache->of(contact, grid, all, 0.02, {}), made);
  EXPECT_NE(contact.cache->of(contact, grid, all, 0.01, {}), made);
  EXPECT_NE(contact.cache->of(contact, finer, all, 0.02, {}), made);
  EXPECT_NE(contact.cache->of(contact, grid, ResidualMotion::Inertia::none, 0.02, {}), made);
  EXPECT_EQ(contact.cache->of(contact, grid, all, 0.02, {}), made);
}

TEST(ContactCache, TheOldestGoFirst) {
  const Contact contact = contacts().front();
  const ContactGrid grid = contact_grid(contact, 0.4, 256);
  const auto oldest = contact.cache->of(contact, grid, ResidualMotion::Inertia::none, 0.02, {});
  for (int other = 1; other <= 4; ++other) {
    static_cast<void>(contact.cache->of(contact, grid, ResidualMotion::Inertia::none, 0.02 / (1 + other), {}));
  }
  EXPECT_EQ(oldest.use_count(), 1);  // ours: 16 MB hold four of 256 nodes
}

}  // namespace
}  // namespace stoss
