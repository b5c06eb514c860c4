// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/sml_ClientErrors.h"

namespace sml {

namespace {

char const* Describe(ErrorCode code) {
  switch (code) {
    case kNoError:
      return "No Error";
    case kInvalidArgument:
      return "An argument is not valid";
    case kCallbackNotFound:
      return "There is no handler with this id";
    case kNoDocType:
      return "A message has no document type";
    case kNoCallback:
      return "Nobody takes this call";
    case kNoResponseToCall:
      return "A call was not answered";
    case kNoEmbeddedLink:
      return "There is no kernel in this process";
    case kArgumentIsNotSML:
      return "A message is no SML document";
    case kFunctionsNotFound:
      return "A library does not export the functions that it needs";
    case kCreationFailed:
      return "The object could not be created";
    case kSMLHasNoCommand:
      return "A message has no command";
    case kNullArgument:
      return "An argument is NULL";
    case kConnectionTimedOut:
      return "The kernel did not answer in time";
    case kSocketError:
      return "The socket failed";
    case kParsingXMLError:
      return "A message is not well-formed";
    case kConnectionFailed:
      return "There is no kernel to connect to";
    case kInvalidResponse:
      return "The kernel's answer is not valid";
    case kResponseIsNotSML:
      return "The kernel's answer is no SML document";
    case kFailedToGetResponse:
      return "The kernel did not answer";
    case kSMLErrorMessage:
      return "The kernel answered with an error";
    case kDetailedError:
      return "The operation failed";
    case kAgentExists:
      return "Trying to create an agent that already exists in the kernel.";
    case kOutputError:
      return "A message about output was not complete";
    default:
      return "Unknown error";
  }
}

}  // namespace

ClientErrors::ClientErrors() = default;
ClientErrors::~ClientErrors() = default;

bool ClientErrors::HadError() {
  return error_ != kNoError;
}

char const* ClientErrors::GetLastErrorDescription() {
  return detail_.empty() ? Describe(error_) : detail_.c_str();
}

void ClientErrors::SetError(ErrorCode code) {
  error_ = code;
  detail_.clear();
}

void ClientErrors::SetDetailedError(ErrorCode code, char const* description) {
  error_ = code;
  detail_ = description ? description : "";
}

void ClientErrors::ClearError() {
  error_ = kNoError;
  detail_.clear();
}

}  // namespace sml
