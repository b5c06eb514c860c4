// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "ElementXML.h"
#include "Export.h"
#include "sml_Names.h"

namespace sml {

/// The structured result of a command line: its named arguments, its result, its error.
class EXPORT ClientAnalyzedXML {
 public:
  ClientAnalyzedXML();
  virtual ~ClientAnalyzedXML();
  ClientAnalyzedXML(ClientAnalyzedXML const&) = delete;
  ClientAnalyzedXML& operator=(ClientAnalyzedXML const&) = delete;

  /// Makes this object represent the given response.
  void Attach(soarxml::ElementXML const& answer);

  /// The parts of the response; NULL if the part does not exist.
  soarxml::ElementXML const* GetCommandTag() const;
  soarxml::ElementXML const* GetResultTag() const;
  soarxml::ElementXML const* GetErrorTag() const;

  bool IsSML() const;
  char const* GetCommandName() const;

  /// The text of the result; the other functions convert it to a number or a truth value.
  char const* GetResultString() const;
  int GetResultInt(int defaultValue) const;
  long long GetResultInt(long long defaultValue) const;
  bool GetResultBool(bool defaultValue) const;
  double GetResultFloat(double defaultValue) const;

  /// The first argument of this name; NULL or the default if there is none or if its value cannot be converted.
  char const* GetArgString(char const* pArgName) const;
  bool GetArgBool(char const* pArgName, bool defaultValue) const;
  int GetArgInt(char const* pArgName, int defaultValue) const;
  long long GetArgInt(char const* pArgName, long long defaultValue) const;
  double GetArgFloat(char const* pArgName, double defaultValue) const;

  /// Returns the response as a document; free it with DeleteString.
  char* GenerateXMLString(bool includeChildren, bool insertNewLines = false) const;
  static void DeleteString(char* pString);

 protected:
  soarxml::ElementXML answer_;

 private:
  soarxml::ElementXML command_;
  soarxml::ElementXML result_;
  soarxml::ElementXML error_;
};

}  // namespace sml
