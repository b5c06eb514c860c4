// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include "sim/input_door.h"
#include "sim/input_names.h"
#include "sim/input_text.h"

namespace soarbox::sim {
namespace {

InputList AllKinds() {
  return {
      {1, KeyInput{"f1_key", true}},
      {1, KeyInput{"f1_key", false}},
      {2, ButtonInput{"left_button", true, 500, 300.25f}},
      {3, PointerInput{10, 20, -1, 2.5f}},
      {4, WheelInput{-2, 10, 20}},
      {5, ScreenInput{1280, 720}},
      {6, CameraInput{{0.1f, -3e10f, 2}, {0.5f, 0.5f, -0.5f, 0.5f}}},
      {7, CommandInput{"agent 1", "sp {a\n  (state <s>)\n--> # \"q\" \\n}"}},
      {8, ScriptInput{"", "x = 1"}},
      {8, ScriptInput{"agent-2", "print(\"\t\")"}},
      {9,
       ForeignBodyInput{
           "1:7:12", "tank 3", "red", "soldier", 70, "crouching", {1, 0.5f, -2}, {0.25f, 0, 1}, {0, 0, 0.5f}, 90, -3}},
      {9, ForeignShotInput{"1:7:12", "", 20, 4, {1, 2, 3}, {4, 5, 6}}},
      {9, ForeignMessageInput{"1:7:12", "", "enemy-seen", "name x range 12"}},
      {10, ForeignGoneInput{"1:7:12"}},
      {11, PanelInput{"begin again"}},
      {11, PadInput{2, "a_button", 1}},
      {11, PadInput{1, "left_y", -0.25f}},
      {18446744073709551615u, OrderInput{"agent-2", "go home"}}};
}

TEST(InputText, WhatIsWrittenReadsAsTheSame) {
  std::string text;
  for (const Input& input : AllKinds()) text += WriteInput(input) + "\n";
  const InputText read = ReadInputs(text, "x");
  EXPECT_TRUE(read.problems.empty()) << Format(read.problems.front());
  EXPECT_EQ(read.inputs, AllKinds());
}

TEST(InputText, ReadsWhatPeopleWrite) {
  const InputText read = ReadInputs(
      "# keys\n\n"
      "  30 key numpad_3_key press  # a remark\n"
      "10 button left_button click 500 300\r\n"
      "31 pointer 510 290\n"
      "32 wheel 1\n"
      "33 command seeker-1 print --depth 2 s1\n",
      "x");
  ASSERT_TRUE(read.problems.empty()) << Format(read.problems.front());
  const InputList expected = {{10, ButtonInput{"left_button", true, 500, 300}},
                              {10, ButtonInput{"left_button", false, 500, 300}},
                              {30, KeyInput{"numpad_3_key", true}},
                              {30, KeyInput{"numpad_3_key", false}},
                              {31, PointerInput{510, 290, 10, -10}},
                              {32, WheelInput{1, 510, 290}},
                              {33, CommandInput{"seeker-1", "print --depth 2 s1"}}};
  EXPECT_EQ(read.inputs, expected);
}

TEST(InputText, EachWrongLineIsToldWithItsPlaceAndTheOthersAreRead) {
  const InputText read = ReadInputs(
      "1 key f1_key down\n"
      "2 key f1key down\n"
      "x key f1_key down\n"
      "3 kye f1_key down\n"
      "4 button left_button down 5\n"
      "5 pointer nan 3\n"
      "6 command a \"b\n"
      "0 key f1_key up\n"
      "7 key f1_key sideways\n"
      "8 key f1_key up up\n"
      "9 key f1_key up\n",
      "keys.txt");
  EXPECT_EQ(read.inputs.size(), 2u);
  ASSERT_EQ(read.problems.size(), 9u);
  EXPECT_EQ(read.problems[0].line, 2);
  EXPECT_EQ(read.problems[0].column, 7);
  EXPECT_EQ(read.problems[0].hint, "did you mean 'f1_key'?");
  for (std::size_t i = 0; i < read.problems.size(); ++i) {
    EXPECT_EQ(read.problems[i].line, static_cast<int>(i) + 2);
    EXPECT_EQ(read.problems[i].file, "keys.txt");
    EXPECT_FALSE(read.problems[i].message.empty());
  }
}

TEST(InputNames, AllKeysOfTheSandboxAreThere) {
  EXPECT_EQ(KeyNames().size(), 145u + 1);  // Includes unknown_key.
}

TEST(InputDoor, InputsComeInByTickThenInTheOrderOfTheirCalls) {
  InputDoor door;
  door.Submit({2, KeyInput{"b_key", true}});
  door.Submit({1, KeyInput{"a_key", true}});
  door.Submit({2, KeyInput{"c_key", true}});
  door.Submit({0, KeyInput{"d_key", true}});
  door.BeginTick(1);
  ASSERT_EQ(door.taken().size(), 2u);
  EXPECT_EQ(door.taken()[0].value, InputValue(KeyInput{"a_key", true}));
  EXPECT_EQ(door.taken()[1], (Input{1, KeyInput{"d_key", true}}));
  door.Submit({1, KeyInput{"late_key", true}});
  door.BeginTick(2);
  ASSERT_EQ(door.taken().size(), 3u);
  EXPECT_EQ(door.taken()[2], (Input{2, KeyInput{"late_key", true}}));
  EXPECT_EQ(door.waiting(), 0u);
}

TEST(InputText, WhatAClientDidIsCountedForPeople) {
  const auto shown = [](std::string acts) { return ShownInput(WriteInput({7, CommandInput{"", std::move(acts)}})); };
  EXPECT_EQ(
      shown("agent\trobot one\nline\trobot one\tsource a\nadd\trobot one\t1\nset\trobot one\t1\ngo\trobot one\t1\n"),
      "7 client: agent robot one, 1 command line, 2 changes of input");
  EXPECT_EQ(shown("go\trobot\t1\t0\t0\t1\n"), "7 client: runs the agents");
  EXPECT_EQ(ShownInput("7 command robot print"), "7 command robot print");
  EXPECT_EQ(ShownInput("7 key a_key down"), "7 key a_key down");
}

TEST(InputDoor, WhatWasNotedStandsBeforeWhatWaited) {
  InputDoor door;
  door.Submit({1, KeyInput{"a_key", true}});
  door.Note(CommandInput{"x", "print"});
  door.BeginTick(1);
  ASSERT_EQ(door.taken().size(), 2u);
  EXPECT_EQ(door.noted(), 1u);
  EXPECT_EQ(door.taken()[0], (Input{1, CommandInput{"x", "print"}}));
}

TEST(InputDoor, MovesAddUpUntilSomethingElseComes) {
  InputDoor door;
  door.Submit({1, PointerInput{1, 1, 1, 1}});
  door.Submit({1, PointerInput{3, 2, 2, 1}});
  door.Submit({1, ButtonInput{"left_button", true, 3, 2}});
  door.Submit({1, PointerInput{4, 2, 1, 0}});
  door.BeginTick(1);
  ASSERT_EQ(door.taken().size(), 3u);
  EXPECT_EQ(door.taken()[0].value, InputValue(PointerInput{3, 2, 3, 2}));
}

TEST(InputDoor, AFloodForOneTickIsRefused) {
  InputDoor door;
  for (std::size_t i = 0; i < InputDoor::kMostPerTick; ++i) ASSERT_TRUE(door.Submit({5, KeyInput{"a_key", true}}));
  EXPECT_FALSE(door.Submit({5, KeyInput{"a_key", true}}));
  EXPECT_TRUE(door.Submit({6, KeyInput{"a_key", true}}));
}

}  // namespace
}  // namespace soarbox::sim
