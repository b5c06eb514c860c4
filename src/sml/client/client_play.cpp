// SPDX-License-Identifier: BSD-2-Clause
#include <mutex>

#include "sml/client/agent_data.h"
#include "sml/client/hold.h"
#include "sml/client/kernel_data.h"
#include "sml/client/local_agent_link.h"
#include "sml/server/client_log.h"
#include "sml/wire/message.h"
#include "soarbox_ClientLog.h"

namespace soarbox {

std::vector<std::string> PartsOfClientAct(std::string_view line) {
  return server::PartsOfLogLine(line);
}

std::string EscapedForClientAct(std::string_view part) {
  return server::EscapedForLog(part);
}

std::optional<ClientLogPart> ReadClientLog(sml::Kernel& kernel, std::uint64_t from) {
  sml::KernelData& data = sml::KernelData::Of(kernel);
  if (!data.link) return std::nullopt;
  const std::lock_guard lock(data.link->mutex());
  auto* const link = dynamic_cast<sml::LogLink*>(data.link.get());
  if (link == nullptr) return std::nullopt;
  const std::optional<std::string> text = link->ReadLog(from);
  if (!text) return std::nullopt;
  if (*text == wire::kLogEnded) return ClientLogPart{{}, true};
  return ClientLogPart{server::PartsOfLogLine(*text).front()};
}

std::string PlayClientAct(sml::Agent& agent, const std::vector<std::string>& parts) {
  sml::AgentData& data = sml::AgentData::Of(agent);
  const sml::Lock lock = sml::Hold(data);
  auto* const link = sml::LocalLinkOf(agent);
  if (link == nullptr) return "the agent's kernel is not in this process";
  std::unique_ptr<server::ClientPlayer>& player = link->host().player;
  if (!player) player = std::make_unique<server::ClientPlayer>(link->host());
  return player->Play(link->hosted(), parts);
}

}  // namespace soarbox
