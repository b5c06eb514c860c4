// SPDX-License-Identifier: BSD-2-Clause
#include "cli/rl_update_log.h"

#include <fmt/format.h>

#include <utility>

namespace soarbox::cli {

std::string RlUpdateText(const kernel::Agent& agent, const kernel::RlUpdate& update) {
  return fmt::format("RL update {} {:g} {:g} {:g} -> {:g} {:g} {:g}", agent.production(update.rule).name,
                     update.old_current, update.old_future, update.old_current + update.old_future, update.new_current,
                     update.new_future, update.new_current + update.new_future);
}

RlUpdateLog::~RlUpdateLog() {
  agent_.RemoveObserver(*this);
}

bool RlUpdateLog::SetPath(const std::string& path) {
  std::ofstream file;
  if (!path.empty()) {
    file.open(path, std::ios::app);
    if (!file) return false;
    agent_.AddObserver(*this, kernel::Mask(kernel::Event::kReinforcement));
  } else {
    agent_.RemoveObserver(*this);
  }
  file_ = std::move(file);
  return true;
}

void RlUpdateLog::OnRlUpdate(const kernel::Agent& agent, const kernel::RlUpdate& update) {
  file_ << RlUpdateText(agent, update) << std::endl;
}

}  // namespace soarbox::cli
