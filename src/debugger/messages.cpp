// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/messages.h"

#include <fmt/format.h>

#include <algorithm>

#include "debugger/facts_text.h"
#include "sim/input_text.h"

namespace soarbox::debugger {

void MessageLog::Add(const record::TickRecord& tick) {
  const auto cut = [&] {
    rows_.pop_back();
    revision_ = NewRevision();
  };
  const auto add = [&](MessageRow row) {
    rows_.push_back(std::move(row));
    revision_ = NewRevision();
  };
  while (!rows_.empty() && rows_.back().tick >= tick.tick) cut();
  for (const std::string& line : tick.inputs) {
    if (line.find(" order ") == std::string::npos) continue;
    for (const sim::Input& input : sim::ReadInputs(line, "input").inputs) {
      const auto* order = std::get_if<sim::OrderInput>(&input.value);
      if (order != nullptr) add({tick.tick, tick.scene.time_s, "", order->agent, "order", order->order});
    }
  }
  for (const sim::RunEvent& event : tick.events)
    if (const auto* said = std::get_if<sim::Speech>(&event.values))
      add({event.tick, event.time_s, event.agent, said->to, said->about, said->text});
  while (rows_.size() > kMost) rows_.pop_front();
}

std::vector<MessageRow> MessageLog::Find(std::string_view who, std::string_view text) const {
  std::vector<MessageRow> found;
  for (const MessageRow& row : rows_) {
    const bool is_meant = who.empty() || row.from == who || row.to == who || row.to == "team " + std::string(who);
    if (is_meant && Passes(text, row.from + " " + row.to + " " + row.text)) found.push_back(row);
  }
  return found;
}

std::string ToText(const std::vector<MessageRow>& rows) {
  std::string text;
  for (const MessageRow& row : rows)
    text += fmt::format("{:8.3f} s  {} to {}: {}\n", row.time_s, row.from.empty() ? "the user" : row.from, row.to,
                        row.text);
  return rows.empty() ? "no messages\n" : text;
}

}  // namespace soarbox::debugger
