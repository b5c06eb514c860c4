// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::lti {

struct ClientRequest {
  std::string method = "GET", url;
  std::string type, body;  ///< The content type of the body, if there is one.
  std::vector<std::pair<std::string, std::string>> headers;
};
struct ClientResponse {
  int status = 0;
  std::string body;  ///< At most 1 MB.
};

/// Sends one request over HTTP or HTTPS and blocks until the answer has come, at most about 10 s for each step. Checks
/// certificates against the system's list, or the file that SSL_CERT_FILE names. Follows no redirection. Gives up
/// within 100 ms after `stop` has become true. The error names the server and the step.
Result<ClientResponse> Fetch(const ClientRequest& request, const std::atomic<bool>& stop);

}  // namespace soarbox::lti
