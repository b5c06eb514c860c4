// SPDX-License-Identifier: BSD-2-Clause
// Keys, and the reasons for which a window cannot be opened; needs no display.
#include <SDL.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "viewer/input_reader.h"
#include "viewer/key_names.h"
#include "viewer/sound_player.h"
#include "viewer/viewer.h"

namespace soarbox::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void PushKey(int scancode, bool pressed, bool repeat = false) {
  SDL_Event event{};
  event.type = pressed ? SDL_KEYDOWN : SDL_KEYUP;
  event.key.keysym.scancode = static_cast<SDL_Scancode>(scancode);
  event.key.repeat = repeat ? 1 : 0;
  SDL_PushEvent(&event);
}

class InputReaderTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(SDL_InitSubSystem(SDL_INIT_EVENTS), 0); }
  void TearDown() override { SDL_QuitSubSystem(SDL_INIT_EVENTS); }
  InputReader reader_{nullptr};
};

TEST(KeyNames, AreTheSandboxsWords) {
  EXPECT_EQ(KeyName(SDL_SCANCODE_F1), "f1_key");
  EXPECT_EQ(KeyName(SDL_SCANCODE_F15), "f15_key");
  EXPECT_EQ(KeyName(SDL_SCANCODE_SPACE), "space_key");
  EXPECT_EQ(KeyName(SDL_SCANCODE_A), "a_key");
  EXPECT_EQ(KeyName(SDL_SCANCODE_3), "3_key");
  EXPECT_EQ(KeyName(SDL_SCANCODE_0), "0_key");
  EXPECT_EQ(KeyName(SDL_SCANCODE_KP_3), "numpad_3_key");
  EXPECT_EQ(KeyName(SDL_SCANCODE_LALT), "left_menu_key");
  EXPECT_EQ(KeyName(100000), "unknown_key");
  EXPECT_EQ(MouseButtonName(SDL_BUTTON_RIGHT), "right_button");
  EXPECT_EQ(MouseButtonName(4), "mouse_button_3");
}

TEST_F(InputReaderTest, KeysReachTheScriptsOncePerPressAndRelease) {
  PushKey(SDL_SCANCODE_F1, true);
  PushKey(SDL_SCANCODE_F1, true, true);
  PushKey(SDL_SCANCODE_F1, false);
  const FrameInput input = reader_.Read();
  ASSERT_EQ(input.events.size(), 2u);
  EXPECT_EQ(input.events[0].name, "f1_key");
  EXPECT_TRUE(input.events[0].pressed);
  EXPECT_FALSE(input.events[1].pressed);
  EXPECT_TRUE(input.commands.empty());
}

void PushPad(std::uint32_t type, int which, int part, int value) {
  SDL_Event event{};
  event.type = type;
  if (type == SDL_CONTROLLERAXISMOTION) {
    event.caxis.which = which;
    event.caxis.axis = static_cast<Uint8>(part);
    event.caxis.value = static_cast<Sint16>(value);
  } else {
    event.cbutton.which = which;
    event.cbutton.button = static_cast<Uint8>(part);
  }
  SDL_PushEvent(&event);
}

TEST_F(InputReaderTest, GamepadsReachTheScriptsByNameAndNumber) {
  PushPad(SDL_CONTROLLERBUTTONDOWN, 70, SDL_CONTROLLER_BUTTON_A, 1);
  PushPad(SDL_CONTROLLERAXISMOTION, 71, SDL_CONTROLLER_AXIS_LEFTY, -20000);
  PushPad(SDL_CONTROLLERAXISMOTION, 71, SDL_CONTROLLER_AXIS_LEFTY, -16384);
  PushPad(SDL_CONTROLLERAXISMOTION, 71, SDL_CONTROLLER_AXIS_LEFTX, 900);
  FrameInput input = reader_.Read();
  ASSERT_EQ(input.events.size(), 2u);
  EXPECT_EQ(input.events[0].kind, InputKind::kPad);
  EXPECT_EQ(input.events[0].name, "a_button");
  EXPECT_EQ(input.events[0].pad, 1);
  EXPECT_EQ(input.events[0].value, 1);
  // An axis is reported once per frame, and not at all near its rest.
  EXPECT_EQ(input.events[1].name, "left_y");
  EXPECT_EQ(input.events[1].pad, 2);
  EXPECT_FLOAT_EQ(input.events[1].value, -0.5f);
  PushPad(SDL_CONTROLLERAXISMOTION, 71, SDL_CONTROLLER_AXIS_LEFTY, -16390);
  EXPECT_TRUE(reader_.Read().events.empty());
}

