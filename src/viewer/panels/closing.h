// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "viewer/panels/panel.h"

namespace soarbox::viewer {

/// Asks before the window closes over something that was typed and not saved.
class Closing {
 public:
  /// The window is about to close. True if it may close at once: nothing would be lost, or the user has agreed.
  /// False: the user is asked, and a command kQuit follows if the user agrees. `unsent`: what was typed into
  /// panels and not sent, a sentence each.
  bool MayClose(const workbench::Contents& contents, std::vector<std::string> unsent);
  /// The question, while there is one.
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
