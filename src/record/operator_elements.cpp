// SPDX-License-Identifier: BSD-2-Clause
#include "record/operator_elements.h"

#include <algorithm>
#include <map>
#include <vector>

namespace soarbox::record {
namespace {

/// The elements of each object as "^attribute value", by identifier.
using Elements = std::map<std::string, std::vector<std::string>, std::less<>>;

void Follow(const mind::EventLog& events, Elements& held) {
  events.ForEach(mind::Cases{[&](const mind::ElementChanged& change) {
                               std::vector<std::string>& elements = held[std::string(change.id)];
                               std::string text = "^" + std::string(change.attribute) + " " + std::string(change.value);
                               const auto at = std::ranges::find(elements, text);
                               if (change.added && at == elements.end()) elements.push_back(std::move(text));
                               if (!change.added && at != elements.end()) elements.erase(at);
                               if (elements.empty()) held.erase(std::string(change.id));
                             },
                             [](const auto&) {}});
}

}  // namespace

Result<std::string> ElementsOfOperator(TickSource& recording, std::string_view agent, std::uint64_t tick) {
  Elements held;
  std::string selected;
  for (std::uint64_t at = recording.first_tick(); at <= tick; ++at) {
    const Result<const TickRecord*> record = recording.At(at);
    if (!record) return record.error();
    const MindRecord* const mind = FindMind(**record, agent);
    if (mind == nullptr) continue;
    Follow(mind->events, held);
    const auto take = [&](const mind::OperatorSelected& now) { selected = now.id; };
    if (at == tick) mind->events.ForEach(mind::Cases{take, [](const auto&) {}});
  }
  const auto of_operator = held.find(selected);
  if (selected.empty() || of_operator == held.end()) return std::string();
  for (const std::string& element : of_operator->second) selected += " " + element;
  return selected;
}

}  // namespace soarbox::record
