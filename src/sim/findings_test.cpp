// SPDX-License-Identifier: BSD-2-Clause
#include "sim/findings.h"

#include <gtest/gtest.h>

#include "vocabulary/command_check.h"

namespace soarbox::sim {
namespace {

RunEvent OutcomeOf(const std::string& text, std::vector<explain::Reason> reasons) {
  RunEvent event;
  event.kind = EventKind::kOutcome;
  event.agent = "mouse";
  event.news = "move-to";
  event.text = text;
  event.reasons = std::move(reasons);
  return event;
}

TEST(EventFindings, AreAboutCommandsOfWrongFormOnly) {
  EventFindings findings;
  findings.See({OutcomeOf("error bad-value: this is not read", {})});
  EXPECT_TRUE(findings.refused().empty());
  findings.See({OutcomeOf(
      "error bad-value: ^waypoint of move-to is (^x 3): it takes a word",
      {{"^waypoint of move-to is an object, not its name: it takes a word", explain::Reason::Kind::kRefused}})});
  ASSERT_EQ(findings.refused().size(), 1u);
  const Finding& found = findings.refused().at("mouse");
  EXPECT_EQ(found.cause, Cause::kRefused);
  EXPECT_EQ(found.text,
            "At 0.0 s the world refused move-to of mouse: ^waypoint of move-to is an object, not its name: it takes a "
            "word");
}

TEST(CommandFaults, LeaveOutTheContentsOfObjectsInBrief) {
  vocabulary::SaidCommand command;
  command.name = "move-to";
  vocabulary::Percept& given = command.parameters.emplace_back();
  given.attribute = "waypoint";
  vocabulary::Percept inner;
  inner.attribute = "x";
  inner.value = 3.0;
  given.value = vocabulary::Percept::Object{inner};
  const vocabulary::CommandFault fault = vocabulary::CheckCommand(command);
  EXPECT_TRUE(vocabulary::IsFaultOfForm(fault.reason)) << fault.reason;
  EXPECT_EQ(fault.text, "^waypoint of move-to is (^x 3): it takes a word");
  EXPECT_EQ(fault.brief, "^waypoint of move-to is an object, not its name: it takes a word");

  command.parameters.front() = {"speed", 0, std::string("fast")};
  EXPECT_EQ(vocabulary::CheckCommand(command).brief, "");
}

}  // namespace
}  // namespace soarbox::sim
