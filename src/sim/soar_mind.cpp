// SPDX-License-Identifier: BSD-2-Clause
#include "sim/soar_mind.h"

#include "sml_Client.h"

namespace soarbox::sim {

SoarMind::SoarMind(sml::Agent& agent) : agent_(agent) { MakePercepts(); }

void SoarMind::MakePercepts() { distance_ = agent_.CreateFloatWME(agent_.GetInputLink(), "distance", 0.0); }

int SoarMind::Tick(float distance_squared_m2, const Perform& perform) {
  agent_.Update(distance_, distance_squared_m2);
  agent_.RunSelfTilOutput();
  const int count = agent_.GetNumberCommands();
  for (int i = 0; i < count; ++i) {
    sml::Identifier* command = agent_.GetCommand(i);
    if (command == nullptr) continue;
    const std::string name = command->GetCommandName();
    if (perform(name)) {
      command->AddStatusComplete();
    } else {
      command->AddStatusError();
    }
  }
  return count;
}

bool SoarMind::Halted() const { return agent_.GetRunState() == sml::sml_RUNSTATE_HALTED; }

void SoarMind::Restart() { agent_.InitSoar(); }

}  // namespace soarbox::sim
