// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "diagnostics/result.h"
#include "sml/wire/message.h"

namespace soarbox::wire {

/// The secret that a kernel may require of its clients. A client shows it with its first call, which Soar 9.6 does not
/// have; until then the kernel carries out nothing for it. Without a secret, nothing changes.
inline constexpr const char* kSecretCall = "soarbox_secret";
inline constexpr const char* kSecretParameter = "secret";

/// The environment variables that name it, for kernels and clients: the secret, or a file with it in its first line.
inline constexpr const char* kSecretVariable = "SOARBOX_KERNEL_SECRET";
inline constexpr const char* kSecretFileVariable = "SOARBOX_KERNEL_SECRET_FILE";

/// The secret that the environment names; empty if it names none. An error if the file cannot be read or is empty.
Result<std::string> SecretOfEnvironment();

/// The call that shows a secret.
Message SecretCall(const std::string& secret);
/// The secret that a message shows; null if it is no such call.
const std::string* ShownSecret(const Message& message);

/// Compares in a time that does not depend on where the texts differ.
bool IsSameSecret(std::string_view given, std::string_view wanted);

}  // namespace soarbox::wire
