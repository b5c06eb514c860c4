// SPDX-License-Identifier: BSD-2-Clause
#include "sim/client_percepts.h"

#include <cstdlib>

namespace soarbox::sim {

mind::Value ClientValue(std::string_view type, const std::string& text) {
  if (type == "int") return std::int64_t{std::strtoll(text.c_str(), nullptr, 10)};
  if (type == "double") return std::strtod(text.c_str(), nullptr);
  return std::string_view(text);
}

bool ClientPercepts::Note(const std::vector<std::string>& parts, std::string_view input_link, mind::EventLog* log) {
  const std::string& kind = parts.front();
  if (kind == "add") return parts.size() >= 8 && NoteAdd(parts, input_link, log);
  if (parts.size() < 3) return false;
  const auto found = places_.find(parts[2]);
  if (found == places_.end()) return false;
  const Place& place = found->second;
  if (kind == "set") {
    if (log != nullptr && parts.size() >= 6)
      log->Add(mind::PerceptChanged{place.path, place.attribute, place.key, ClientValue(parts[4], parts[5])});
    return true;
  }
  if (log != nullptr) log->Add(mind::PerceptGone{place.path, place.attribute, place.key});
  taken_keys_[place.path + place.attribute].erase(place.key);
  places_.erase(found);
  return true;
}

bool ClientPercepts::NoteAdd(const std::vector<std::string>& parts, std::string_view input_link, mind::EventLog* log) {
  const std::string &handle = parts[2], &id = parts[4], &type = parts[6], &value = parts[7];
  Place place;
  if (id != input_link) {
    const auto parent = paths_.find(id);
    if (parent == paths_.end()) return false;
    place.path = parent->second;
  }
  place.attribute = parts[5];
  place.key = FreeKey(place);
  attributes_.insert(place.attribute);
  if (type == "id") {
    const std::string number = place.key == 0 ? "" : "#" + std::to_string(place.key);
    paths_.try_emplace(value, place.path + place.attribute + number + ".");
  } else if (log != nullptr) {
    log->Add(mind::PerceptChanged{place.path, place.attribute, place.key, ClientValue(type, value)});
  }
  places_.insert_or_assign(handle, std::move(place));
  return true;
}

std::uint32_t ClientPercepts::FreeKey(const Place& place) {
  std::set<std::uint32_t>& taken = taken_keys_[place.path + place.attribute];
  std::uint32_t key = 0;
  for (const std::uint32_t one : taken) {
    if (one != key) break;
    ++key;
  }
  taken.insert(key);
  return key;
}

void ClientPercepts::Clear() {
  paths_.clear();
  places_.clear();
  taken_keys_.clear();
}

}  // namespace soarbox::sim
