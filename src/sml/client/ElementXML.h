// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "Export.h"

namespace soarbox::wire {
struct Element;
}

namespace soarxml {

/// An element of a message: a tag, attributes, and either text or child elements. Copies share the message, which lives
/// as long as one of them. Changes of one copy are not visible in the others.
class EXPORT ElementXML {
 public:
  ElementXML();
  explicit ElementXML(std::shared_ptr<const soarbox::wire::Element> element);
  ElementXML(ElementXML const&);
  ElementXML& operator=(ElementXML const&);
  ~ElementXML();

  /// Parses a document. Returns NULL if the text is not one; GetLastParseErrorDescription() then describes the error.
  /// The caller deletes the element.
  static ElementXML* ParseXMLFromString(char const* pString);
  /// The error of this thread's last ParseXMLFromString; empty if it succeeded.
  static char const* GetLastParseErrorDescription();

  bool SetTagName(char const* tagName);
  /// Adds an attribute, or replaces its value. The texts are always copied; the last two arguments have no effect.
  bool AddAttribute(char const* attributeName, char const* attributeValue, bool copyName = true, bool copyValue = true);
  /// Replaces the text; the characters are copied.
  bool SetCharacterData(char const* characterData, bool copyData = true);

  char const* GetTagName() const;
  bool IsTag(char const* pTag) const;
  int GetNumberChildren() const;
  /// Makes pChild a view of the index-th child. Returns false if there is none.
  bool GetChild(ElementXML* pChild, int index) const;
  int GetNumberAttributes() const;
  char const* GetAttributeName(int index) const;
  char const* GetAttributeValue(int index) const;
  /// Returns NULL if there is no such attribute.
  char const* GetAttribute(char const* pName) const;
  char const* GetCharacterData() const;
  bool IsCharacterDataBinary() const;
  /// Converts hexadecimal text to the bytes that it encodes. Returns true if the text is binary afterwards.
  bool ConvertCharacterDataToBinary();
  int GetCharacterDataLength() const;
  /// Returns the document as text; free it with DeleteString.
  char* GenerateXMLString(bool includeChildren, bool insertNewLines = false) const;
  int DetermineXMLStringLength(bool includeChildren, bool insertNewLines = false) const;

  static char* AllocateString(int length);
  static void DeleteString(char* pString);
  static char* CopyString(char const* pString);
  static char* CopyBuffer(char const* pBuffer, int length);

  std::shared_ptr<const soarbox::wire::Element> const& element() const { return element_; }

 private:
  /// Returns a copy of the element that only this view refers to, so that it can be changed.
  std::shared_ptr<soarbox::wire::Element> Own() const;

  std::shared_ptr<const soarbox::wire::Element> element_;
};

}  // namespace soarxml
