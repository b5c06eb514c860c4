// SPDX-License-Identifier: BSD-2-Clause
#include <cstddef>
#include <iterator>

#include "sml/client/sml_ClientErrors.h"

namespace sml {

namespace {

// Indexed by ErrorCodeValue.
constexpr char const* kDescriptions[] = {"No Error",
                                         "An argument is not valid",
                                         "There is no handler with this id",
                                         "A message has no document type",
                                         "There is no handler for this call",
                                         "There was no answer to a call",
                                         "There is no kernel in this process",
                                         "A message is not an SML document",
                                         "A library does not export the functions that it needs",
                                         "The object could not be created",
                                         "A message has no command",
                                         "An argument is NULL",
                                         "The kernel did not answer in time",
                                         "The socket failed",
                                         "A message is not well-formed",
                                         "There is no kernel to connect to",
                                         "The kernel's answer is not valid",
                                         "The kernel's answer is not an SML document",
                                         "The kernel did not answer",
                                         "The kernel answered with an error",
                                         "The operation failed",
                                         "Trying to create an agent that already exists in the kernel.",
                                         "A message about output was not complete"};

char const* Describe(ErrorCode code) {
  return code >= 0 && static_cast<std::size_t>(code) < std::size(kDescriptions) ? kDescriptions[code] : "Unknown error";
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
