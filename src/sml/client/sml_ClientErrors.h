// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "Export.h"

namespace sml {

typedef int ErrorCode;

enum ErrorCodeValue {
  kNoError = 0,
  kInvalidArgument = 1,
  kCallbackNotFound = 2,
  kNoDocType = 3,
  kNoCallback = 4,
  kNoResponseToCall = 5,
  kNoEmbeddedLink = 6,
  kArgumentIsNotSML = 7,
  kFunctionsNotFound = 8,
  kCreationFailed = 9,
  kSMLHasNoCommand = 10,
  kNullArgument = 11,
  kConnectionTimedOut = 12,
  kSocketError = 13,
  kParsingXMLError = 14,
  kConnectionFailed = 15,
  kInvalidResponse = 16,
  kResponseIsNotSML = 17,
  kFailedToGetResponse = 18,
  kSMLErrorMessage = 19,
  kDetailedError = 20,
  kAgentExists = 21,
  kOutputError = 22,
};

/// The last error of a Kernel or an Agent; each object has its own. An error stays until an operation that reports
/// errors succeeds.
class EXPORT ClientErrors {
 public:
  virtual ~ClientErrors();

  /// Returns true if the last operation that can fail failed.
  virtual bool HadError();

  /// A description of the error; "No Error" if there is none. Valid until the next error.
  virtual char const* GetLastErrorDescription();

 protected:
  ClientErrors();
  ClientErrors(ClientErrors const&) = delete;
  ClientErrors& operator=(ClientErrors const&) = delete;

  void SetError(ErrorCode code);
  void SetDetailedError(ErrorCode code, char const* description);
  void ClearError();

 private:
  ErrorCode error_ = kNoError;
  std::string detail_;
};

}  // namespace sml
