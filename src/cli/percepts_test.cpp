// SPDX-License-Identifier: BSD-2-Clause
#include "cli/percepts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "cli/interpreter.h"
#include "cli/session.h"

namespace soarbox::cli {
namespace {

using kernel::InputElement;
using kernel::InputLink;
using kernel::InputObject;
using testing::HasSubstr;

/// Chooses at random and reacts to its percepts.
constexpr const char* kPerceptRules = R"(
sp {propose (state <s> ^superstate nil ^io.input-link.thing <t>) (<t> ^x <x>)
    --> (<s> ^operator <o> + =) (<o> ^name look ^at <t> ^x <x>)}
sp {apply (state <s> ^operator <o>) (<o> ^name look ^x <x>) --> (<s> ^seen <x> ^roll (rand-float))}
sp {text (state <s> ^io.input-link.text <t>) --> (<s> ^heard <t>)}
)";

class PerceptsTest : public testing::Test {
 protected:
  struct Shell {
    Shell() {
      session.stream().SetSink([this](std::string_view text) { printed += text; });
      EXPECT_TRUE(Do(kPerceptRules).ok);
      Do("watch 5");
    }
    CommandResult Do(const std::string& line) { return interpreter.Execute(session, line); }
    kernel::Agent agent{"soar"};
    Session session{agent};
    Interpreter interpreter;
    std::string printed;
  };

