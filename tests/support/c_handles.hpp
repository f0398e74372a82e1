#pragma once

#include <gtest/gtest.h>

#include <limits>

#include "stoss/stoss.h"

namespace stoss::test {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Frees what it holds.
template <typename Handle, void (*release)(Handle*)>
struct Owner {
  Owner() = default;
  Owner(const Owner&) = delete;
  Owner& operator=(const Owner&) = delete;
  ~Owner() { release(handle); }
  Handle** operator&() { return &handle; }
  operator Handle*() const { return handle; }
  Handle* handle = nullptr;
};
using CBody = Owner<stoss_body, stoss_body_free>;
using CContact = Owner<stoss_contact, stoss_contact_free>;
using CFunction = Owner<stoss_function, stoss_function_free>;

/// A disk at a wall, whose body is freed.
inline void make_disk_contact(CContact& contact) {
  CBody disk;
  ASSERT_EQ(stoss_disk_make(0.33, 1.0, 1.0, 1.0, 0.0, &disk), STOSS_OK);
  ASSERT_EQ(stoss_wall_contact_make(disk, &contact), STOSS_OK);
}

}  // namespace stoss::test
