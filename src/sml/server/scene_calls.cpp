// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/scene_calls.h"

#include <utility>

#include "kernel/imagery/imagery.h"
#include "sml/server/client_log.h"
#include "sml/server/hosted_agent.h"

namespace soarbox::server {
namespace {

/// Null while imagery is not enabled.
kernel::Imagery* ImageryOf(HostedAgent& hosted) {
  const kernel::Imagery* const known = std::as_const(hosted).agent().find_imagery();
  return known != nullptr && known->enabled() ? &hosted.agent().imagery() : nullptr;
}

}  // namespace

bool SendScene(HostedAgent& hosted, std::string_view lines) {
  kernel::Imagery* const imagery = ImageryOf(hosted);
  if (imagery != nullptr && hosted.log != nullptr) hosted.log->Scene(hosted, lines);
  return imagery != nullptr && imagery->Send(lines);
}

std::string TakeRefusedScene(HostedAgent& hosted) {
  kernel::Imagery* const imagery = ImageryOf(hosted);
  return imagery == nullptr ? std::string() : imagery->TakeRefused();
}

std::string QueryScene(HostedAgent& hosted, std::string_view queries) {
  const kernel::Imagery* const imagery = ImageryOf(hosted);
  return imagery == nullptr ? std::string() : imagery->Query(queries);
}

}  // namespace soarbox::server
