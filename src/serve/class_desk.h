// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::serve {

/// Communication between learners and their teacher: raised hands, and the teacher's messages, by the id of the
/// learner's place. Times are seconds since 1970.
class ClassDesk {
 public:
  struct Note {
    int id = 0;
    std::string text;
    std::string file = {};  ///< Name of the file if the message is about a line.
    int line = 0;           ///< From 1; 0 if it is not about a line.
    std::int64_t when_s = 0;
    bool is_read = false;
  };
  static constexpr std::size_t kMostTextBytes = 2000, kMostNotes = 50;

  /// Reads the output of ToText from a file. Fails if the file is damaged. Empty if there is no file.
  static Result<ClassDesk> Read(const std::filesystem::path& file);
  std::string ToText() const;

  void SetHand(const std::string& place, bool is_up, std::int64_t now_s);
  std::optional<std::int64_t> HandSince(const std::string& place) const;
  /// Adds a message, and removes the oldest if there are more than kMostNotes. Fails if the message is invalid.
  Result<void> Write(const std::string& place, Note note);
  void MarkRead(const std::string& place, int id);
  const std::vector<Note>& NotesOf(const std::string& place) const;
  /// The message for the learner's page: {"message":"class", "is_hand_up", "notes"} with the unread notes.
  std::string MessageFor(const std::string& place) const;

 private:
  std::map<std::string, std::int64_t, std::less<>> hands_;
  std::map<std::string, std::vector<Note>, std::less<>> notes_;
};

}  // namespace soarbox::serve
