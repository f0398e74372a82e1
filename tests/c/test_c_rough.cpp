// Bodies with rough faces in the C interface: as a document has them, and what is refused.
#include <gtest/gtest.h>

#include <string>

#include "stoss/stoss.h"

namespace {

double rebound_of(const stoss_contact* contact) {
  const double speed = 0.1;
  stoss_result result{};
  EXPECT_EQ(stoss_curve(contact, &speed, 1, 1e-2, 1e-3, nullptr, &result), STOSS_OK) << stoss_message();
  return result.restitution.value;
}

TEST(CRoughness, IsThatOfADocument) {
  stoss_body *smooth = nullptr, *rough = nullptr, *block = nullptr, *rough_block = nullptr;
  ASSERT_EQ(stoss_sphere_make(0.3, 2.0, 1.0, 1.0, 0.0, &smooth), STOSS_OK);
  ASSERT_EQ(stoss_half_space_make(0.3, 1.0, 1.0, 0.0, &block), STOSS_OK);
  ASSERT_EQ(stoss_rough_make(smooth, 0.02, &rough), STOSS_OK) << stoss_message();
  ASSERT_EQ(stoss_rough_make(block, 0.02, &rough_block), STOSS_OK) << stoss_message();
  stoss_contact *at_wall = nullptr, *wall = nullptr, *soft = nullptr, *pair = nullptr, *document = nullptr;
  ASSERT_EQ(stoss_wall_contact_make(rough, &at_wall), STOSS_OK);
  ASSERT_EQ(stoss_open(R"({"first":{"kind":"sphere","poisson":0.3},"against":{"kind":"wall","u0":0.01}})", &wall),
            STOSS_OK);
  ASSERT_EQ(
      stoss_open(R"({"first":{"kind":"sphere","poisson":0.3},"against":{"kind":"exponential","hardness":100}})", &soft),
      STOSS_OK)
      << stoss_message();
  ASSERT_EQ(stoss_pair_contact_make(rough, rough_block, &pair), STOSS_OK) << stoss_message();
  ASSERT_EQ(stoss_open(R"({"first":{"kind":"sphere","poisson":0.3,"radius":2,"u0":0.02},)"
                       R"("against":{"kind":"half-space","u0":0.02}})",
                       &document),
            STOSS_OK);
  EXPECT_GT(rebound_of(at_wall), 0.995);  // of a smooth one 0.9913
  EXPECT_EQ(rebound_of(at_wall), rebound_of(wall));
  EXPECT_EQ(rebound_of(at_wall), rebound_of(soft));
  EXPECT_EQ(rebound_of(pair), rebound_of(document));
  for (stoss_contact* each : {at_wall, wall, soft, pair, document}) {
    stoss_function* function = nullptr;
    EXPECT_EQ(stoss_function_make(each, 0.01, 0.1, 1e-2, STOSS_BEYOND_LAW, nullptr, &function), STOSS_INVALID_INPUT);
    EXPECT_NE(std::string(stoss_message()).find("smooth faces alone"), std::string::npos) << stoss_message();
    stoss_contact_free(each);
  }
  for (stoss_body* each : {smooth, rough, block, rough_block}) stoss_body_free(each);
}

TEST(CRoughness, IsRefused) {
  stoss_body *smooth = nullptr, *rough = nullptr, *none = nullptr, *still = nullptr;
  ASSERT_EQ(stoss_sphere_make(0.3, 1.0, 1.0, 1.0, 0.0, &smooth), STOSS_OK);
  ASSERT_EQ(stoss_rough_make(smooth, 0.1, &rough), STOSS_OK);
  EXPECT_EQ(stoss_rough_make(rough, 0.1, &none), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_rough_make(smooth, -0.1, &none), STOSS_INVALID_INPUT);
  EXPECT_NE(std::string(stoss_message()).find("u0: got -0.1, allowed 0 or more"), std::string::npos);
  EXPECT_EQ(stoss_rough_make(nullptr, 0.1, &none), STOSS_INVALID_INPUT);
  const double share = 0.5, time = 1.0;
  EXPECT_EQ(stoss_relaxing_make(rough, &share, &time, 1, &none), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_rough_make(smooth, 0.0, &still), STOSS_OK);
  for (stoss_body* each : {smooth, rough, still}) stoss_body_free(each);
}

}  // namespace
