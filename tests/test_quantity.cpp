#include "stoss/quantity.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/prediction/quantities.hpp"
#include "stoss/quasistatic/quantities.hpp"
#include "stoss/restitution/quantities.hpp"
#include "stoss/vibration/quantities.hpp"

namespace stoss {
namespace {

template <typename Result>
const Quantity<Result>& named(const Quantities<Result>& quantities, const std::string& name) {
  for (const auto& quantity : quantities) {
    if (quantity.name == name) return quantity;
  }
  throw std::out_of_range(name);
}

TEST(Quantity, IsAMemberOrAFunctionOfTheResult) {
  struct Measured {
    double value, error;
  };
  struct Found {
    double length = 2.5;
    int count = 3;
    bool good = true;
    Measured force{4.0, 0.5};
  };
  const Quantities<Found> all{
      {"length", Dimension::length, "", &Found::length},
      {"count", Dimension::none, "", &Found::count},
      {"good", Dimension::none, "", &Found::good},
      {"name", Dimension::none, "", [](const Found& f) { return std::string(f.good ? "good" : "bad"); }},
      {"force", Dimension::force, "", &Found::force},
  };
  const Found found;
  EXPECT_EQ(all[0].value(found), Value(2.5));
  EXPECT_EQ(all[1].value(found), Value(3L));
  EXPECT_EQ(all[2].value(found), Value(true));
  EXPECT_EQ(all[3].value(found), Value(std::string("good")));
  EXPECT_EQ(all[4].value(found), Value(4.0));
  EXPECT_EQ(all[4].error(found), 0.5);
  EXPECT_FALSE(all[0].error);
}

template <typename Result>
void expect_names_and_sentences(const Quantities<Result>& quantities) {
  std::set<std::string> names, sentences;
  for (const auto& [name, dimension, help, value, error] : quantities) {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos) << name;
    EXPECT_TRUE(sentences.insert(help).second) << name << ": " << help;
    EXPECT_TRUE(!help.empty() && help.size() <= 100 && help.back() != '.' && help.front() < 'a')
        << name << ": " << help;
    const Value of_nothing = value(Result{});
    EXPECT_TRUE((dimension == Dimension::none && !error) || std::holds_alternative<double>(of_nothing)) << name;
  }
}

TEST(Quantities, HaveNamesAndSentencesOfTheirOwn) {
  expect_names_and_sentences(impact_quantities());
  expect_names_and_sentences(ledger_quantities());
  expect_names_and_sentences(mode_energy_quantities());
  expect_names_and_sentences(snapshot_quantities());
  expect_names_and_sentences(oblique_impact_quantities());
  expect_names_and_sentences(oblique_snapshot_quantities());
  expect_names_and_sentences(restitution_quantities());
  expect_names_and_sentences(run_quantities());
  expect_names_and_sentences(bodies::disk::mode_quantities());
  expect_names_and_sentences(bodies::sphere::mode_quantities());
  expect_names_and_sentences(quasistatic::slow_impact_quantities());
  expect_names_and_sentences(quasistatic::rayleigh_quantities());
  expect_names_and_sentences(quasistatic::driven_mode_quantities());
  expect_names_and_sentences(quasistatic::half_space_radiation_quantities());
  expect_names_and_sentences(quasistatic::point_slow_impact_quantities());
  expect_names_and_sentences(quasistatic::point_rayleigh_quantities());
  expect_names_and_sentences(oblique_ledger_quantities());
  expect_names_and_sentences(oblique_quantities());
  expect_names_and_sentences(oblique_run_quantities());
  expect_names_and_sentences(prediction_quantities());
  expect_names_and_sentences(bounce_quantities());
  expect_names_and_sentences(sample_quantities());
  expect_names_and_sentences(distribution_quantities());
}

TEST(Quantities, OfAnImpactAddUp) {
  const Impact hit = impact(contact(disk(0.33, 25.0), HardWall{}), 0.1);
  double sum = 0.0;
  for (const char* name : {"translation", "vibration", "unresolved", "energy_error"}) {
    sum += std::get<double>(named(impact_quantities(), name).value(hit));
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_EQ(std::get<std::int64_t>(named(impact_quantities(), "modes").value(hit)),
            static_cast<std::int64_t>(hit.energy.modes.size()));
}

TEST(Quantities, ThatConvergeHaveAnError) {
  std::set<std::string> with_error;
  for (const auto& quantity : restitution_quantities()) {
    if (quantity.error) with_error.insert(quantity.name);
  }
  EXPECT_TRUE(with_error.contains("restitution") && with_error.contains("contact_time"));
  EXPECT_FALSE(with_error.contains("cutoff") || with_error.contains("steps"));
}

// c of a bar of steel, from its constants.
TEST(Units, OfADiskInSi) {
  const Material steel{2.1e11, 0.3, 7850.0};
  const Scales si = scales(steel, Plane::stress, 0.01);
  EXPECT_NEAR(unit_in_si(Dimension::speed, si), 5172.2, 0.1);
  EXPECT_DOUBLE_EQ(unit_in_si(Dimension::length, si) * unit_in_si(Dimension::inverse_length, si), 1.0);
  EXPECT_NEAR(unit_in_si(Dimension::time, si) * unit_in_si(Dimension::frequency, si), 1.0, 1e-15);
  EXPECT_DOUBLE_EQ(unit_in_si(Dimension::energy, si), unit_in_si(Dimension::force, si) * 0.01);
  EXPECT_EQ(unit_in_si(Dimension::none, si), 1.0);
}

TEST(Units, HaveNames) {
  EXPECT_EQ(unit_name(Dimension::time, UnitSystem::disk), "R/c");
  EXPECT_EQ(unit_name(Dimension::time, UnitSystem::rod), "L/c");
  EXPECT_EQ(unit_name(Dimension::force, UnitSystem::disk_si), "N/m");
  EXPECT_EQ(unit_name(Dimension::force, UnitSystem::rod_si), "N");
  EXPECT_EQ(unit_name(Dimension::time, UnitSystem::sphere), "R/c");
  EXPECT_EQ(unit_name(Dimension::force, UnitSystem::sphere), "mc^2/R");
  EXPECT_EQ(unit_name(Dimension::force, UnitSystem::sphere_si), "N");
  EXPECT_EQ(unit_name(Dimension::energy, UnitSystem::sphere_si), "J");
  EXPECT_EQ(unit_name(Dimension::none, UnitSystem::rod), "");
  EXPECT_EQ(dimension_name(Dimension::inverse_length), "inverse length");
}

}  // namespace
}  // namespace stoss
