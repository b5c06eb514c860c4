// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/listing.h"

#include <algorithm>
#include <climits>

#include "kernel/base/known_symbols.h"

namespace soarbox::server {

kernel::WmeInfo OutputLinkWme(const kernel::Agent& agent) {
  if (agent.goals().empty()) return {};
  const kernel::Symbol io = agent.memory().ValueOf(agent.goals().top().id, kernel::words::kIo);
  if (!io.IsIdentifier()) return {};
  for (const kernel::WmeId wme : agent.memory().WmesOf(io)) {
    if (agent.memory().wme(wme).attribute == kernel::words::kOutputLink) return agent.Describe(wme);
  }
  return {};
}

std::vector<InputListing> ListInput(HostedAgent& hosted) {
  const kernel::Agent& agent = hosted.agent();
  const auto tags = hosted.input().ClientTags();
  std::vector<InputListing> listing;
  std::vector<kernel::Symbol> open{agent.InputLinkIdentifier()};
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (!open[i].IsIdentifier()) continue;
    for (const kernel::WmeId wme : agent.memory().WmesOf(open[i])) {
      const kernel::WmeInfo info = agent.Describe(wme);
      const auto known = std::lower_bound(tags.begin(), tags.end(), std::make_pair(wme, LLONG_MIN));
      const bool found = known != tags.end() && known->first == wme;
      listing.push_back({info, found ? known->second : static_cast<long long>(info.timetag)});
      if (info.value.IsIdentifier() && std::find(open.begin(), open.end(), info.value) == open.end())
        open.push_back(info.value);
    }
  }
  return listing;
}

}  // namespace soarbox::server
