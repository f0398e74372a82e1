// Bodies that relax in the C interface: as a document has them, and what is refused.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "stoss/stoss.h"

namespace {

constexpr std::array<double, 2> shares{0.5, 0.2}, times{1.0, 10.0};

double restitution(const stoss_contact* contact) {
  const double speed = 0.1;
  stoss_result result{};
  EXPECT_EQ(stoss_curve(contact, &speed, 1, 1e-2, 1e-3, nullptr, &result), STOSS_OK) << stoss_message();
  return result.restitution.value;
}

TEST(CRelaxation, IsThatOfADocument) {
  stoss_body *elastic = nullptr, *body = nullptr;
  stoss_contact *contact = nullptr, *document = nullptr;
  ASSERT_EQ(stoss_sphere_make(0.3, 1.0, 1.0, 1.0, 0.0, &elastic), STOSS_OK);
  ASSERT_EQ(stoss_relaxing_make(elastic, shares.data(), times.data(), 2, &body), STOSS_OK) << stoss_message();
  ASSERT_EQ(stoss_wall_contact_make(body, &contact), STOSS_OK);
  ASSERT_EQ(stoss_open(R"({"first":{"kind":"sphere","poisson":0.3,"relaxation":[[0.5,1],[0.2,10]]}})", &document),
            STOSS_OK)
      << stoss_message();
  EXPECT_LT(restitution(contact), 0.9);
  EXPECT_EQ(restitution(contact), restitution(document));
  double slow[2] = {0.0, 0.0};
  for (const stoss_contact* each : {contact, document}) {
    stoss_function* function = nullptr;
    ASSERT_EQ(stoss_function_make(each, 0.01, 0.1, 1e-2, STOSS_BEYOND_LAW, nullptr, &function), STOSS_OK);
    const double speed = 0.005;
    EXPECT_EQ(stoss_function_evaluate(function, &speed, 1, &slow[each == contact ? 0 : 1], nullptr), STOSS_OK);
    stoss_function_free(function);
  }
  EXPECT_LT(slow[0], 0.9);
  EXPECT_EQ(slow[0], slow[1]);
  stoss_body* again = nullptr;
  EXPECT_EQ(stoss_relaxing_make(body, shares.data(), times.data(), 2, &again), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_relaxing_make(elastic, nullptr, times.data(), 2, &again), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_relaxing_make(elastic, times.data(), times.data(), 2, &again), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_relaxing_make(elastic, nullptr, nullptr, 0, &again), STOSS_OK);
  for (stoss_body* each : {elastic, body, again}) stoss_body_free(each);
  stoss_contact_free(contact);
  stoss_contact_free(document);
}

TEST(CRelaxation, IsNotThatOfALossyOrARigidBody) {
  stoss_body *elastic = nullptr, *lossy = nullptr, *rigid = nullptr, *none = nullptr;
  ASSERT_EQ(stoss_sphere_make(0.3, 1.0, 1.0, 1.0, 0.0, &elastic), STOSS_OK);
  ASSERT_EQ(stoss_sphere_make(0.3, 1.0, 1.0, 1.0, 0.1, &lossy), STOSS_OK);
  ASSERT_EQ(stoss_rigid_make(elastic, &rigid), STOSS_OK);
  for (stoss_body* each : {lossy, rigid}) {
    EXPECT_EQ(stoss_relaxing_make(each, shares.data(), times.data(), 2, &none), STOSS_INVALID_INPUT);
    EXPECT_NE(std::string(stoss_message()).find("elastic: it is rigid or rough, has a loss_time or relaxes"),
              std::string::npos);
  }
  for (stoss_body* each : {elastic, lossy, rigid}) stoss_body_free(each);
}

}  // namespace
