// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/sml_ClientTraceXML.h"
#include "sml/client/sml_ClientXML.h"

namespace sml {

using soarxml::ElementXML;

ClientXML::ClientXML() = default;
ClientXML::ClientXML(ClientXML* pXML) {
  if (pXML) element_ = pXML->element_;
}
ClientXML::ClientXML(ElementXML const& element) : element_(element) {}
ClientXML::~ClientXML() = default;

ClientTraceXML* ClientXML::ConvertToTraceXML() {
  if (auto* trace = dynamic_cast<ClientTraceXML*>(this)) return trace;
  trace_ = std::make_unique<ClientTraceXML>(element_);
  return trace_.get();
}

char const* ClientXML::GetTagName() const {
  return element_.GetTagName();
}
bool ClientXML::IsTag(char const* pTag) const {
  return element_.IsTag(pTag);
}
int ClientXML::GetNumberChildren() const {
  return element_.GetNumberChildren();
}
bool ClientXML::GetChild(ClientXML* pChild, int index) const {
  ElementXML child;
  if (!pChild || !element_.GetChild(&child, index)) return false;
  pChild->element_ = child;
  pChild->trace_.reset();
  return true;
}
int ClientXML::GetNumberAttributes() const {
  return element_.GetNumberAttributes();
}
char const* ClientXML::GetAttributeName(int index) const {
  return element_.GetAttributeName(index);
}
char const* ClientXML::GetAttributeValue(int index) const {
  return element_.GetAttributeValue(index);
}
char const* ClientXML::GetAttribute(char const* pName) const {
  return element_.GetAttribute(pName);
}
char const* ClientXML::GetCharacterData() const {
  return element_.GetCharacterData();
}
bool ClientXML::IsCharacterDataBinary() const {
  return element_.IsCharacterDataBinary();
}
bool ClientXML::ConvertCharacterDataToBinary() {
  return element_.ConvertCharacterDataToBinary();
}
int ClientXML::GetCharacterDataLength() const {
  return element_.GetCharacterDataLength();
}
char* ClientXML::GenerateXMLString(bool includeChildren, bool insertNewLines) const {
  return element_.GenerateXMLString(includeChildren, insertNewLines);
}
int ClientXML::DetermineXMLStringLength(bool includeChildren, bool insertNewLines) const {
  return element_.DetermineXMLStringLength(includeChildren, insertNewLines);
}
char* ClientXML::AllocateString(int length) {
  return ElementXML::AllocateString(length);
}
void ClientXML::DeleteString(char* pString) {
  ElementXML::DeleteString(pString);
}
char* ClientXML::CopyString(char const* pString) {
  return ElementXML::CopyString(pString);
}
char* ClientXML::CopyBuffer(char const* pBuffer, int length) {
  return ElementXML::CopyBuffer(pBuffer, length);
}

ClientTraceXML::ClientTraceXML() = default;
ClientTraceXML::ClientTraceXML(ElementXML const& element) : ClientXML(element) {}
ClientTraceXML::~ClientTraceXML() = default;

}  // namespace sml
