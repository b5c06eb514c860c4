// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/output_documents.h"

#include "cli/object_printer.h"
#include "sml/server/listing.h"

namespace soarbox::server {

wire::Element AddedWme(const kernel::Agent& agent, long long tag, kernel::Symbol id, kernel::Symbol attribute,
                       kernel::Symbol value) {
  const auto text = [&](kernel::Symbol symbol) { return kernel::ToString(agent.symbols(), symbol, false); };
  wire::Element element("wme");
  element.Set("action", "add").Set("attr", text(attribute)).Set("id", text(id)).Set("tag", std::to_string(tag));
  if (!value.IsString()) element.Set("valtype", cli::ValueTypeName(value));
  element.Set("value", text(value));
  return element;
}

void AddOutput(wire::Element& command, const kernel::Agent& agent, std::span<const kernel::OutputChange> changes,
               bool first) {
  const kernel::WmeInfo link = OutputLinkWme(agent);
  const auto add_link = [&] {
    if (link.timetag == 0) return;
    command.children.push_back(
        AddedWme(agent, static_cast<long long>(link.timetag), link.id, link.attribute, link.value));
  };
  add_link();
  for (const kernel::OutputChange& change : changes) {
    if (!change.added) continue;
    command.children.push_back(
        AddedWme(agent, static_cast<long long>(change.timetag), change.id, change.attribute, change.value));
  }
  if (first) add_link();
  for (const kernel::OutputChange& change : changes) {
    if (!change.added) command.Add("wme").Set("action", "remove").Set("tag", std::to_string(change.timetag));
  }
}

}  // namespace soarbox::server
