// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary text to the parser of requests. A parsed request must be written and parsed again with the same
// contents; otherwise there must be an error.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "workbench/requests_json.h"

using namespace soarbox;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const workbench::Json json = workbench::Json::parse(data, data + size, nullptr, false);
  const Result<workbench::Request> read = workbench::ReadRequest(json);
  if (!read) {
    if (read.error().message.empty()) std::abort();
    return 0;
  }
  const workbench::Json written = workbench::ToJson(*read);
  const Result<workbench::Request> again = workbench::ReadRequest(written);
  if (!again || again->index() != read->index() || workbench::ToJson(*again) != written) std::abort();
  return 0;
}
