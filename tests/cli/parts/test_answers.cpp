// What a subcommand answers is what the library gives: every quantity of the tables, with its error, its unit, in SI.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "answers.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/prediction/quantities.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/oblique_curve.hpp"
#include "stoss/restitution/quantities.hpp"
#include "stoss/vibration/quantities.hpp"

namespace stoss::cli {
namespace {

TEST(Answers, OfOneImpactAreThoseOfTheLibrary) {
  for (const Case& each : {ball, ringing, rigid, disk, solid_disk, rods, solid_rods, glass}) {
    SCOPED_TRACE(each.options);
    const double speed = each.speed_in_c();
    for (const bool radiating : {true, false}) {
      const auto document =
          answer("impact", each, "--cutoff 9 --speed " + each.speed + (radiating ? "" : " --tail static"));
      const Contact contact = contact_of(each.encounter(), 9.0, speed);
      const Tail tail = radiating ? Tail::radiating : Tail::quasistatic;
      ImpactOptions options{.resolution = {.tail = tail}};
      if (const Vibration& its = each.encounter().vibration; !its.empty())
        options.start = approach(contact, speed, its);
      const Impact result = impact(contact, speed, options);
      expect_all(document, 0, impact_quantities(), result, each.encounter());
      EXPECT_EQ(document.at("modes").size(), result.energy.modes.size());
      EXPECT_EQ(document.at("inputs").at("cutoff"), 9.0);
    }
  }
}

TEST(Answers, OfRestitutionAreThoseOfTheLibrary) {
  for (const Case& each : {ball, ringing, rigid, disk, solid_disk, rods, solid_rods, glass}) {
    SCOPED_TRACE(each.options);
    const auto document =
        answer("restitution", each, "--tolerance 0.1 --absolute 1e-3 --threads 2 --speed " + each.speed);
    const Restitution result =
        best_restitution(refinable(each.encounter()), each.speed_in_c(),
                         {.tolerance = 0.1, .absolute = 1e-3, .vibration = each.encounter().vibration});
    expect_all(document, 0, restitution_quantities(), result, each.encounter());
    const Json& record = document.at("records").at(0);
    for (std::size_t i = 0; i < result.runs.size(); ++i) {
      EXPECT_EQ(record.at("runs").at(i), Json(to_json(run_quantities(), std::vector{result.runs[i]}).front()));
    }
    EXPECT_EQ(record.at("ledger"), Json(to_json(ledger_quantities(), std::vector{result.finest.energy}).front()));
  }
}

TEST(Answers, OfRestitutionAreToTheErrorThatWasAskedFor) {
  for (const auto& [words, tolerance, absolute] : {std::tuple{"--tolerance 1e-5 --absolute 1e-4", 1e-5, 1e-4},
                                                   std::tuple{"--tolerance 0.03 --absolute 0", 0.03, 0.0}}) {
    const auto document = answer("restitution", ball, std::string(words) + " --speed 0.01");
    const Restitution result =
        best_restitution(refinable(ball.encounter()), 0.01, {.tolerance = tolerance, .absolute = absolute});
    expect_all(document, 0, restitution_quantities(), result, ball.encounter());
  }
}

TEST(Answers, OfObliqueCollisionsAreThoseOfTheLibrary) {
  for (const Case& each : {ball, ringing, rigid, disk, glass}) {
    SCOPED_TRACE(each.options);
    const double speed = each.speed_in_c();
    const auto document =
        answer("oblique", each, "--tolerance 0.1 --friction 0.2 --angle 20,-60 --speed " + each.speed);
    std::vector<ObliqueCase> cases;
    for (const double angle : {20.0, -60.0})
      cases.push_back({speed, {.tangential = tangential_at(angle, speed), .friction = 0.2}});
    const auto results = oblique_curve(refinable(each.encounter()), cases,
                                       {.each = {.tolerance = 0.1, .vibration = each.encounter().vibration}});
    for (std::size_t i : {0U, 1U}) {
      expect_all(document, i, oblique_quantities(), results[i], each.encounter());
      EXPECT_EQ(document["records"][i]["ledger"],
                Json(to_json(oblique_ledger_quantities(), std::vector{results[i].finest.energy}).front()));
      EXPECT_EQ(document["records"][i]["angle"], i == 0 ? 20.0 : -60.0);
    }
  }
}

TEST(Answers, OfObliqueCollisionsTakeVelocitiesAndSpins) {
  const auto document = answer("oblique", ball,
                               "--against same --tolerance 0.2 --friction 0.3 --speed 0.05 "
                               "--tangential 0.02 --spin -0.01,0.01 --second-spin 0.03");
  Encounter encounter = ball.encounter();
  encounter.against = {.kind = "same"};
  const std::vector<ObliqueCase> cases{{0.05, {0.02, -0.01, 0.03, 0.3}}, {0.05, {0.02, 0.01, 0.03, 0.3}}};
  const auto results = oblique_curve(refinable(encounter), cases, {.each = {.tolerance = 0.2}});
  for (std::size_t i : {0U, 1U}) expect_all(document, i, oblique_quantities(), results[i], encounter);
}

TEST(Answers, OfEnsemblesAreThoseOfTheLibrary) {
  for (const Case& each : {ball, glass}) {
    const auto document =
        answer("distribution", each, "--temperature 0.01 --samples 3 --seed 7 --error 0.01 --speed " + each.speed);
    const RefinableContact contact = refinable(each.encounter());
    const auto samples =
        restitution_distribution(contact, each.speed_in_c(), thermal(contact, 0.01, usual_highest(contact)),
                                 {.samples = 3, .seed = 7, .error = 0.01});
    for (std::size_t i = 0; i < 3; ++i) expect_all(document, i, sample_quantities(), samples[i], each.encounter());
    const DistributionSummary all = summary(samples);
    for (const auto& [name, dimension, help, value, error] : distribution_quantities()) {
      expect_number(document.at("summary"), name, number(value(all)));
    }
  }
}

TEST(Answers, OfSequencesAreThoseOfTheLibrary) {
  for (const Case& each : {ball, solid_disk}) {
    const bool si = units_of(each.encounter()).si.has_value();
    const auto document =
        answer("bounce", each,
               std::string("--cutoff 6 --count 3 --flight-time ") + (si ? "0.05" : "20") + " --speed " + each.speed);
    const double speed = each.speed_in_c(),
                 unit = si ? unit_in_si(Dimension::time, *units_of(each.encounter()).si) : 1.0;
    const Contact contact = contact_of(each.encounter(), 6.0, slowest_bounce(speed));
    const auto all = bounce(contact, speed, {.count = 3, .flight_time = si ? 0.05 / unit : 20.0});
    for (std::size_t i = 0; i < 3; ++i) expect_all(document, i, bounce_quantities(), all[i], each.encounter());
  }
}

TEST(Answers, OfPredictionsAreThoseOfTheLibrary) {
  const auto document =
      answer("predict", glass, "--adhesion 0.1 --uncertainty young=0.2 --tolerance 0.01 --speed 0.1,1");
  std::vector<double> speeds;
  for (const char* typed : {"0.1", "1"}) {
    speeds.push_back(Case{"", glass.document, typed}.speed_in_c() * speed_unit(glass.encounter()));
  }
  const auto all = predict(glass.encounter(), speeds,
                           {.work_of_adhesion = 0.1, .uncertainties = {{"young", 0.2}}, .tolerance = 0.01});
  for (std::size_t i : {0U, 1U}) {
    for (const auto& [name, dimension, help, value, error] : prediction_quantities()) {
      const Value got = value(all[i]);
      if (const auto* number = std::get_if<double>(&got)) expect_number(document["records"][i], name, *number);
    }
    EXPECT_EQ(document["records"][i]["influences"].size(), all[i].influences.size());
  }
}

}  // namespace
}  // namespace stoss::cli