  PerceptsTest() {
    folder_ = std::filesystem::temp_directory_path() /
              ("soarbox_percepts_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
    file_ = (folder_ / "input.txt").string();
  }
  ~PerceptsTest() override { std::filesystem::remove_all(folder_); }

  std::string Read() const {
    std::ostringstream content;
    content << std::ifstream(file_, std::ios::binary).rdbuf();
    return content.str();
  }
  void Write(const std::string& text) const { std::ofstream(file_, std::ios::binary) << text; }

  /// A world that changes in each cycle; with `init`, it restarts halfway.
  static void Live(Shell& shell, bool init) {
    InputLink& input = shell.agent.input();
    std::vector<InputElement> things;
    InputElement text = InputElement::kNone;
    InputObject last = InputObject::kNone;
    for (int cycle = 0; cycle < 24; ++cycle) {
      if (init && cycle == 13) {
        shell.Do("init-soar");
        things.clear();
        text = InputElement::kNone;
      }
      if (cycle % 3 == 0) {
        last = input.NewObject();
        things.push_back(input.Add(InputObject::kInputLink, "thing", last));
        input.Add(last, "x", std::int64_t{cycle - 5});
        input.Add(last, "weight", 0.1 * cycle);
      }
      if (cycle % 3 == 1) input.Add(InputObject::kInputLink, "again", last);
      if (cycle % 7 == 2) {
        const std::string words = "two\n|words\\ " + std::to_string(cycle);
        if (text == InputElement::kNone) {
          text = input.Add(InputObject::kInputLink, "text", std::string_view(words));
        } else {
          input.Update(text, std::string_view(words));
        }
      }
      if (cycle % 4 == 3) {
        input.Remove(things.front());
        things.erase(things.begin());
      }
      if (cycle % 5 == 4) input.Remove(input.Add(InputObject::kInputLink, "blink", std::int64_t{1}));
      shell.Do("run 1");
    }
  }

  std::filesystem::path folder_;
  std::string file_;
};

TEST_F(PerceptsTest, AReplayedRunIsTheRecordedOne) {
  for (const bool init : {false, true}) {
    Shell recorded;
    EXPECT_EQ(recorded.Do("capture-input").text, "closed");
    EXPECT_THAT(recorded.Do("capture-input --open " + file_).text, HasSubstr("Capturing input with random seed: "));
    EXPECT_EQ(recorded.Do("capture-input").text, "open");
    Live(recorded, init);
    EXPECT_THAT(recorded.Do("capture-input --close").text, HasSubstr("Captured "));

    Shell replayed;
    EXPECT_THAT(replayed.Do("replay-input --open " + file_).text, HasSubstr("Loaded "));
    for (int cycle = 0; cycle < 24; ++cycle) {
      if (init && cycle == 13) replayed.Do("init-soar");
      // Input of another client is ignored.
      replayed.agent.input().Add(InputObject::kInputLink, "thing", std::int64_t{99});
      replayed.Do("run 1");
    }
    EXPECT_EQ(replayed.printed, recorded.printed);
    EXPECT_EQ(replayed.Do("print -i -d 9 s1").text, recorded.Do("print -i -d 9 s1").text);
    EXPECT_GT(recorded.printed.size(), 20000u);
    replayed.printed.clear();
    replayed.Do("run 2");
    EXPECT_THAT(replayed.printed, HasSubstr("The recorded input is used up after "));
    EXPECT_EQ(replayed.Do("replay-input").text, "closed");
  }
}

TEST_F(PerceptsTest, AReplaySaysWhenTheRunIsAnother) {
  Shell recorded;
  recorded.Do("save percepts --open " + file_);
  Live(recorded, false);
  recorded.Do("save percepts --close");

  Shell other;
  other.Do("sp {more (state <s> ^superstate nil) --> (<s> ^more structure)}");
  other.Do("load percepts --open " + file_);
  other.Do("run 3");
  EXPECT_THAT(other.printed, HasSubstr("From cycle 2 on this run is not the recorded one: line "));

  Shell initialised;
  initialised.Do("load percepts --open " + file_);
  initialised.Do("run 3; init-soar");
  EXPECT_THAT(initialised.printed, HasSubstr("the agent was initialised, which the recorded one was not"));
}

TEST_F(PerceptsTest, WhatIsMissingInTheAgentEndsTheReplayWithTheLine) {
  Write("soarbox percepts 1\nseed 5\n1 add 20 X9 |a| int 1\n");
  Shell shell;
  EXPECT_EQ(shell.Do("load percepts --open " + file_).text, "Loaded 1 actions.");
  shell.Do("run 3");
  EXPECT_THAT(shell.printed, HasSubstr("ended in cycle 1 (line 3 of the recording): there is no identifier X9."));
  Write("soarbox percepts 1\nseed 5\n2 remove 77\n");
  EXPECT_TRUE(shell.Do("load percepts --open " + file_).ok);
  shell.printed.clear();
  shell.Do("run 3");
  EXPECT_THAT(shell.printed, HasSubstr("there is no element of the input link with time tag 77."));
}

TEST_F(PerceptsTest, WrongRecordingsNameTheLine) {
  Shell shell;
  const auto answer = [&](const std::string& text) {
    Write(text);
    const CommandResult result = shell.Do("load percepts --open " + file_);
    EXPECT_FALSE(result.ok);
    return result.text;
  };
  const std::string head = "soarbox percepts 1\nseed 5\n";
  EXPECT_THAT(answer(""), HasSubstr(":1: the file ends before the recording begins"));
  EXPECT_THAT(answer("hello\n"), HasSubstr(":1: this is not a recording of input"));
  EXPECT_THAT(answer("soarbox percepts 1\nseed x\n"), HasSubstr(":2: expected 'seed'"));
  EXPECT_THAT(answer(head + "one add\n"), HasSubstr(":3: expected the number of a cycle"));
  EXPECT_THAT(answer(head + "0 add 1 I2 |a| int 1\n"), HasSubstr(":3: input enters in cycle 1"));
  EXPECT_THAT(answer(head + "2 add 1 I2 |a| int 1\n1 remove 1\n"), HasSubstr(":4: cycles must not go backwards"));
  EXPECT_THAT(answer(head + "1 put 1\n"), HasSubstr(":3: expected add, remove, init or end"));
  EXPECT_THAT(answer(head + "1 add -4 I2 |a| int 1\n"), HasSubstr(":3: expected a time tag"));
  EXPECT_THAT(answer(head + "1 add 4 thing |a| int 1\n"), HasSubstr(":3: expected an identifier"));
  EXPECT_THAT(answer(head + "1 add 4 I2 a int 1\n"), HasSubstr(":3: expected an attribute between bars"));
  EXPECT_THAT(answer(head + "1 add 4 I2 |a| number 1\n"), HasSubstr(":3: expected int, float, string, id or new"));
  EXPECT_THAT(answer(head + "1 add 4 I2 |a| float nan\n"), HasSubstr(":3: expected a float"));
  EXPECT_THAT(answer(head + "1 add 4 I2 |a| string |open\n"), HasSubstr(":3: expected a text between bars"));
  EXPECT_THAT(answer(head + "1 add 4 I2 |a| int 1 2\n"), HasSubstr(":3: something is left over"));
  EXPECT_THAT(answer(head + "1 end\n1 remove 4\n"), HasSubstr(":4: something follows the end"));
  EXPECT_THAT(shell.Do("load percepts --open " + (folder_ / "none").string()).text, HasSubstr("Failed to open"));
  EXPECT_THAT(shell.Do("load percepts --close").text, HasSubstr("not being replayed"));
  EXPECT_THAT(shell.Do("save percepts --flush").text, HasSubstr("not being recorded"));
}

TEST_F(PerceptsTest, RecordingAndReplayExcludeEachOther) {
  Shell shell;
  shell.Do("save percepts --open " + file_);
  EXPECT_TRUE(shell.Do("save percepts --flush").ok);
  EXPECT_THAT(Read(), testing::StartsWith("soarbox percepts 1\nseed "));
  EXPECT_THAT(shell.Do("save percepts --open " + file_).text, HasSubstr("already"));
  EXPECT_THAT(shell.Do("load percepts --open " + file_).text, HasSubstr("is being recorded"));
  EXPECT_TRUE(shell.Do("save percepts --close").ok);
  EXPECT_TRUE(shell.Do("load percepts --open " + file_).ok);
  EXPECT_THAT(shell.Do("save percepts --open " + file_).text, HasSubstr("is being replayed"));
  EXPECT_TRUE(shell.Do("load percepts --close").ok);
}

}  // namespace
}  // namespace soarbox::cli
