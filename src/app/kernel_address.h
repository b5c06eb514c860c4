// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "diagnostics/result.h"
#include "sim/soar_host.h"

namespace soarbox::app {

/// The default port of Soar kernels.
inline constexpr int kDefaultPort = 12121;

/// Parses "HOST:PORT"; the port may be missing.
Result<void> ReadKernelAddress(const std::string& text, sim::SoarSettings& settings);

}  // namespace soarbox::app
