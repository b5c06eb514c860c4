// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>

#include "record/export.h"

namespace soarbox::record {
namespace {

/// A detail's text without the count in front of it, and that count.
std::pair<std::size_t, std::string_view> SplitDetail(std::string_view detail) {
  std::size_t count = 0;
  const std::size_t blank = std::min(detail.find(' '), detail.size());
  for (const char c : detail.substr(0, blank)) count = count * 10 + static_cast<std::size_t>(c - '0') % 10;
  return {count, detail.substr(std::min(blank + 1, detail.size()))};
}

/// The text that belongs to the `index`-th line, with blanks in front, if there is one.
std::string Remark(const std::vector<std::string>& remarks, std::size_t index) {
  return index < remarks.size() && !remarks[index].empty() ? "  " + remarks[index] : std::string();
}

void PrintMind(const MindRecord& mind, std::ostream& out) {
  for (const std::string& percept : mind.percepts) out << "    " << mind.agent << "  perceives " << percept << '\n';
  std::size_t decided = 0;
  const auto decide = [&](std::size_t until) {
    for (; decided < std::min(until, mind.decisions.size()); ++decided)
      out << "    " << mind.agent << "  " << mind.decisions[decided] << Remark(mind.reasons, decided) << '\n';
  };
  for (const std::string& detail : mind.details) {
    const auto [count, text] = SplitDetail(detail);
    decide(count);
    out << "    " << mind.agent << "    " << text << '\n';
  }
  decide(mind.decisions.size());
  for (std::size_t i = 0; i < mind.commands.size(); ++i) {
    const std::string rule = Remark(mind.command_rules, i);
    out << "    " << mind.agent << "  commands " << mind.commands[i] << (rule.empty() ? "" : " by") << rule << '\n';
  }
}

}  // namespace

Result<void> PrintTicks(Reader& recording, TickRange range, std::ostream& out) {
  const std::uint64_t last = std::min(range.last, recording.last_tick());
  for (std::uint64_t tick = std::max(range.first, recording.first_tick()); tick <= last; ++tick) {
    const Result<const TickRecord*> read = recording.At(tick);
    if (!read) return read.error();
    const TickRecord& record = **read;
    out << fmt::format("{:9.3f} s  tick {}  state {:016x}\n", record.scene.time_s, record.tick, record.state_hash);
    for (const std::string& input : record.inputs) out << "    input  " << input << '\n';
    for (const MindRecord& mind : record.minds) PrintMind(mind, out);
    for (const sim::Event& event : record.events) {
      // Commands stand with their minds already.
      if (event.kind == sim::EventKind::kCommand && !record.minds.empty()) continue;
      out << "    " << (event.agent.empty() ? "world" : event.agent) << "  " << sim::EventName(event.kind);
      for (const std::string* text : {&event.news, &event.text, &event.parameters})
        if (!text->empty()) out << ' ' << *text;
      out << '\n';
      for (const std::string& reason : event.reasons) out << "        " << reason << '\n';
      if (!event.diagnostic.message.empty()) out << Format(event.diagnostic);
    }
  }
  return {};
}

}  // namespace soarbox::record
