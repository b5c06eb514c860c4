// SPDX-License-Identifier: BSD-2-Clause
#include <charconv>
#include <cstdint>

#include "sml/client/agent_data.h"
#include "sml/client/sml_ClientFloatElement.h"
#include "sml/client/sml_ClientIntElement.h"
#include "sml/client/sml_ClientStringElement.h"
#include "sml/wire/message.h"

namespace sml {

namespace {

/// Storage for numbers that are read as text without a buffer.
thread_local std::string number_text;

}  // namespace

long long IdentifierKey(std::string_view name) {
  if (name.size() < 2 || name[0] < 'A' || name[0] > 'Z') return 0;
  std::uint64_t number = 0;
  const auto [stop, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
  if (error != std::errc() || stop != name.data() + name.size() || number >> 56 != 0) return 0;
  return IdentifierKey(name[0], number);
}

void AssignIdentifierName(std::string& out, long long key) {
  char buffer[32];
  char* const end = buffer + sizeof buffer;
  char* begin = end;
  auto number = static_cast<std::uint64_t>(key & ((1LL << 56) - 1));
  do {
    *--begin = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  *--begin = static_cast<char>(key >> 56);
  out.assign(begin, static_cast<std::size_t>(end - begin));
}

WMElement::~WMElement() = default;
StringElement::~StringElement() = default;
IntElement::~IntElement() = default;
FloatElement::~FloatElement() = default;

Agent* WMElement::GetAgent() {
  return parent_ ? parent_->GetAgent() : agent_;
}

bool WMElement::IsJustAdded() {
  Agent* const agent = output_ ? GetAgent() : nullptr;
  if (agent) AgentData::Of(*agent).memory.DropOldChanges();
  return just_added_;
}

char const* WMElement::GetIdentifierName() const {
  return parent_ ? parent_->GetIdentifierSymbol() : "";
}

bool WMElement::DestroyWME() {
  Agent* const agent = GetAgent();
  return agent && agent->DestroyWME(this);
}

void WMElement::DebugString(std::string& result) {
  std::string value;
  result += "(" + std::to_string(time_tag_) + ": " + GetIdentifierName() + " ^" + attribute_ + " ";
  result += GetValueAsString(value);
  result += ")\n";
}

void StringElement::Update(char const* value) {
  if (GetAgent()) GetAgent()->Update(this, value);
}
char const* StringElement::GetValueAsString() const {
  return value_.c_str();
}
char const* StringElement::GetValueAsString(std::string& buf) const {
  buf = value_.c_str();
  return buf.c_str();
}

void IntElement::Update(long long value) {
  if (GetAgent()) GetAgent()->Update(this, value);
}
char const* IntElement::GetValueAsString() const {
  return GetValueAsString(number_text);
}
char const* IntElement::GetValueAsString(std::string& buf) const {
  buf = std::to_string(value_);
  return buf.c_str();
}

void FloatElement::Update(double value) {
  if (GetAgent()) GetAgent()->Update(this, value);
}
char const* FloatElement::GetValueAsString() const {
  return GetValueAsString(number_text);
}
char const* FloatElement::GetValueAsString(std::string& buf) const {
  buf = soarbox::wire::ShortDouble(value_);
  return buf.c_str();
}

}  // namespace sml
