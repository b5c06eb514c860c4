// SPDX-License-Identifier: BSD-2-Clause
#include "vocabulary/vocabulary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "vocabulary/command_check.h"
#include "vocabulary/percept_sink.h"
#include "vocabulary/vocabulary_percepts.h"

namespace soarbox::vocabulary {
namespace {

SaidCommand Say(std::string name, PerceptList parameters = {}) {
  return {1, std::move(name), std::move(parameters), true};
}

TEST(Vocabulary, NamesAreUniqueAndEveryReasonIsExplained) {
  std::set<std::string_view> names;
  for (const CommandRow& row : Commands()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    std::string_view reasons = row.reasons;
    while (!reasons.empty()) {
      const std::size_t end = std::min(reasons.find(' '), reasons.size());
      EXPECT_NE(FindReason(reasons.substr(0, end)), nullptr) << row.name << ": " << reasons.substr(0, end);
      reasons.remove_prefix(std::min(end + 1, reasons.size()));
    }
  }
  names.clear();
  for (const PerceptRow& row : Percepts()) {
    EXPECT_TRUE(names.insert(row.path).second) << row.path;
    EXPECT_NE(FindSense(row.sense), nullptr) << row.path;
  }
}

TEST(Percept, NumbersAreRoundedToTheStepOfTheirRowAndKeptInItsRange) {
  PerceptLister lister;
  lister.Number(RowOf("self.speed"), 1.2345);
  lister.Number(RowOf("self.heading"), 400);
  lister.Number(RowOf("self.position.x"), -0.01);
  const PerceptList& list = lister.list();
  EXPECT_EQ(std::get<double>(list[0].value), 1.2);
  EXPECT_EQ(std::get<std::int64_t>(list[1].value), 359);
  EXPECT_FALSE(std::signbit(std::get<double>(list[2].value)));
}

TEST(CommandCheck, AMisspeltCommandIsAnErrorThatNamesTheNearest) {
  const CommandFault fault = CheckCommand(Say("folow"));
  EXPECT_EQ(fault.reason, "unknown-command");
  EXPECT_NE(fault.text.find("did you mean ^follow?"), std::string::npos) << fault.text;
}

TEST(CommandCheck, ParametersAreCheckedForPresenceTypeAndRange) {
  EXPECT_TRUE(CheckCommand(Say("move-to", {{"waypoint", 0, std::string("gate")}})).ok());
  EXPECT_EQ(CheckCommand(Say("move-to")).reason, "no-place");
  EXPECT_EQ(CheckCommand(Say("move-to", {{"x", 0, 3.0}})).parameter, "z");
  EXPECT_EQ(CheckCommand(Say("follow")).reason, "missing-parameter");
  EXPECT_EQ(CheckCommand(Say("set-speed", {{"speed", 0, std::string("fast")}})).reason, "bad-value");
  EXPECT_EQ(CheckCommand(Say("set-speed", {{"speed", 0, 1000.0}})).reason, "bad-value");
  EXPECT_EQ(CheckCommand(Say("stance", {{"as", 0, std::string("sitting")}})).reason, "bad-value");
  const CommandFault slip = CheckCommand(Say("move-to", {{"waipoint", 0, std::string("gate")}}));
  EXPECT_EQ(slip.reason, "unknown-parameter");
  EXPECT_NE(slip.text.find("did you mean ^waypoint?"), std::string::npos) << slip.text;
}

TEST(CommandCheck, MessagesCarryWhateverTheirAuthorPutsBesideThem) {
  EXPECT_TRUE(
      CheckCommand(Say("broadcast", {{"about", 0, std::string("enemy")}, {"where", 0, std::string("gate")}})).ok());
}

TEST(Percepts, AreRoundedAsTheStandardLibraryRounds) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> about(-50, 50);
  for (int i = 0; i < 20'000; ++i) {
    const double value = i % 3 == 0 ? std::round(about(random) * 4) / 2 + 0.5 : about(random);
    EXPECT_EQ(Rounded(value), std::round(value)) << value;
  }
  for (const double value : {0.49999999999999994, -0.49999999999999994, 4503599627370495.5, 4503599627370496.0, 1e300,
                             -1e300, -0.5, 0.5, 1.5, 2.5})
    EXPECT_EQ(Rounded(value), std::round(value)) << value;
  const auto row = [](double step) { return Number("x", "self", "m", 0, 0, step, ""); };
  EXPECT_EQ(AsPerceived(row(0.1), 0.349), 0.3);
  EXPECT_EQ(AsPerceived(row(0.25), -0.4), -0.5);
  EXPECT_EQ(AsPerceived(row(1), 2.5), 3);
  EXPECT_EQ(AsPerceived(row(5), 12.6), 15);
  EXPECT_EQ(AsPerceived(row(0), 12.6), 12.6);
  EXPECT_FALSE(std::signbit(AsPerceived(row(0.1), -0.01)));
  PerceptLister lister;
  lister.Number(row(0.1), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(lister.list().empty());
}

}  // namespace
}  // namespace soarbox::vocabulary
