// SPDX-License-Identifier: BSD-2-Clause
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

#include "sml/client/ElementXML.h"
#include "sml/wire/element.h"
#include "sml/wire/xml_reader.h"
#include "sml/wire/xml_writer.h"

namespace soarxml {

using soarbox::wire::Element;

namespace {

constexpr char const* kEncoding = "bin_encoding";

int HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

ElementXML::ElementXML() = default;
ElementXML::ElementXML(std::shared_ptr<const Element> element) : element_(std::move(element)) {}
ElementXML::ElementXML(ElementXML const&) = default;
ElementXML& ElementXML::operator=(ElementXML const&) = default;
ElementXML::~ElementXML() = default;

// Reading and changing ------------------------------------------------------------------------------------------------

namespace {

std::string& LastParseError() {
  thread_local std::string error;
  return error;
}

}  // namespace

ElementXML* ElementXML::ParseXMLFromString(char const* pString) {
  auto read = soarbox::wire::ReadXml(pString ? pString : "");
  LastParseError() = read ? std::string() : read.error().message;
  if (!read) return nullptr;
  return new ElementXML(std::make_shared<const Element>(*std::move(read)));
}

char const* ElementXML::GetLastParseErrorDescription() {
  return LastParseError().c_str();
}

std::shared_ptr<Element> ElementXML::Own() const {
  return element_ ? std::make_shared<Element>(*element_) : std::make_shared<Element>();
}

bool ElementXML::SetTagName(char const* tagName) {
  if (!tagName || *tagName == '\0') return false;
  const std::shared_ptr<Element> own = Own();
  own->tag = tagName;
  element_ = own;
  return true;
}

bool ElementXML::AddAttribute(char const* attributeName, char const* attributeValue, bool, bool) {
  if (!attributeName || *attributeName == '\0' || !attributeValue) return false;
  const std::shared_ptr<Element> own = Own();
  std::string value = attributeValue;
  for (auto& [name, old] : own->attributes) {
    if (name != attributeName) continue;
    old = std::move(value);
    element_ = own;
    return true;
  }
  own->Set(attributeName, std::move(value));
  element_ = own;
  return true;
}

bool ElementXML::SetCharacterData(char const* characterData, bool) {
  if (!characterData) return false;
  const std::shared_ptr<Element> own = Own();
  own->text = characterData;
  element_ = own;
  return true;
}

// Looking -------------------------------------------------------------------------------------------------------------

char const* ElementXML::GetTagName() const {
  return element_ ? element_->tag.c_str() : "";
}

bool ElementXML::IsTag(char const* pTag) const {
  return element_ && pTag && element_->tag == pTag;
}

int ElementXML::GetNumberChildren() const {
  return element_ ? static_cast<int>(element_->children.size()) : 0;
}

bool ElementXML::GetChild(ElementXML* pChild, int index) const {
  if (!pChild || index < 0 || index >= GetNumberChildren()) return false;
  // The child keeps the entire message alive.
  *pChild = ElementXML(std::shared_ptr<const Element>(element_, &element_->children[static_cast<std::size_t>(index)]));
  return true;
}

int ElementXML::GetNumberAttributes() const {
  return element_ ? static_cast<int>(element_->attributes.size()) : 0;
}

char const* ElementXML::GetAttributeName(int index) const {
  if (index < 0 || index >= GetNumberAttributes()) return nullptr;
  return element_->attributes[static_cast<std::size_t>(index)].first.c_str();
}

char const* ElementXML::GetAttributeValue(int index) const {
  if (index < 0 || index >= GetNumberAttributes()) return nullptr;
  return element_->attributes[static_cast<std::size_t>(index)].second.c_str();
}

char const* ElementXML::GetAttribute(char const* pName) const {
  if (!element_ || !pName) return nullptr;
  const std::string* value = element_->Attribute(pName);
  return value ? value->c_str() : nullptr;
}

char const* ElementXML::GetCharacterData() const {
  return element_ ? element_->text.c_str() : "";
}

bool ElementXML::IsCharacterDataBinary() const {
  char const* encoding = GetAttribute(kEncoding);
  return encoding && std::strcmp(encoding, "binary") == 0;
}

bool ElementXML::ConvertCharacterDataToBinary() {
  if (IsCharacterDataBinary()) return true;
  char const* encoding = GetAttribute(kEncoding);
  if (!encoding || std::strcmp(encoding, "hex") != 0 || element_->text.size() % 2 != 0) return false;
  std::string bytes;
  for (std::size_t i = 0; i < element_->text.size(); i += 2) {
    const int high = HexDigit(element_->text[i]);
    const int low = HexDigit(element_->text[i + 1]);
    if (high < 0 || low < 0) return false;
    bytes += static_cast<char>(high * 16 + low);
  }
  auto converted = std::make_shared<Element>(*element_);
  converted->text = std::move(bytes);
  for (auto& [name, value] : converted->attributes) {
    if (name == kEncoding) value = "binary";
  }
  element_ = std::move(converted);
  return true;
}

int ElementXML::GetCharacterDataLength() const {
  return element_ ? static_cast<int>(element_->text.size()) : 0;
}

char* ElementXML::GenerateXMLString(bool includeChildren, bool insertNewLines) const {
  if (!element_) return CopyString("");
  return CopyString(soarbox::wire::ToXml(*element_, {includeChildren, insertNewLines}).c_str());
}

int ElementXML::DetermineXMLStringLength(bool includeChildren, bool insertNewLines) const {
  if (!element_) return 0;
  return static_cast<int>(soarbox::wire::ToXml(*element_, {includeChildren, insertNewLines}).size());
}

char* ElementXML::AllocateString(int length) {
  return static_cast<char*>(std::calloc(static_cast<std::size_t>(length < 0 ? 0 : length) + 1, 1));
}

void ElementXML::DeleteString(char* pString) {
  std::free(pString);
}

char* ElementXML::CopyString(char const* pString) {
  if (!pString) return nullptr;
  return CopyBuffer(pString, static_cast<int>(std::strlen(pString)));
}

char* ElementXML::CopyBuffer(char const* pBuffer, int length) {
  char* copy = AllocateString(length);
  if (copy && pBuffer && length > 0) std::memcpy(copy, pBuffer, static_cast<std::size_t>(length));
  return copy;
}

}  // namespace soarxml
