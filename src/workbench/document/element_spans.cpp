// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/document/element_spans.h"

#include <utility>

#include "workbench/document/build.h"

namespace soarbox::workbench::document {

Spans ElementSpans(const debugger::MemoryRow& row, const std::string& unit, std::string meaning) {
  using debugger::Change;
  const mind::ElementFact& element = row.element;
  const bool is_gone = row.change == Change::kRemoved;
  Spans spans;
  if (row.change == Change::kAdded) spans.push_back({"+ ", Role::kNew, std::nullopt, "New in this tick"});
  if (is_gone) spans.push_back({"\xe2\x88\x92 ", Role::kGone, std::nullopt, "Gone in this tick"});
  spans.push_back({"^" + element.attribute, is_gone ? Role::kGone : Role::kName, std::nullopt, std::move(meaning)});
  const Role role = is_gone                   ? Role::kGone
                    : element.is_object       ? Role::kObject
                    : IsNumber(element.value) ? Role::kNumber
                                              : Role::kPlain;
  spans.push_back(
      {" " + ShortNumber(element.value) + (unit.empty() ? "" : " " + unit) + (element.acceptable ? " +" : ""), role});
  if (!row.about.empty()) spans.push_back(Quiet(" " + row.about));
  return spans;
}

void AddMaker(const mind::MakerFact& maker, Nodes& nodes) {
  using Kind = mind::MakerFact::Kind;
  if (maker.kind == Kind::kInput) return nodes.push_back(Text("the world: it is a percept", Role::kGood));
  if (maker.kind == Kind::kArchitecture) return nodes.push_back(Text("the architecture", Role::kQuiet));
  nodes.push_back(Text(Spans{RuleLink(maker.rule),
                             Quiet(maker.o_supported ? ", stays until it is removed" : ", goes when its reasons go")}));
  for (const mind::ElementFact& element : maker.elements) nodes.push_back(Text(Spans{{"   "}, ElementLink(element)}));
}

}  // namespace soarbox::workbench::document
