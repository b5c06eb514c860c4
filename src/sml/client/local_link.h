// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>

#include "sml/client/link.h"

namespace sml {

/// A kernel in this process, called directly. Always gives one; `error` says if it could not listen on the port.
/// `own_thread`: remote clients are served by a thread of its own at any time.
std::unique_ptr<KernelLink> MakeLocalLink(KernelData& kernel, bool own_thread, int port, std::string& error);

}  // namespace sml
