// SPDX-License-Identifier: BSD-2-Clause
#include "app/kernel_address.h"

#include <charconv>
#include <system_error>

#include "diagnostics/problem.h"

namespace soarbox::app {

Result<void> ReadKernelAddress(const std::string& text, sim::SoarSettings& settings) {
  const std::size_t colon = text.rfind(':');
  settings.remote_host = text.substr(0, colon);
  settings.remote_port = kDefaultPort;
  if (colon != std::string::npos) {
    const char* end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data() + colon + 1, end, settings.remote_port);
    if (error != std::errc{} || at != end || settings.remote_port < 1 || settings.remote_port > 65535) {
      return NewProblem("'" + text + "' is not an address of a kernel",
                        "write HOST:PORT, for example --kernel 127.0.0.1:12121");
    }
  }
  return {};
}

}  // namespace soarbox::app
