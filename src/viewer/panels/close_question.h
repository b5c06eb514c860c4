// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "viewer/panels/panel.h"

namespace soarbox::viewer {

/// Asks the user before the window closes if typed text would be lost.
class Closing {
 public:
  /// Called when the window is about to close. Returns true if it may close: nothing would be lost, or the user has
  /// agreed. Returns false if the user is asked; the command kQuit follows if the user agrees. `unsent`: a sentence for
  /// each text that was typed into a panel and not sent.
  bool MayClose(const workbench::Contents& contents, std::vector<std::string> unsent);
  /// Draws the question, if there is one.
  void Draw(PanelFrame& frame, float width, float height);
  bool is_open() const { return is_open_; }
  void Stay() { is_open_ = saves_ = false; }

 private:
  bool is_open_ = false, agreed_ = false;
  bool saves_ = false;  ///< The window closes once everything is saved.
  int waited_ = 0;      ///< Frames since then.
  std::vector<std::string> unsent_;
};

}  // namespace soarbox::viewer
