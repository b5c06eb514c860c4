// SPDX-License-Identifier: BSD-2-Clause
#include "mission/check_news.h"

#include "mission/check_sentences.h"

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
  // A check with `pass` is decided by all runs together. So one run that fails it is reported as undecided.
  const bool is_over_seeds = asked.pass && verdict.state != State::kTrue && verdict.state != State::kOpen;
  event.parameters = std::string(NameOf(is_over_seeds ? State::kUndecided : verdict.state));
  const std::string was = is_over_seeds ? OverSeeds(*asked.pass) : verdict.was;
  event.values = sim::CheckReport{Expectation(asked, {}, mission), was, verdict.agent, asked.marker};
  return event;
}

}  // namespace soarbox::mission
