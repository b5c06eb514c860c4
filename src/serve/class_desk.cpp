// SPDX-License-Identifier: BSD-2-Clause
#include "serve/class_desk.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "diagnostics/json_text.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"

namespace soarbox::serve {
namespace {

using DeskJson = nlohmann::ordered_json;

DeskJson JsonOf(const ClassDesk::Note& note) {
  return {{"id", note.id},     {"text", note.text},   {"file", note.file},
          {"line", note.line}, {"when", note.when_s}, {"is_read", note.is_read}};
}

ClassDesk::Note NoteFrom(const DeskJson& json) {
  return {json.value("id", 0),   json.value("text", ""),  json.value("file", ""),
          json.value("line", 0), json.value("when", 0ll), json.value("is_read", false)};
}

}  // namespace

Result<ClassDesk> ClassDesk::Read(const std::filesystem::path& file) {
  ClassDesk desk;
  const std::optional<std::string> text = ReadText(file);
  if (!text) return desk;
  const Diagnostic damaged = ProblemIn(file, "this file is damaged: it holds the messages of the class",
                                       "move it away; the messages and raised hands in it are lost then");
  try {
    const DeskJson json = DeskJson::parse(*text);
    for (const auto& [place, since] : json.at("hands").items()) desk.hands_[place] = since.get<std::int64_t>();
    for (const auto& [place, notes] : json.at("notes").items())
      for (const DeskJson& note : notes) desk.notes_[place].push_back(NoteFrom(note));
  } catch (const DeskJson::exception&) {
    return damaged;
  }
  return desk;
}

std::string ClassDesk::ToText() const {
  DeskJson hands = DeskJson::object(), notes = DeskJson::object();
  for (const auto& [place, since] : hands_) hands[place] = since;
  for (const auto& [place, all] : notes_) {
    notes[place] = DeskJson::array();
    for (const Note& note : all) notes[place].push_back(JsonOf(note));
  }
  return JsonText(DeskJson{{"hands", std::move(hands)}, {"notes", std::move(notes)}}, 2) + "\n";
}

void ClassDesk::SetHand(const std::string& place, bool is_up, std::int64_t now_s) {
  is_up ? void(hands_.try_emplace(place, now_s)) : void(hands_.erase(place));
}

std::optional<std::int64_t> ClassDesk::HandSince(const std::string& place) const {
  const auto found = hands_.find(place);
  return found == hands_.end() ? std::nullopt : std::optional(found->second);
}

Result<void> ClassDesk::Write(const std::string& place, Note note) {
  if (note.text.find_first_not_of(" \t\r\n") == std::string::npos)
    return NewProblem("this message is empty", "write what the learner is to read");
  if (note.text.size() > kMostTextBytes || note.file.size() > kMostTextBytes)
    return NewProblem("this message is longer than 2,000 bytes", "write a shorter one");
  if (note.line < 0 || (note.line > 0 && note.file.empty()))
    return NewProblem("a message about a line needs the file and the number of the line, from 1");
  std::vector<Note>& all = notes_[place];
  note.id = all.empty() ? 1 : all.back().id + 1;
  all.push_back(std::move(note));
  if (all.size() > kMostNotes) all.erase(all.begin());
  return {};
}

void ClassDesk::MarkRead(const std::string& place, int id) {
  const auto found = notes_.find(place);
  if (found == notes_.end()) return;
  for (Note& note : found->second) note.is_read |= note.id == id;
}

const std::vector<ClassDesk::Note>& ClassDesk::NotesOf(const std::string& place) const {
  static const std::vector<Note> kNone;
  const auto found = notes_.find(place);
  return found == notes_.end() ? kNone : found->second;
}

std::string ClassDesk::MessageFor(const std::string& place) const {
  DeskJson notes = DeskJson::array();
  for (const Note& note : NotesOf(place))
    if (!note.is_read) notes.push_back(JsonOf(note));
  return JsonText(
      DeskJson{{"message", "class"}, {"is_hand_up", HandSince(place).has_value()}, {"notes", std::move(notes)}});
}

}  // namespace soarbox::serve
