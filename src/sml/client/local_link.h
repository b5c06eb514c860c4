// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>

#include "sml/client/link.h"

namespace sml {

/// Creates a kernel in this process, which is called directly. Always returns a link; `error` is set if the kernel
/// could not listen on the port. With `own_thread`, a separate thread serves remote clients at any time.
std::unique_ptr<KernelLink> MakeLocalLink(KernelData& kernel, bool own_thread, int port, std::string& error);

}  // namespace sml
