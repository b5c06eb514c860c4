// SPDX-License-Identifier: BSD-2-Clause
#include "serve/activity.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

namespace soarbox::serve {
namespace {

using ContentJson = nlohmann::json;

/// The content of a message {"message":"contents","contents":{NAME: ...}}; always an object.
ContentJson ContentOf(const std::string& message, const char* name) {
  ContentJson json = message.empty() ? ContentJson() : ContentJson::parse(message, nullptr, false);
  if (json.is_object()) json = json.value("contents", ContentJson::object());
  if (json.is_object()) json = json.value(name, ContentJson::object());
  return json.is_object() ? std::move(json) : ContentJson::object();
}

std::string TextAt(const ContentJson& json, const char* field) {
  const auto found = json.find(field);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// The first error in a list of problems, with its place; empty: none.
std::string FirstError(const ContentJson& owner, const std::string& usual_file) {
  const auto problems = owner.find("problems");
  if (problems == owner.end() || !problems->is_array()) return {};
  for (const ContentJson& problem : *problems) {
    if (!problem.is_object() || TextAt(problem, "severity") != "error") continue;
    std::string file = TextAt(problem, "file");
    if (file.empty()) file = usual_file;
    file = file.substr(file.rfind('/') + 1);
    std::string text = "error";
    if (!file.empty()) text += " in " + file;
    if (const auto line = problem.find("line"); line != problem.end() && line->is_number_integer() && *line > 0)
      text += ", line " + std::to_string(line->get<int>());
    return text + ": " + TextAt(problem, "message");
  }
  return {};
}

}  // namespace

void Activity::Begin(const std::string& what, Time now) {
  if (what == what_) return;
  *this = {};
  what_ = what;
  asked_ = now;
}

void Activity::NoteRequest(const PageMessage& message, Time now) {
  // The page also sends these requests without a user's action.
  constexpr std::array<std::string_view, 5> kByItself = {"look", "overlays", "select", "language", "open"};
  for (const std::string_view word : kByItself)
    if (message.request == word) return;
  asked_ = now;
  if (message.request != "lesson" || message.what != "grade") return;
  if (grades_++ == 0) graded_since_ = now;
}

void Activity::Look(const std::string& edit, const std::string& problems, const std::string& mission, Time now) {
  const ContentJson edited = ContentOf(edit, "edit"), text = edited.value("edit", ContentJson::object());
  std::string mistake = text.is_object() ? FirstError(text, TextAt(text, "file")) : std::string();
  if (mistake.empty()) mistake = FirstError(ContentOf(problems, "problems"), {});
  // If another error replaces the first one, the rules have been wrong since the first.
  if (mistake_.empty() && !mistake.empty()) mistake_since_ = now;
  mistake_ = std::move(mistake);
  const ContentJson checked = ContentOf(mission, "mission");
  const auto lesson = checked.find("lesson");
  is_passed_ = lesson != checked.end() && lesson->is_object() && lesson->value("is_passed", ContentJson()) == true;
}

Activity::Standing Activity::At(Time now) const {
  Standing standing;
  standing.grades = grades_;
  const auto since = [&](Time then) { return std::chrono::duration_cast<std::chrono::seconds>(now - then); };
  const auto tell = [&](Kind kind, std::string text, Time then) {
    standing.kind = kind;
    standing.text = std::move(text);
    standing.lasts = since(then);
    return standing;
  };
  if (what_.empty()) return standing;
  if (since(asked_) >= kIdleAfter) return tell(Kind::kIdle, "has done nothing here", asked_);
  if (!mistake_.empty())
    return tell(since(mistake_since_) >= kStuckAfter ? Kind::kStuck : Kind::kMistake, mistake_, mistake_since_);
  if (grades_ >= kManyGrades && !is_passed_)
    return tell(Kind::kStuck, "graded " + std::to_string(grades_) + " times, not passed", graded_since_);
  return standing;
}

}  // namespace soarbox::serve
