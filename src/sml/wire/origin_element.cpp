// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/origin_element.h"

#include <charconv>
#include <string>
#include <string_view>

#include "sml/wire/decision_element.h"

namespace soarbox::wire {
namespace {

using mind::OriginElementFact;
using mind::OriginFact;

template <typename Number>
void SetNumber(Element& element, const char* name, Number value) {
  element.Set(name, std::to_string(value));
}

std::uint64_t ReadNumber(const Element& element, std::string_view name, std::uint64_t missing = 0) {
  const std::string* const text = element.Attribute(name);
  if (text == nullptr) return missing;
  std::uint64_t value = missing;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  return error == std::errc() && end == text->data() + text->size() ? value : missing;
}

std::string ReadText(const Element& element, std::string_view name) {
  const std::string* const text = element.Attribute(name);
  return text == nullptr ? std::string() : *text;
}

void Add(Element& parent, const OriginElementFact& matched) {
  Element& element = parent.Add("matched");
  SetNumber(element, "timetag", matched.element.timetag);
  element.Set("id", matched.element.id).Set("attribute", matched.element.attribute).Set("value", matched.element.value);
  SetNumber(element, "flags", (matched.element.acceptable ? 1 : 0) + (matched.element.is_object ? 2 : 0));
  SetNumber(element, "source", static_cast<int>(matched.source));
  if (matched.origin != mind::kNoOrigin) SetNumber(element, "origin", matched.origin);
}

void Add(Element& parent, const OriginFact& fact) {
  Element& origin = parent.Add("origin");
  origin.Set("rule", fact.rule).Set("state", fact.state).Set("op", fact.op).Set("name", fact.op_name);
  SetNumber(origin, "decision", fact.decision);
  SetNumber(origin, "flags", (fact.o_supported ? 1 : 0) + (fact.is_operator ? 2 : 0));
  SetNumber(origin, "level", fact.level);
  SetNumber(origin, "left_out", fact.left_out);
  if (fact.op_origin != mind::kNoOrigin) SetNumber(origin, "op_origin", fact.op_origin);
  for (const std::uint32_t proposal : fact.proposals) SetNumber(origin.Add("proposal"), "origin", proposal);
  for (const OriginElementFact& matched : fact.matched) Add(origin, matched);
  if (fact.decided) AddDecision(origin, *fact.decided);
}

OriginElementFact ReadMatched(const Element& element, std::uint32_t count) {
  OriginElementFact matched;
  const std::uint64_t flags = ReadNumber(element, "flags");
  matched.element = {ReadNumber(element, "timetag"), ReadText(element, "id"), ReadText(element, "attribute"),
                     ReadText(element, "value"),     (flags & 1) != 0,        (flags & 2) != 0};
  const std::uint64_t source = ReadNumber(element, "source");
  if (source <= static_cast<std::uint64_t>(OriginElementFact::Source::kArchitecture))
    matched.source = static_cast<OriginElementFact::Source>(source);
  const std::uint64_t origin = ReadNumber(element, "origin", mind::kNoOrigin);
  if (origin < count) matched.origin = static_cast<std::uint32_t>(origin);
  return matched;
}

OriginFact ReadOrigin(const Element& element, std::uint32_t count) {
  OriginFact fact;
  fact.rule = ReadText(element, "rule");
  fact.state = ReadText(element, "state");
  fact.op = ReadText(element, "op");
  fact.op_name = ReadText(element, "name");
  fact.decision = ReadNumber(element, "decision");
  const std::uint64_t flags = ReadNumber(element, "flags");
  fact.o_supported = (flags & 1) != 0;
  fact.is_operator = (flags & 2) != 0;
  fact.level = static_cast<int>(ReadNumber(element, "level"));
  fact.left_out = static_cast<std::uint32_t>(ReadNumber(element, "left_out"));
  const std::uint64_t op_origin = ReadNumber(element, "op_origin", mind::kNoOrigin);
  if (op_origin < count) fact.op_origin = static_cast<std::uint32_t>(op_origin);
  for (const Element& child : element.children) {
    if (child.tag == "matched") fact.matched.push_back(ReadMatched(child, count));
    if (child.tag != "proposal") continue;
    const std::uint64_t proposal = ReadNumber(child, "origin", mind::kNoOrigin);
    if (proposal < count) fact.proposals.push_back(static_cast<std::uint32_t>(proposal));
  }
  fact.decided = ReadDecision(element);
  return fact;
}

}  // namespace

void AddOrigins(Element& parent, const mind::OriginFacts& facts) {
  Element& origins = parent.Add("origins");
  SetNumber(origins, "noted", facts.noted ? 1 : 0);
  SetNumber(origins, "timetag", facts.timetag);
  for (const OriginFact& fact : facts.origins) Add(origins, fact);
}

mind::OriginFacts ReadOrigins(const Element& parent) {
  mind::OriginFacts facts;
  const Element* const origins = parent.Child("origins");
  if (origins == nullptr) return facts;
  facts.noted = ReadNumber(*origins, "noted") != 0;
  facts.timetag = ReadNumber(*origins, "timetag");
  const auto count = static_cast<std::uint32_t>(origins->children.size());
  for (const Element& child : origins->children) facts.origins.push_back(ReadOrigin(child, count));
  return facts;
}

}  // namespace soarbox::wire
