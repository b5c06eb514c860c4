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

/// What learners and their teacher say to each other: raised hands, and the teacher's messages. By the id of the
/// learner's place. Times are seconds since 1970.
class ClassDesk {
 public:
  struct Note {
    int id = 0;
    std::string text;
    std::string file = {};  ///< If it is about a line: the name of the file.
    int line = 0;           ///< From 1; 0: it is about no line.
    std::int64_t when_s = 0;
    bool is_read = false;
  };
  static constexpr std::size_t kMostTextBytes = 2000, kMostNotes = 50;

  /// From what ToText has written; the error says that the file is damaged. Nothing is known without a file.
  static Result<ClassDesk> Read(const std::filesystem::path& file);
  std::string ToText() const;

  void SetHand(const std::string& place, bool is_up, std::int64_t now_s);
  std::optional<std::int64_t> HandSince(const std::string& place) const;
  /// Adds a message, and removes the oldest if there are more than kMostNotes. The error says what is wrong with it.
  Result<void> Write(const std::string& place, Note note);
  void MarkRead(const std::string& place, int id);
  const std::vector<Note>& NotesOf(const std::string& place) const;
  /// What the learner's page is told: {"message":"class", "is_hand_up", "notes"} with the notes that are not read.
  std::string MessageFor(const std::string& place) const;

 private:
  std::map<std::string, std::int64_t, std::less<>> hands_;
  std::map<std::string, std::vector<Note>, std::less<>> notes_;
};

}  // namespace soarbox::serve
