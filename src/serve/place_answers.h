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
#include "serve/server_settings.h"

namespace soarbox::serve {

struct WebResponse {
  int status = 200;
  std::string type = "application/json";
  std::string body;
  std::filesystem::path file = {};  ///< If not empty: the body is this file, which is read while it is sent.
  std::vector<std::pair<std::string, std::string>> headers = {};
  std::string framed_by = {};  ///< Sites that may show the response in a frame; empty: none.
};

WebResponse Refusal(int status, const Diagnostic& problem);
WebResponse Refusal(int status, std::string message, std::string hint = {});
WebResponse Good(const nlohmann::ordered_json& json);

/// Data of a place that are not on its disk.
struct PlaceStatus {
  std::string learner, opens;
  bool has_run = false;
};

/// A request about one place. `parts` is the path of the URL: "api", "p", the place, the subject, and the rest.
struct PlaceRequest {
  std::string method;
  std::vector<std::string> parts;
  std::string body;
  PlaceStatus status;
};
/// Answers a request from the disk. Can be called on any thread.
WebResponse AnswerFromPlace(const PlaceRequest& request, Place& place, const Catalog& catalog, const Limits& limits);
/// The cost of a request in points (work.h), before it is executed and after the result is known.
double CostBefore(const PlaceRequest& request);
double CostAfter(const PlaceRequest& request, const WebResponse& response);

/// Joins the parts of a path, beginning with index `first`, with "/".
std::string JoinedFrom(const std::vector<std::string>& parts, std::size_t first);

}  // namespace soarbox::serve
