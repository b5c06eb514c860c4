// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "serve/place.h"
#include "serve/settings.h"

namespace soarbox::serve {

struct WebResponse {
  int status = 200;
  std::string type = "application/json";
  std::string body;
  std::filesystem::path file = {};  ///< If not empty: the body is this file, which is read while it is sent.
  std::vector<std::pair<std::string, std::string>> headers = {};
  std::string framed_by = {};  ///< Sites whose pages may show it in a frame; empty: none.
};

WebResponse Refusal(int status, const Diagnostic& problem);
WebResponse Refusal(int status, std::string message, std::string hint = {});
WebResponse Good(const nlohmann::ordered_json& json);

/// What is known of a place without its disk.
struct PlaceStatus {
  std::string learner, opens;
  bool has_run = false;
};

/// A request about what one place holds: `parts` is the path of the address, "api", "p", the place, what, and the rest.
struct PlaceRequest {
  std::string method;
  std::vector<std::string> parts;
  std::string body;
  PlaceStatus status;
};
/// Answers it from the disk, on any thread.
WebResponse AnswerFromPlace(const PlaceRequest& request, Place& place, const Catalog& catalog, const Limits& limits);
/// How many points a request costs, before and after it is known what it did (work.h).
double CostBefore(const PlaceRequest& request);
double CostAfter(const PlaceRequest& request, const WebResponse& response);

/// The parts of a path from the first one on, with "/" between them.
std::string JoinedFrom(const std::vector<std::string>& parts, std::size_t first);

}  // namespace soarbox::serve
