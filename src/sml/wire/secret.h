// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "diagnostics/result.h"
#include "sml/wire/message.h"

namespace soarbox::wire {

/// The secret that a kernel may require of its clients. A client presents it with its first call, which is not part of
/// Soar 9.6; before that, the kernel executes nothing for it. Kernels without a secret behave as usual.
inline constexpr const char* kSecretCall = "soarbox_secret";
inline constexpr const char* kSecretParameter = "secret";

/// The environment variables for kernels and clients: the secret itself, or a file whose first line contains it.
inline constexpr const char* kSecretVariable = "SOARBOX_KERNEL_SECRET";
inline constexpr const char* kSecretFileVariable = "SOARBOX_KERNEL_SECRET_FILE";

/// The secret from the environment; empty if there is none. Returns an error if the file cannot be read or is empty.
Result<std::string> SecretOfEnvironment();

/// The call that presents a secret.
Message SecretCall(const std::string& secret);
/// The secret that a message presents; null if it is not such a call.
const std::string* ShownSecret(const Message& message);

/// Compares in constant time: the time does not reveal where the texts differ.
bool IsSameSecret(std::string_view given, std::string_view wanted);

}  // namespace soarbox::wire
