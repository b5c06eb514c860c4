// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/panels/panel_layout.h"
#include "workbench/document/filled_run_fixture.h"

namespace soarbox::viewer {

/// A run of some seconds with panels that are drawn by ImGui alone, without a display.
class PanelStage : public workbench::FilledRun {
 public:
  PanelStage();
  ~PanelStage();
  PanelStage(const PanelStage&) = delete;
  PanelStage& operator=(const PanelStage&) = delete;

  void SetSize(int new_width, int new_height, int new_percent);
  /// Draws some frames with this layout or panel, as a user would see it, and reads the texts of the last frame.
  void Draw(const Layout& arranged, const std::function<void(Workspace&)>& in_the_last = {});
  void Draw(workbench::PanelId panel, const std::function<void(Workspace&, workbench::PanelId)>& in_the_last = {});
  /// Returns the text that the panel's copy command gives.
  std::string Copy(workbench::PanelId panel);

  int width = 1280, height = 720, percent = 100;
  std::vector<world::UiSnapshot> script_ui;  ///< Panels of the scenario's scripts.
  PictureRect cover;                         ///< The part of the picture that was covered.
  std::string shown;
  std::vector<std::string> complaints;
  std::vector<std::string> overfull;  ///< Windows with more vertices than can be drawn.

 private:
  ImGuiContext* context_ = nullptr;
  PanelFonts fonts_;
};

/// Tests of panels share one stage.
class Panels : public testing::Test {
 protected:
  static void SetUpTestSuite() { stage = std::make_unique<PanelStage>(); }
  static void TearDownTestSuite() { stage.reset(); }
  /// Draws the panel and expects these texts in it.
  static void ExpectShown(workbench::PanelId panel, const std::vector<const char*>& texts);

  inline static std::unique_ptr<PanelStage> stage;
};

}  // namespace soarbox::viewer
