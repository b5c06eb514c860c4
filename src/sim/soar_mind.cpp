// SPDX-License-Identifier: BSD-2-Clause
#include "sim/soar_mind.h"

#include "sml_Client.h"

namespace soarbox::sim {

SoarMind::SoarMind(sml::Agent& agent)
    : agent_(&agent), distance_(agent.CreateFloatWME(agent.GetInputLink(), "distance", 0.0)) {}

void SoarMind::Decide(float distance_squared_m2) {
  agent_->Update(distance_, distance_squared_m2);
  answer_ = agent_->RunSelfTilOutput();
  // Strings are assigned in place, so that a tick allocates nothing once the longest word has been seen.
  std::size_t count = 0;
  handles_.clear();
  for (int i = 0; i < agent_->GetNumberCommands(); ++i) {
    sml::Identifier* command = agent_->GetCommand(i);
    if (command == nullptr) continue;
    if (commands_.size() == count) commands_.emplace_back();
    commands_[count++] = command->GetCommandName();
    handles_.push_back(command);
  }
  commands_.resize(count);
}

void SoarMind::Answer(std::size_t index, bool succeeded) {
  if (succeeded) {
    handles_[index]->AddStatusComplete();
  } else {
    handles_[index]->AddStatusError();
  }
}

bool SoarMind::Halted() const {
  return agent_->GetRunState() == sml::sml_RUNSTATE_HALTED;
}

std::string_view SoarMind::Breakdown() const {
  // The client API gives texts only: this is what `run` answers (cli/run_text.cpp).
  constexpr std::string_view kBeforeCause = "The agent ran out of memory: ";
  const std::size_t begin = answer_.find(kBeforeCause);
  if (begin == std::string::npos) return {};
  const std::string_view cause = std::string_view(answer_).substr(begin + kBeforeCause.size());
  return cause.substr(0, cause.find_last_not_of(".\n") + 1);
}

void SoarMind::Restart() {
  agent_->InitSoar();
}

}  // namespace soarbox::sim
