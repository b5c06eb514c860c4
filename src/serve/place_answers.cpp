// SPDX-License-Identifier: BSD-2-Clause
#include "serve/place_answers.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "diagnostics/json_text.h"
#include "diagnostics/problem.h"

namespace soarbox::serve {

using Json = nlohmann::ordered_json;

WebResponse Refusal(int status, const Diagnostic& problem) {
  WebResponse response;
  response.status = status;
  Json json{{"error", problem.message}, {"hint", problem.hint}};
  if (!problem.file.empty()) json["file"] = problem.file;
  response.body = JsonText(json);
  return response;
}

WebResponse Refusal(int status, std::string message, std::string hint) {
  return Refusal(status, NewProblem(std::move(message), std::move(hint)));
}

WebResponse Good(const Json& json) {
  WebResponse response;
  response.body = JsonText(json);
  return response;
}

std::string JoinedFrom(const std::vector<std::string>& parts, std::size_t first) {
  std::string path;
  for (std::size_t i = first; i < parts.size(); ++i) path += (i == first ? "" : "/") + parts[i];
  return path;
}

namespace {

WebResponse About(const Place& place, const PlaceStatus& status, const Catalog& catalog, const Limits& limits) {
  Json lessons = Json::array(), scenarios = Json::array(), files = Json::array(), recordings = Json::array();
  for (const Lesson& lesson : catalog.Lessons())
    lessons.push_back({{"name", lesson.name},
                       {"title", lesson.title},
                       {"course", lesson.course},
                       {"is_passed", catalog.ProgressOf(place.state(), lesson.name).is_passed}});
  for (const Catalog::Scenario& scenario : catalog.Scenarios())
    scenarios.push_back({{"name", scenario.name}, {"about", scenario.about}});
  for (const PlaceFile& file : place.Files()) files.push_back({{"path", file.path}, {"bytes", file.bytes}});
  for (const PlaceRecording& recording : place.Recordings()) {
    const Result<std::filesystem::path> file = place.FindRecording(recording.name);
    const Catalog::Recording about = file ? catalog.Describe(*file) : Catalog::Recording();
    recordings.push_back({{"name", recording.name},
                          {"bytes", recording.bytes},
                          {"when", recording.when_s},
                          {"world", about.world},
                          {"seconds", about.seconds}});
  }
  return Good({{"place", place.id()},
               {"learner", status.learner},
               {"opens", status.opens},
               {"lessons", std::move(lessons)},
               {"scenarios", std::move(scenarios)},
               {"files", std::move(files)},
               {"recordings", std::move(recordings)},
               {"kept_days", limits.kept_days},
               {"has_run", status.has_run}});
}

}  // namespace

WebResponse AnswerFromPlace(const PlaceRequest& request, Place& place, const Catalog& catalog, const Limits& limits) {
  const std::vector<std::string>& parts = request.parts;
  const std::string& method = request.method;
  const std::string what = parts.size() > 3 ? parts[3] : "";
  const std::string path = JoinedFrom(parts, 4);
  const auto done = [](const Result<void>& result) {
    return result ? Good({{"done", true}}) : Refusal(400, result.error());
  };
  if (what.empty() && method == "GET") return About(place, request.status, catalog, limits);
  if (what == "files" && method == "GET") {
    const Result<std::string> text = place.Read(path);
    if (!text) return Refusal(404, text.error());
    WebResponse response;
    response.type = "text/plain; charset=utf-8";
    response.body = *text;
    return response;
  }
  if (what == "files" && method == "PUT") return done(place.Write(path, request.body));
  if (what == "files" && method == "DELETE") return done(place.Remove(path));
  if (what == "zip" && method == "GET") {
    Result<std::string> zip = place.Zip();
    if (!zip) return Refusal(500, zip.error());
    WebResponse response;
    response.type = "application/zip";
    response.headers.emplace_back("Content-Disposition", "attachment; filename=\"soarbox.zip\"");
    response.body = *std::move(zip);
    return response;
  }
  if (what == "zip" && method == "POST") {
    const Result<std::size_t> count = place.Unzip(request.body);
    return count ? Good({{"files", *count}}) : Refusal(400, count.error());
  }
  if (what == "recordings" && method == "GET") {
    const Result<std::filesystem::path> file = place.FindRecording(path);
    if (!file) return Refusal(404, file.error());
    WebResponse response;
    response.type = "application/octet-stream";
    response.headers.emplace_back("Content-Disposition", "attachment; filename=\"run.soarrec\"");
    response.file = *file;
    return response;
  }
  return Refusal(404, "a place has nothing of this name");
}

double CostBefore(const PlaceRequest& request) {
  const std::string what = request.parts.size() > 3 ? request.parts[3] : "";
  constexpr double kRead = 2, kWrite = 8, kArchive = 6, kBytesPerPoint = 32'768;
  const double least = what == "zip" ? kArchive : request.method == "GET" ? kRead : kWrite;
  return least + static_cast<double>(request.body.size()) / kBytesPerPoint;
}

double CostAfter(const PlaceRequest& request, const WebResponse& response) {
  const bool is_archive = request.parts.size() > 3 && request.parts[3] == "zip";
  // Compressing takes longer than reading; uploaded data are written file by file, with a cost for each name.
  constexpr double kBytesPerPoint = 65'536, kPackedPerPoint = 4'096, kCamePerPoint = 1'024, kMostWritten = 100;
  if (is_archive && request.method == "POST")
    return response.status == 200 ? std::min(static_cast<double>(request.body.size()) / kCamePerPoint, kMostWritten)
                                  : 0;
  return static_cast<double>(response.body.size()) / (is_archive ? kPackedPerPoint : kBytesPerPoint);
}

}  // namespace soarbox::serve
