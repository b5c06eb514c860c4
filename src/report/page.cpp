// SPDX-License-Identifier: BSD-2-Clause
#include "report/page.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "diagnostics/problem.h"
#include "record/reader.h"

namespace soarbox::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMostRuns = 50;
/// Maximum size of the page of one recording, and for each run of a page of several, which has no 3D view.
constexpr std::size_t kMostBytes = 10'000'000, kMostBytesOfEach = 9'000'000;
/// Minimum size for the data of a run, regardless of the 3D view, which uses at most about 6 MB.
constexpr std::size_t kLeastBytes = 2'000'000;
constexpr std::size_t kPlainBytes = 400'000;  ///< For readers without scripts; rarely more is needed.

/// The part of the page for readers without scripts: title, checks and key moments.
std::string PlainBody(const Json& data) {
  std::string body =
      "<h1>" + EscapeHtml(data.value("title", "")) + "</h1>\n<p>" + EscapeHtml(data.value("verdict", "")) + "</p>\n";
  const auto list = [&](const char* key, const char* head) {
    const Json rows = data.value(key, Json::array());
    if (rows.empty()) return;
    body += std::string("<h2>") + head + "</h2>\n<ul>\n";
    for (const Json& row : rows) {
      body += "<li>" + EscapeHtml(row.value("time_text", "")) + " " + EscapeHtml(row.value("mark", "")) + " " +
              EscapeHtml(row.value("text", row.value("name", "")));
      for (const Json& reason : row.value("reasons", Json::array()))
        body += "<br>" + EscapeHtml(reason.get<std::string>());
      body += "</li>\n";
    }
    body += "</ul>\n";
  };
  list("checks", "Checks");
  list("moments", "Key moments");
  list("summary", "Results");
  return body;
}

std::uint64_t HashOf(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

}  // namespace

std::string ForScriptElement(std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '<') {
      safe += "\\u003c";
    } else if (c == '>') {
      safe += "\\u003e";
    } else if (c == '&') {
      safe += "\\u0026";
    } else if (json.substr(i, 3) == "\xe2\x80\xa8" || json.substr(i, 3) == "\xe2\x80\xa9") {
      safe += json[i + 2] == '\xa8' ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string FillIn(std::string_view page, std::initializer_list<std::pair<std::string_view, std::string_view>> texts) {
  std::string filled;
  while (!page.empty()) {
    const std::size_t close = page.find("}}", page.find("{{"));
    if (close == std::string_view::npos) break;
    const std::size_t open = page.rfind("{{", close);
    const std::string_view name = page.substr(open + 2, close - open - 2);
    const auto text = std::ranges::find(texts, name, &std::pair<std::string_view, std::string_view>::first);
    filled.append(page.substr(0, open))
        .append(text != texts.end() ? text->second : page.substr(open, close + 2 - open));
    page.remove_prefix(close + 2);
  }
  return filled.append(page);
}

std::string EscapeHtml(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      case '{':  // The page's own placeholders are in braces.
        safe += "&#123;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

Result<std::string> MakePage(const fs::path& source, const sim::DataFolders& data, const PageTexts& texts,
                             const RecordedRun& recorded_run) {
  std::error_code error;
  std::vector<std::string> parts;
  std::string recorded = "null", scene_script;
  if (fs::is_directory(source, error)) {
    if (fs::exists(source / "sweep.id", error)) {
      Result<std::string> made = SweepData(source, data);
      if (!made) return made;
      parts.push_back(std::move(*made));
    } else {
      std::vector<fs::path> files;
      for (fs::directory_iterator it(source, error), end; !error && it != end; it.increment(error))
        if (record::IsRecording(it->path())) files.push_back(it->path());
      std::sort(files.begin(), files.end());
      if (files.empty())
        return ProblemIn(source, "this folder holds no recordings and no sweep",
                         "soarbox test and soarbox run --record make recordings");
      if (files.size() > kMostRuns) files.resize(kMostRuns);
      for (const fs::path& file : files) {
        Result<std::string> made = RunData(file, data, kMostBytesOfEach);
        if (!made) return made;
        parts.push_back(std::move(*made));
      }
    }
  } else if (record::IsRecording(source)) {
    Result<std::string> in_3d = recorded_run(source);
    if (!in_3d) return in_3d;
    recorded = ForScriptElement(*in_3d);
    scene_script = texts.scene;
    const std::size_t taken =
        kPlainBytes + recorded.size() + texts.page.size() + texts.script.size() + scene_script.size();
    Result<std::string> made =
        RunData(source, data, kMostBytes > taken + kLeastBytes ? kMostBytes - taken : kLeastBytes);
    if (!made) return made;
    parts.push_back(std::move(*made));
  } else if (source.extension() == ".toml" &&
             fs::exists(fs::path(source).replace_extension(".sweep") / "sweep.id", error)) {
    return MakePage(fs::path(source).replace_extension(".sweep"), data, texts, recorded_run);
  } else if (!fs::exists(source, error)) {
    return ProblemIn(source, "there is no such file or folder");
  } else if (source.extension() == ".toml") {
    return ProblemIn(source, "there are no results of a sweep beside this file",
                     "soarbox sweep " + source.filename().string() + " makes them");
  } else {
    return ProblemIn(source, "this is neither a recording, nor a folder of recordings, nor a sweep",
                     "soarbox run SCENARIO --record FILE makes a recording");
  }
  std::string all = "[";
  for (const std::string& part : parts) all += (all.size() > 1 ? ",\n" : "") + part;
  all += "]";
  const Json first = Json::parse(parts.front());
  char nonce[20];
  std::snprintf(nonce, sizeof nonce, "%016llx", static_cast<unsigned long long>(HashOf(all)));
  return FillIn(
      texts.page,
      {{"title", EscapeHtml(first.value("title", "Soarbox"))},
       {"policy", std::string("default-src 'none'; style-src 'unsafe-inline'; img-src data: blob:; "
                              "script-src 'nonce-") +
                      nonce + "'" + (scene_script.empty() ? "" : "; worker-src blob:; connect-src data: blob:")},
       {"plain", PlainBody(first)},
       {"nonce", nonce},
       {"data", ForScriptElement(all)},
       {"recorded", recorded},
       {"scene_script", scene_script},
       {"script", texts.script}});
}

}  // namespace soarbox::report
