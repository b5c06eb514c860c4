// SPDX-License-Identifier: BSD-2-Clause
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>

#include "sml/client/sml_ClientAnalyzedXML.h"
#include "sml/wire/element.h"

namespace sml {

using soarxml::ElementXML;

namespace {

bool ReadBool(char const* text, bool otherwise) {
  if (!text) return otherwise;
  if (std::strcmp(text, "true") == 0) return true;
  if (std::strcmp(text, "false") == 0) return false;
  return otherwise;
}

long long ReadInt(char const* text, long long otherwise) {
  if (!text || !*text) return otherwise;
  char* end = nullptr;
  errno = 0;
  const long long value = std::strtoll(text, &end, 10);
  return end == text || errno == ERANGE ? otherwise : value;
}

int ReadSmallInt(char const* text, int otherwise) {
  const long long value = ReadInt(text, otherwise);
  return value < INT_MIN || value > INT_MAX ? otherwise : static_cast<int>(value);
}

double ReadFloat(char const* text, double otherwise) {
  if (!text || !*text) return otherwise;
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  return end == text ? otherwise : value;
}

ElementXML ChildOf(ElementXML const& parent, char const* tag) {
  ElementXML child;
  for (int i = 0; parent.GetChild(&child, i); ++i) {
    if (child.IsTag(tag)) return child;
  }
  return ElementXML();
}

ElementXML const* OrNull(ElementXML const& element) {
  return element.element() ? &element : nullptr;
}

}  // namespace

ClientAnalyzedXML::ClientAnalyzedXML() = default;
ClientAnalyzedXML::~ClientAnalyzedXML() = default;

void ClientAnalyzedXML::Attach(ElementXML const& answer) {
  answer_ = answer;
  command_ = ChildOf(answer, "command");
  result_ = ChildOf(answer, "result");
  error_ = ChildOf(answer, "error");
}

ElementXML const* ClientAnalyzedXML::GetCommandTag() const {
  return OrNull(command_);
}
ElementXML const* ClientAnalyzedXML::GetResultTag() const {
  return OrNull(result_);
}
ElementXML const* ClientAnalyzedXML::GetErrorTag() const {
  return OrNull(error_);
}

bool ClientAnalyzedXML::IsSML() const {
  return answer_.IsTag("sml");
}

char const* ClientAnalyzedXML::GetCommandName() const {
  return command_.GetAttribute("name");
}

char const* ClientAnalyzedXML::GetResultString() const {
  return result_.element() ? result_.GetCharacterData() : nullptr;
}
int ClientAnalyzedXML::GetResultInt(int defaultValue) const {
  return ReadSmallInt(GetResultString(), defaultValue);
}
long long ClientAnalyzedXML::GetResultInt(long long defaultValue) const {
  return ReadInt(GetResultString(), defaultValue);
}
bool ClientAnalyzedXML::GetResultBool(bool defaultValue) const {
  return ReadBool(GetResultString(), defaultValue);
}
double ClientAnalyzedXML::GetResultFloat(double defaultValue) const {
  return ReadFloat(GetResultString(), defaultValue);
}

char const* ClientAnalyzedXML::GetArgString(char const* pArgName) const {
  if (!pArgName) return nullptr;
  for (ElementXML const* part : {&result_, &command_}) {
    if (!part->element()) continue;
    if (const std::string* value = part->element()->Arg(pArgName)) return value->c_str();
  }
  return nullptr;
}
bool ClientAnalyzedXML::GetArgBool(char const* pArgName, bool defaultValue) const {
  return ReadBool(GetArgString(pArgName), defaultValue);
}
int ClientAnalyzedXML::GetArgInt(char const* pArgName, int defaultValue) const {
  return ReadSmallInt(GetArgString(pArgName), defaultValue);
}
long long ClientAnalyzedXML::GetArgInt(char const* pArgName, long long defaultValue) const {
  return ReadInt(GetArgString(pArgName), defaultValue);
}
double ClientAnalyzedXML::GetArgFloat(char const* pArgName, double defaultValue) const {
  return ReadFloat(GetArgString(pArgName), defaultValue);
}

char* ClientAnalyzedXML::GenerateXMLString(bool includeChildren, bool insertNewLines) const {
  return answer_.GenerateXMLString(includeChildren, insertNewLines);
}

void ClientAnalyzedXML::DeleteString(char* pString) {
  ElementXML::DeleteString(pString);
}

}  // namespace sml
