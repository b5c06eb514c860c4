// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>

#include "sml/client/link.h"

namespace sml {

/// Connects to a remote kernel. Returns null, and sets `error`, if there is none at that address and port.
std::unique_ptr<KernelLink> MakeRemoteLink(KernelData& kernel, const std::string& address, int port,
                                           std::string& error);

}  // namespace sml
