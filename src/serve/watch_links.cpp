// SPDX-License-Identifier: BSD-2-Clause
#include "serve/watch_links.h"

#include <fstream>
#include <optional>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "serve/random_id.h"

namespace soarbox::serve {
namespace {

std::filesystem::path NoteIn(const Place& place) {
  return place.root() / "watch-link";
}

bool WriteNote(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  out.close();
  return static_cast<bool>(out);
}

}  // namespace

std::string WatchLinks::Find(const Place& place) const {
  const std::string link = ReadText(NoteIn(place)).value_or("");
  return IsId(link) ? link : std::string();
}

Result<std::string> WatchLinks::FindOrMake(const Place& place) const {
  std::string link = Find(place);
  if (!link.empty()) return link;
  link = NewId();
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (!error && WriteNote(folder_ / link, place.id()) && WriteNote(NoteIn(place), link)) return link;
  return NewProblem("the server cannot write the link", "try again later");
}

void WatchLinks::Withdraw(const Place& place) const {
  std::error_code ignored;
  if (const std::string link = Find(place); !link.empty()) std::filesystem::remove(folder_ / link, ignored);
  std::filesystem::remove(NoteIn(place), ignored);
}

Result<std::string> WatchLinks::PlaceOf(std::string_view link) const {
  const std::string place = IsId(link) ? ReadText(folder_ / link).value_or("") : std::string();
  if (IsId(place)) return place;
  return NewProblem("there is nothing to watch by this link",
                    "the person who gave it to you may have withdrawn it: ask for another one");
}

}  // namespace soarbox::serve
