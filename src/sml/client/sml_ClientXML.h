// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "ElementXML.h"
#include "Export.h"

namespace sml {

class ClientTraceXML;

/// A part of structured output. The one that is passed to an event handler is valid until the handler returns; copy it
/// to keep it.
class EXPORT ClientXML {
 public:
  ClientXML();
  explicit ClientXML(ClientXML* pXML);
  explicit ClientXML(soarxml::ElementXML const& element);
  virtual ~ClientXML();

  ClientXML(ClientXML const&) = delete;
  ClientXML& operator=(ClientXML const&) = delete;

  /// Returns this part as a part of a trace; owned by this object.
  virtual ClientTraceXML* ConvertToTraceXML();

  char const* GetTagName() const;
  bool IsTag(char const* pTag) const;
  int GetNumberChildren() const;
  /// Makes pChild the index-th child. Returns false if there is none.
  bool GetChild(ClientXML* pChild, int index) const;
  int GetNumberAttributes() const;
  char const* GetAttributeName(int index) const;
  char const* GetAttributeValue(int index) const;
  /// Returns NULL if there is no such attribute.
  char const* GetAttribute(char const* pName) const;
  char const* GetCharacterData() const;
  bool IsCharacterDataBinary() const;
  bool ConvertCharacterDataToBinary();
  int GetCharacterDataLength() const;
  /// Returns this part as a document; free it with DeleteString.
  char* GenerateXMLString(bool includeChildren, bool insertNewLines = false) const;
  int DetermineXMLStringLength(bool includeChildren, bool insertNewLines = false) const;

  static char* AllocateString(int length);
  static void DeleteString(char* pString);
  static char* CopyString(char const* pString);
  static char* CopyBuffer(char const* pBuffer, int length);

 protected:
  soarxml::ElementXML element_;

 private:
  std::unique_ptr<ClientTraceXML> trace_;  ///< Created by ConvertToTraceXML.
};

}  // namespace sml
