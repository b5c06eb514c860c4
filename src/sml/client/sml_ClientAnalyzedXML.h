// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "ElementXML.h"
#include "Export.h"
#include "sml_Names.h"

namespace sml {

/// The structured answer to a command line: its arguments by name, its result, its error.
class EXPORT ClientAnalyzedXML {
 public:
  ClientAnalyzedXML();
  virtual ~ClientAnalyzedXML();
  ClientAnalyzedXML(ClientAnalyzedXML const&) = delete;
  ClientAnalyzedXML& operator=(ClientAnalyzedXML const&) = delete;

  /// Makes this object show the answer.
  void Attach(soarxml::ElementXML const& answer);

  /// The parts of the answer; NULL if it has no such part.
  soarxml::ElementXML const* GetCommandTag() const;
  soarxml::ElementXML const* GetResultTag() const;
  soarxml::ElementXML const* GetErrorTag() const;

  bool IsSML() const;
  char const* GetCommandName() const;

  /// The text of the result; the other forms read it as a number or a truth value.
  char const* GetResultString() const;
  int GetResultInt(int defaultValue) const;
  long long GetResultInt(long long defaultValue) const;
  bool GetResultBool(bool defaultValue) const;
  double GetResultFloat(double defaultValue) const;

  /// The first argument of that name; NULL or the default if there is none or it does not fit.
  char const* GetArgString(char const* pArgName) const;
  bool GetArgBool(char const* pArgName, bool defaultValue) const;
  int GetArgInt(char const* pArgName, int defaultValue) const;
  long long GetArgInt(char const* pArgName, long long defaultValue) const;
  double GetArgFloat(char const* pArgName, double defaultValue) const;

  /// The answer as a document; give it back with DeleteString.
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
