// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include "record/export.h"
#include "sim/input_text.h"
#include "wording/mind_words.h"

namespace soarbox::record {
namespace {

/// The remark with leading blanks, if it is not empty.
std::string Aside(const std::string& remark) {
  return remark.empty() ? remark : "  " + remark;
}

void PrintMind(const MindRecord& mind, std::ostream& out) {
  const wording::MindWords words = wording::Words(mind.events, false);
  for (const std::string& percept : words.percepts) out << "    " << mind.agent << "  perceives " << percept << '\n';
  std::size_t decided = 0;
  mind::Event event;
  for (std::size_t at = 0; mind.events.Next(at, event);) {
    if (mind::IsDetail(event)) {
      out << "    " << mind.agent << "    " << wording::DetailLine(event) << '\n';
    } else if (!wording::DecisionLine(event).empty()) {
      out << "    " << mind.agent << "  " << words.decisions[decided] << Aside(words.reasons[decided]) << '\n';
      ++decided;
    }
  }
  for (std::size_t i = 0; i < words.commands.size(); ++i) {
    const std::string rule = Aside(words.command_rules[i]);
    out << "    " << mind.agent << "  commands " << words.commands[i] << (rule.empty() ? "" : " by" + rule) << '\n';
  }
}

}  // namespace

Result<void> PrintTicks(Reader& recording, TickRange range, std::ostream& out) {
  return ForEachTick(recording, range, [&](const TickRecord& record) {
    out << fmt::format("{:9.3f} s  tick {}  state {:016x}\n", record.scene.time_s, record.tick, record.state_hash);
    for (const std::string& input : record.inputs) out << "    input  " << sim::ShownInput(input) << '\n';
    for (const MindRecord& mind : record.minds) PrintMind(mind, out);
    for (const sim::RunEvent& event : record.events) {
      // Commands are printed with their minds.
      if (event.kind == sim::EventKind::kCommand && !record.minds.empty()) continue;
      out << "    " << (event.agent.empty() ? "world" : event.agent) << "  " << sim::EventName(event.kind);
      for (const std::string* text : {&event.news, &event.text, &event.parameters})
        if (!text->empty()) out << ' ' << *text;
      out << '\n';
      // The text of an outcome contains its reason.
      if (event.kind != sim::EventKind::kOutcome)
        for (const std::string& remark : sim::Remarks(event)) out << "        " << remark << '\n';
      if (!event.diagnostic.message.empty()) out << Format(event.diagnostic);
    }
  });
}

}  // namespace soarbox::record
