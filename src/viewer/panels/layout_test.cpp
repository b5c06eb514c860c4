// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace soarbox::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::size_t Places(const Layout& layout, workbench::PanelId panel) {
  std::size_t places = 0;
  for (const AreaLayout& area : layout.areas) {
    for (const workbench::PanelId there : area.panels) places += there == panel ? 1 : 0;
  }
  return places;
}

TEST(Layout, OffersEveryPanelOnceFromTheStart) {
  Layout layout = DefaultLayout();
  EXPECT_FALSE(layout.IsOpen(workbench::PanelId::kExercise)) << "few runs take part in one";
  layout.Offer(workbench::PanelId::kExercise);
  layout.Offer(workbench::PanelId::kExercise);
  for (const workbench::PanelInfo& info : workbench::kPanelInfos) {
    EXPECT_EQ(Places(layout, info.id), 1u) << info.word;
    EXPECT_EQ(workbench::kPanelInfos[static_cast<std::size_t>(info.id)].id, info.id) << info.word;
    EXPECT_EQ(workbench::FindPanel(info.word), info.id);
  }
  EXPECT_TRUE(layout.IsVisible(workbench::PanelId::kAgents));
  EXPECT_FALSE(layout.IsVisible(workbench::PanelId::kProblems));
}

TEST(Layout, ShowsClosesAndMovesPanels) {
  Layout layout = DefaultLayout();
  layout.Show(workbench::PanelId::kWhy);
  EXPECT_TRUE(layout.IsVisible(workbench::PanelId::kWhy));
  EXPECT_FALSE(layout.IsVisible(workbench::PanelId::kMind));
  layout.Close(workbench::PanelId::kWhy);
  EXPECT_FALSE(layout.IsOpen(workbench::PanelId::kWhy));
  EXPECT_TRUE(layout.IsVisible(workbench::PanelId::kMemory)) << "its neighbour comes to the front";
  layout.Show(workbench::PanelId::kWhy);
  EXPECT_EQ(layout.at(Area::kRight).panels.back(), workbench::PanelId::kWhy) << "where it belongs";
  layout.Move(workbench::PanelId::kWhy, Area::kLeft);
  EXPECT_TRUE(layout.IsVisible(workbench::PanelId::kWhy));
  EXPECT_EQ(Places(layout, workbench::PanelId::kWhy), 1u);
  layout.at(Area::kLeft).shown = false;
  EXPECT_FALSE(layout.IsVisible(workbench::PanelId::kWhy));
  layout.Show(workbench::PanelId::kWhy);
  EXPECT_TRUE(layout.at(Area::kLeft).shown);
}

TEST(Layout, PanelsHaveKeysOfTheirOwn) {
  std::string keys;
  for (const workbench::PanelInfo& info : workbench::kPanelInfos) {
    EXPECT_TRUE(info.key >= 'A' && info.key <= 'Z') << info.word;
    EXPECT_EQ(keys.find(info.key), std::string::npos) << info.word;
    keys.push_back(info.key);
  }
}

TEST(Layout, WhoHasNoneYetIsLedThroughTheWindowUntilHeHasHadEnough) {
  EXPECT_FALSE(DefaultLayout().first_steps) << "pictures and scripts show the window as it is";
  EXPECT_TRUE(LoadLayout("/nowhere/window.ini").first_steps);
  Layout layout = DefaultLayout();
  EXPECT_FALSE(ReadLayout(ToText(layout), LoadLayout("/nowhere/window.ini")).first_steps);
  layout.first_steps = true;
  EXPECT_TRUE(ReadLayout(ToText(layout), DefaultLayout()).first_steps);
}

TEST(Layout, ComesBackFromItsText) {
  Layout layout = DefaultLayout();
  layout.Move(workbench::PanelId::kConsole, Area::kLeft);
  layout.Close(workbench::PanelId::kPlots);
  layout.at(Area::kRight).size = 512;
  layout.at(Area::kBottom).shown = false;
  layout.SetText(150);
  const Layout read = ReadLayout(ToText(layout), DefaultLayout());
  EXPECT_EQ(ToText(read), ToText(layout));
  EXPECT_EQ(read.text_percent, 150);
  EXPECT_FALSE(read.IsOpen(workbench::PanelId::kPlots));
  EXPECT_TRUE(read.IsVisible(workbench::PanelId::kConsole));
}

TEST(Layout, TakesWhatItUnderstandsOfAnyText) {
  const Layout layout = ReadLayout(
      "text 9999\n"
      "left shown nan 0 agents\n"
      "right hidden 1e30 77 mind unicorn mind why agents\n"
      "bottom\n\x01\xff garbage\n",
      DefaultLayout());
  EXPECT_EQ(layout.text_percent, Layout::kMostText_percent);
  EXPECT_LE(layout.at(Area::kRight).size, 4000);
  EXPECT_FALSE(layout.at(Area::kRight).shown);
  EXPECT_LT(layout.at(Area::kRight).front, layout.at(Area::kRight).panels.size());
  EXPECT_EQ(Places(layout, workbench::PanelId::kMind), 1u);
}

TEST(Layout, OfSomePanelsHasTheseAlone) {
  const Layout layout = LayoutOf({workbench::PanelId::kWhy, workbench::PanelId::kMind, workbench::PanelId::kTrace});
  EXPECT_THAT(layout.at(Area::kRight).panels, ElementsAre(workbench::PanelId::kWhy, workbench::PanelId::kMind));
  EXPECT_TRUE(layout.IsVisible(workbench::PanelId::kWhy));
  EXPECT_TRUE(layout.IsVisible(workbench::PanelId::kTrace));
  EXPECT_FALSE(layout.at(Area::kLeft).shown);
}

TEST(Layout, IsRememberedInAFileAndSaysIfItCannotBe) {
  const auto folder = std::filesystem::temp_directory_path() / ("soarbox-layout-" + std::to_string(getpid()));
  const auto file = folder / "deep/window.ini";
  Layout fresh = DefaultLayout();
  fresh.first_steps = true;
  EXPECT_EQ(ToText(LoadLayout(file)), ToText(fresh));
  Layout layout = DefaultLayout();
  layout.Show(workbench::PanelId::kRules);
  ASSERT_TRUE(SaveLayout(layout, file).ok());
  EXPECT_TRUE(LoadLayout(file).IsVisible(workbench::PanelId::kRules));
  std::ofstream(folder / "no-folder") << "a file";
  const Result<void> failed = SaveLayout(layout, folder / "no-folder/window.ini");
  ASSERT_FALSE(failed.ok());
  EXPECT_THAT(failed.error().file, HasSubstr("no-folder"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace soarbox::viewer
