// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "serve/class_list.h"
#include "serve/lti/launch.h"
#include "serve/lti/platform_file.h"
#include "serve/server_settings.h"

namespace soarbox::lti {

/// The stored data about learning platforms: courses, the owner of each place, and scores that were sent or are
/// waiting. Times are seconds since 1970. It belongs to one thread.
class Book {
 public:
  struct Course {
    std::string issuer, client_id, id, title;
    serve::ClassList list;                                   ///< Its learners, and the key of its teachers.
    std::map<std::string, std::string, std::less<>> places;  ///< By the person's id on the platform.
  };
  enum class ScoreState : std::uint8_t { kNone, kWaits, kSent, kRefused };
  /// A lesson whose scores of one learner go to a line item of the platform.
  struct Link {
    std::string issuer, client_id, subject, place, lesson, line_item;
    int tries = 0;           ///< Number of the learner's attempts when Note was called last.
    bool is_passed = false;  ///< Whether the lesson was passed then.
    ScoreState state = ScoreState::kNone;
    std::int64_t graded_ms = 0;  ///< When the last score was reached. Greater for each new score.
    std::string comment = {}, trouble = {};
    int failures = 0;         ///< Number of successive attempts to send it that failed. Not stored in the file.
    std::int64_t next_s = 0;  ///< It is not sent before this time. Not stored in the file.
  };

  /// Reads the output of ToText from a file. Fails if the file is damaged. Empty if there is no file.
  static Result<Book> Read(const std::filesystem::path& file);
  std::string ToText() const;

  /// The course of a launch. Adds the course if it is new, and updates its title.
  Course& CourseOf(const Platform& platform, const Launch& launch);
  /// Adds a learner with a place to a course, or replaces the learner's place. If another learner of the course has the
  /// same name, a number is added to it. Without a name: "Learner" and a number.
  void Add(Course& course, const std::string& subject, const std::string& place, std::string name);
  /// Stores where the scores of the launch's lesson go. Does nothing if the launch has no lesson or no line item.
  void AddLink(const Platform& platform, const Launch& launch, const std::string& place);
  /// Stores a learner's progress in the lesson of a link. Returns whether there is a new score to send.
  bool Note(Link& link, const serve::Progress& progress, std::int64_t now_ms);

  /// Pointers to courses stay valid when others are added.
  const std::deque<Course>& courses() const { return courses_; }
  std::vector<Link>& links() { return links_; }
  const std::vector<Link>& links() const { return links_; }
  /// The name of the learner who owns this place; empty: it has no owner.
  std::string NameOf(std::string_view place) const;
  /// The course with this key; null: none.
  const serve::ClassList* FindByKey(std::string_view key) const;

 private:
  std::deque<Course> courses_;
  std::vector<Link> links_;
  std::map<std::string, std::string, std::less<>> names_;  ///< By place.
};

}  // namespace soarbox::lti
