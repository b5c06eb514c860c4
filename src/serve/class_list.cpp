// SPDX-License-Identifier: BSD-2-Clause
#include "serve/class_list.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "diagnostics/json_text.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "serve/random_id.h"

namespace soarbox::serve {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMostLearners = 1000, kMostNameBytes = 100;

std::string Trimmed(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  return begin == std::string::npos ? "" : line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
}

}  // namespace

Result<ClassList> ClassList::Read(const fs::path& names, const fs::path& state, Places& places) {
  const std::optional<std::string> text = ReadText(names);
  if (!text) return ProblemIn(names, "this list of a class cannot be read", "it has a name on each line");
  const fs::path file = state / "class.json";
  Json kept = Json::object();
  if (const std::optional<std::string> before = ReadText(file)) {
    kept = Json::parse(*before, nullptr, false);
    if (!kept.is_object() || !kept.value("places", Json::object()).is_object())
      return ProblemIn(file, "this file is damaged: it says which place belongs to whom",
                       "restore it, or move it away; then everybody gets a new link");
  }
  ClassList list;
  list.key_ = kept.value("key", "");
  if (!IsId(list.key_)) list.key_ = NewId();
  Json known = kept.value("places", Json::object());
  std::istringstream lines(*text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::string name = Trimmed(line);
    if (name.empty() || name.starts_with('#')) continue;
    Diagnostic problem = ProblemIn(names, {});
    problem.line = number;
    if (name.size() > kMostNameBytes) problem.message = "this name is longer than 100 bytes";
    if (std::ranges::any_of(list.learners_, [&](const Learner& other) { return other.name == name; }))
      problem.message = "this name is there twice: " + name, problem.hint = "make them differ, so that each has a link";
    if (list.learners_.size() == kMostLearners) problem.message = "a class has at most 1000 learners";
    if (!problem.message.empty()) return problem;
    std::string id = known.contains(name) && known[name].is_string() ? known[name].get<std::string>() : "";
    if (!places.Find(id)) {
      Result<Place> place = places.New();
      if (!place) return place.error();
      id = place->id();
      known[name] = id;
    }
    list.learners_.push_back({name, id});
  }
  if (list.learners_.empty())
    return ProblemIn(names, "this list of a class holds no name", "write a name on each line");
  const fs::path making = fs::path(file) += ".part";
  std::ofstream(making) << JsonText(Json{{"key", list.key_}, {"places", known}}, 2) << '\n';
  std::error_code error;
  fs::rename(making, file, error);
  if (error) return ProblemIn(file, "this file cannot be written: " + error.message());
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write, error);
  return list;
}

ClassList ClassList::WithKey(std::string key) {
  ClassList list;
  list.key_ = std::move(key);
  return list;
}

void ClassList::Remove(std::string_view place) {
  std::erase_if(learners_, [&](const Learner& learner) { return learner.place == place; });
}

bool ClassList::IsKey(std::string_view given) const {
  return !key_.empty() && SameSecret(given, key_);
}

std::string ClassList::NameOf(std::string_view place) const {
  const auto found = std::ranges::find(learners_, place, &Learner::place);
  return found == learners_.end() ? std::string() : found->name;
}

}  // namespace soarbox::serve
