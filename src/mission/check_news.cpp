// SPDX-License-Identifier: BSD-2-Clause
#include "mission/check_news.h"

#include "mission/sentences.h"

namespace soarbox::mission {

sim::RunEvent CheckNews(const Mission& mission, std::size_t check, const Verdict& verdict, std::uint64_t tick,
                        double time_s) {
  const Check& asked = mission.checks[check];
  sim::RunEvent event;
  event.kind = sim::EventKind::kNews;
  event.news = "check";
  event.tick = tick;
  event.time_s = time_s;
  event.text = asked.name;
  event.parameters = std::string(NameOf(verdict.state));
  event.reasons = {Expectation(asked, {}, mission), verdict.was, verdict.agent, asked.marker ? "marker" : ""};
  return event;
}

}  // namespace soarbox::mission
