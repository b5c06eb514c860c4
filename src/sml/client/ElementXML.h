// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "Export.h"

namespace soarbox::wire {
struct Element;
}

namespace soarxml {

/// A read-only view of an element of a message: a tag, attributes, and either text or child elements. Copies share
/// the message, which lives as long as one of them.
class EXPORT ElementXML {
 public:
  ElementXML();
  explicit ElementXML(std::shared_ptr<const soarbox::wire::Element> element);
  ElementXML(ElementXML const&);
  ElementXML& operator=(ElementXML const&);
  ~ElementXML();

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
  std::shared_ptr<const soarbox::wire::Element> element_;
};

}  // namespace soarxml
