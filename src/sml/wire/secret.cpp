// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/secret.h"

#include <cstdlib>
#include <fstream>

#include "diagnostics/problem.h"

namespace soarbox::wire {

Result<std::string> SecretOfEnvironment() {
  const char* const secret = std::getenv(kSecretVariable);
  if (secret != nullptr && *secret != '\0') {
    return std::string(secret);
  }
  const char* const path = std::getenv(kSecretFileVariable);
  if (path == nullptr || *path == '\0') {
    return std::string();
  }
  std::ifstream file(path);
  if (!file) {
    return ProblemIn(path, "this file with the kernel's secret cannot be read");
  }
  std::string line;
  std::getline(file, line);
  if (!line.empty() && line.back() == '\r') {
    line.pop_back();
  }
  if (line.empty()) {
    return ProblemIn(path, "the first line of this file is the kernel's secret, and it is empty");
  }
  return line;
}

Message SecretCall(const std::string& secret) {
  Message call = MakeCall(kSecretCall);
  call.root.children.front().AddArg(kSecretParameter, secret);
  return call;
}

const std::string* ShownSecret(const Message& message) {
  const Element* const command = message.type == DocType::kCall ? message.Command() : nullptr;
  const std::string* const name = command != nullptr ? command->Attribute("name") : nullptr;
  return name != nullptr && *name == kSecretCall ? command->Arg(kSecretParameter) : nullptr;
}

bool IsSameSecret(std::string_view given, std::string_view wanted) {
  std::size_t difference = given.size() ^ wanted.size();
  for (std::size_t n = 0; n < given.size(); ++n) {
    const char other = wanted.empty() ? '\0' : wanted[n % wanted.size()];
    difference |= static_cast<unsigned char>(given[n]) ^ static_cast<unsigned char>(other);
  }
  return difference == 0;
}

}  // namespace soarbox::wire