TEST_F(InputReaderTest, AGamepadThatIsUnpluggedLetsGo) {
  PushPad(SDL_CONTROLLERBUTTONDOWN, 70, SDL_CONTROLLER_BUTTON_START, 1);
  reader_.Read();
  SDL_Event gone{};
  gone.type = SDL_CONTROLLERDEVICEREMOVED;
  gone.cdevice.which = 70;
  SDL_PushEvent(&gone);
  const FrameInput input = reader_.Read();
  ASSERT_EQ(input.events.size(), 1u);
  EXPECT_EQ(input.events[0].name, "start_button");
  EXPECT_EQ(input.events[0].value, 0);
}

TEST(SoundPlayer, HearsFromTheSideAndLessFromAfar) {
  world::SoundSnapshot sound;
  sound.volume = 0.8f;
  const world::CameraSnapshot ear{{0, 0, 0}, {}, 45};
  EXPECT_FLOAT_EQ(HeardAt(sound, ear).left, 0.8f);
  sound.in_world = true;
  sound.position = {0, 0, -10};
  EXPECT_FLOAT_EQ(HeardAt(sound, ear).left, 0.4f);
  EXPECT_FLOAT_EQ(HeardAt(sound, ear).right, 0.4f);
  sound.position = {3, 0, 0};
  EXPECT_FLOAT_EQ(HeardAt(sound, ear).left, 0);
  EXPECT_FLOAT_EQ(HeardAt(sound, ear).right, 0.8f);
}

TEST_F(InputReaderTest, CommandKeysAreCommandsAndStillReachTheScripts) {
  for (const int key :
       {SDL_SCANCODE_P, SDL_SCANCODE_N, SDL_SCANCODE_EQUALS, SDL_SCANCODE_KP_MINUS, SDL_SCANCODE_ESCAPE})
    PushKey(key, true);
  const FrameInput input = reader_.Read();
  EXPECT_THAT(input.commands, ElementsAre(ViewerCommand::kTogglePause, ViewerCommand::kSingleStep,
                                          ViewerCommand::kFaster, ViewerCommand::kSlower, ViewerCommand::kQuit));
  EXPECT_EQ(input.events.size(), 5u);
}

TEST(ViewerOpen, WithoutADisplaySaysWhichVariableIsMissing) {
  const char* before = std::getenv("DISPLAY");
  const std::string saved = before != nullptr ? before : "";
  unsetenv("DISPLAY");
  const auto none = Viewer::Open({});
  setenv("DISPLAY", ":7654", 1);
  const auto dead = Viewer::Open({});
  if (before != nullptr)
    setenv("DISPLAY", saved.c_str(), 1);
  else
    unsetenv("DISPLAY");

  ASSERT_FALSE(none.ok());
  EXPECT_THAT(none.error().message, HasSubstr("DISPLAY"));
  EXPECT_THAT(none.error().hint, HasSubstr("xvfb-run"));
  ASSERT_FALSE(dead.ok());
  EXPECT_THAT(dead.error().message, HasSubstr(":7654"));
}

TEST(ViewerOpen, RefusesSizesThatNoWindowHas) {
  const auto tiny = Viewer::Open({.width = 0, .height = -5});
  ASSERT_FALSE(tiny.ok());
  EXPECT_THAT(tiny.error().message, HasSubstr("0x-5"));
}

}  // namespace
}  // namespace soarbox::viewer
