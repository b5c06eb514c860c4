// SPDX-License-Identifier: BSD-2-Clause
// The engine and the user's place for a page without a server. JavaScript calls these functions in a worker
// (web/src/local); none of them blocks. The caller frees returned texts.
#include <emscripten.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/data_folders.h"
#include "app/engine/engine_window.h"
#include "app/learn_command.h"
#include "app/shipped_catalog.h"
#include "diagnostics/json_text.h"
#include "diagnostics/problem.h"
#include "serve/place.h"
#include "serve/place_answers.h"

namespace {

using namespace soarbox;
namespace fs = std::filesystem;

/// The place of this worker; the browser stores its files.
constexpr char kPlace[] = "/place", kPlaceId[] = "local";

serve::Place& ThePlace() {
  static serve::Place place(kPlaceId, kPlace, serve::PlaceLimits());
  return place;
}

/// Null if the program's own files do not exist.
const app::ShippedCatalog* Catalog() {
  static const std::unique_ptr<const app::ShippedCatalog> catalog = [] {
    const Result<sim::DataFolders> data = app::FindDataFolders();
    return data ? std::make_unique<const app::ShippedCatalog>(*data) : nullptr;
  }();
  return catalog.get();
}

std::unique_ptr<app::SteppedEngine>& TheEngine() {
  static std::unique_ptr<app::SteppedEngine> engine;
  return engine;
}

/// The options for "lesson:NAME", "scenario:NAME" or "recording:NAME".
Result<app::EngineOptions> OptionsFor(const std::string& what) {
  const Diagnostic unknown =
      NewProblem("there is nothing called '" + what + "' to open", "the first page lists what there is");
  const std::size_t colon = what.find(':');
  const std::string kind = what.substr(0, colon), name = colon == std::string::npos ? "" : what.substr(colon + 1);
  if (!app::IsPlainName(name) || Catalog() == nullptr) return unknown;
  const auto is_it = [&](const auto& each) { return each.name == name; };
  app::EngineOptions options;
  options.home = ThePlace().home();
  std::error_code error;
  fs::create_directories(options.home, error);
  if (kind == "recording") {
    const Result<fs::path> file = ThePlace().FindRecording(name);
    if (!file) return file.error();
    options.recording = *file;
    return options;
  }
  if (kind == "lesson" && std::ranges::any_of(Catalog()->Lessons(), is_it)) {
    options.lesson = name;
    return options;
  }
  if (kind == "scenario" &&
      (std::ranges::any_of(Catalog()->Scenarios(), is_it) || fs::is_directory(options.home / "worlds" / name, error))) {
    options.world = name;
    return options;
  }
  return unknown;
}

char* NewText(const std::string& text) {
  char* const copy = static_cast<char*>(std::malloc(text.size() + 1));
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

std::vector<std::string> PartsOf(const std::string& path) {
  std::vector<std::string> parts;
  for (std::size_t at = path.starts_with('/') ? 1 : 0; at < path.size();) {
    const std::size_t end = std::min(path.find('/', at), path.size());
    parts.push_back(path.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

}  // namespace

extern "C" {

/// Ends the current run and begins another. Returns an error as JSON, with `error` and `hint`, or null. If the run
/// cannot begin because of an error in its files, the page was sent the error as a frame, and `error` is empty.
EMSCRIPTEN_KEEPALIVE char* soarbox_open(const char* what) {
  const Result<app::EngineOptions> options = OptionsFor(what);
  if (!options)
    return NewText(
        JsonText(nlohmann::ordered_json{{"error", options.error().message}, {"hint", options.error().hint}}));
  TheEngine().reset();
  TheEngine() = app::SteppedEngine::Make(*options);
  return TheEngine() == nullptr ? NewText(R"({"error":"","hint":""})") : nullptr;
}

/// Executes one iteration of the engine's loop. Returns the longest time in ms until the next one, or -1 if the run has
/// ended.
EMSCRIPTEN_KEEPALIVE int soarbox_step() {
  if (TheEngine() == nullptr) return -1;
  const std::optional<int> wait_ms = TheEngine()->Step();
  if (!wait_ms) TheEngine().reset();
  return wait_ms.value_or(-1);
}

/// Grades a learner's rules in this module, which has no run, like `soarbox learn check LESSON --progress`. `from` is
/// the folder of the lessons. Returns an ExitCode.
EMSCRIPTEN_KEEPALIVE int soarbox_grade(const char* lesson, const char* from) {
  app::LearnOptions options;
  options.words = {"check", lesson};
  options.from = from;
  options.progress = true;
  const int code = app::Learn(options);
  std::cout.flush();
  return code;
}

/// Answers a request about the place as the server does (docs/serve_protocol.md): `path` without "/api/p/ID" before it.
/// The answer is JSON with `status`, `type` and `file`: the name of a file with the body, for example a zip archive.
EMSCRIPTEN_KEEPALIVE char* soarbox_answer(const char* method, const char* path, const char* body, int length) {
  serve::PlaceRequest request;
  request.method = method;
  request.parts = {"api", "p", kPlaceId};
  for (std::string& part : PartsOf(path)) request.parts.push_back(std::move(part));
  request.body.assign(body, static_cast<std::size_t>(length));
  request.status.has_run = TheEngine() != nullptr;
  if (Catalog() == nullptr) return NewText(R"({"status":500,"type":"text/plain","file":""})");
  const serve::WebResponse answer = serve::AnswerFromPlace(request, ThePlace(), *Catalog(), serve::Limits());
  fs::path file = answer.file;
  if (file.empty()) {
    file = "/answer";
    std::ofstream(file, std::ios::binary) << answer.body;
  }
  return NewText(
      JsonText(nlohmann::ordered_json{{"status", answer.status}, {"type", answer.type}, {"file", file.string()}}));
}

}  // extern "C"
