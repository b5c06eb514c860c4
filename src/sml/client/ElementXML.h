// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "Export.h"

namespace soarbox::wire {
struct Element;
}

namespace soarxml {

/// An element of a message: a tag, attributes, and either text or child elements. Copies share the message, which lives
/// as long as one of them; what one of them changes, the others do not see.
class EXPORT ElementXML {
 public:
  ElementXML();
  explicit ElementXML(std::shared_ptr<const soarbox::wire::Element> element);
  ElementXML(ElementXML const&);
  ElementXML& operator=(ElementXML const&);
  ~ElementXML();

  /// Reads a document; NULL if it is none, and GetLastParseErrorDescription() says why. The caller deletes the element.
  static ElementXML* ParseXMLFromString(char const* pString);
  /// Of this thread's last ParseXMLFromString; empty if it succeeded.
  static char const* GetLastParseErrorDescription();

  bool SetTagName(char const* tagName);
  /// Adds an attribute, or replaces the value of one. The text is copied, whatever the last two arguments say.
  bool AddAttribute(char const* attributeName, char const* attributeValue, bool copyName = true, bool copyValue = true);
  /// Replaces the text; the characters are copied.
  bool SetCharacterData(char const* characterData, bool copyData = true);

  char const* GetTagName() const;
  bool IsTag(char const* pTag) const;
  int GetNumberChildren() const;
  /// Makes pChild a view of the index-th child; false if there is none.
  bool GetChild(ElementXML* pChild, int index) const;
  int GetNumberAttributes() const;
  char const* GetAttributeName(int index) const;
  char const* GetAttributeValue(int index) const;
  /// NULL if there is no such attribute.
  char const* GetAttribute(char const* pName) const;
  char const* GetCharacterData() const;
  bool IsCharacterDataBinary() const;
  /// Replaces hexadecimal text by the bytes that it stands for; true if the text is binary afterwards.
  bool ConvertCharacterDataToBinary();
  int GetCharacterDataLength() const;
  /// The document as text; give it back with DeleteString.
  char* GenerateXMLString(bool includeChildren, bool insertNewLines = false) const;
  int DetermineXMLStringLength(bool includeChildren, bool insertNewLines = false) const;

  static char* AllocateString(int length);
  static void DeleteString(char* pString);
  static char* CopyString(char const* pString);
  static char* CopyBuffer(char const* pBuffer, int length);

  std::shared_ptr<const soarbox::wire::Element> const& element() const { return element_; }

 private:
  /// A copy of the element that only this view has, to be changed.
  std::shared_ptr<soarbox::wire::Element> Own() const;

  std::shared_ptr<const soarbox::wire::Element> element_;
};

}  // namespace soarxml
