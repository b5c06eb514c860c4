// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/book.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "diagnostics/json_text.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "serve/random_id.h"

namespace soarbox::lti {
namespace {

using BookJson = nlohmann::ordered_json;

constexpr std::array<const char*, 4> kStates = {"none", "waits", "sent", "refused"};

Book::ScoreState StateFrom(const std::string& word) {
  const auto found = std::ranges::find(kStates, word, [](const char* each) { return std::string(each); });
  return found == kStates.end() ? Book::ScoreState::kNone : static_cast<Book::ScoreState>(found - kStates.begin());
}

std::string CountOf(int count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

Result<Book> Book::Read(const std::filesystem::path& file) {
  Book book;
  const std::optional<std::string> text = ReadText(file);
  if (!text) return book;
  const Diagnostic damaged =
      ProblemIn(file, "this file is damaged: it says which place belongs to whom on learning platforms",
                "restore it, or move it away; then everybody who comes from a platform starts from the beginning");
  try {
    const BookJson json = BookJson::parse(*text);
    for (const BookJson& each : json.at("courses")) {
      Course& course = book.courses_.emplace_back();
      course.issuer = each.at("issuer").get<std::string>();
      course.client_id = each.at("client_id").get<std::string>();
      course.id = each.at("id").get<std::string>();
      course.title = each.at("title").get<std::string>();
      course.list = serve::ClassList::WithKey(each.at("key").get<std::string>());
      for (const BookJson& one : each.at("learners")) {
        const std::string place = one.at("place").get<std::string>(), name = one.at("name").get<std::string>();
        if (!serve::IsId(place)) return damaged;
        course.list.Add({name, place});
        course.places[one.at("subject").get<std::string>()] = place;
        book.names_[place] = name;
      }
    }
    for (const BookJson& each : json.at("links")) {
      Link link;
      link.issuer = each.at("issuer").get<std::string>();
      link.client_id = each.at("client_id").get<std::string>();
      link.subject = each.at("subject").get<std::string>();
      link.place = each.at("place").get<std::string>();
      link.lesson = each.at("lesson").get<std::string>();
      link.line_item = each.at("line_item").get<std::string>();
      link.tries = each.at("tries").get<int>();
      link.is_passed = each.at("is_passed").get<bool>();
      link.state = StateFrom(each.at("score").get<std::string>());
      link.graded_ms = each.at("graded_ms").get<std::int64_t>();
      link.comment = each.at("comment").get<std::string>();
      link.trouble = each.at("trouble").get<std::string>();
      book.links_.push_back(std::move(link));
    }
  } catch (const BookJson::exception&) {
    return damaged;
  }
  return book;
}

std::string Book::ToText() const {
  BookJson courses = BookJson::array(), links = BookJson::array();
  for (const Course& course : courses_) {
    BookJson learners = BookJson::array();
    for (const auto& [subject, place] : course.places)
      learners.push_back({{"subject", subject}, {"name", course.list.NameOf(place)}, {"place", place}});
    courses.push_back({{"issuer", course.issuer},
                       {"client_id", course.client_id},
                       {"id", course.id},
                       {"title", course.title},
                       {"key", course.list.key()},
                       {"learners", std::move(learners)}});
  }
  for (const Link& link : links_)
    links.push_back({{"issuer", link.issuer},
                     {"client_id", link.client_id},
                     {"subject", link.subject},
                     {"place", link.place},
                     {"lesson", link.lesson},
                     {"line_item", link.line_item},
                     {"tries", link.tries},
                     {"is_passed", link.is_passed},
                     {"score", kStates[static_cast<std::size_t>(link.state)]},
                     {"graded_ms", link.graded_ms},
                     {"comment", link.comment},
                     {"trouble", link.trouble}});
  return JsonText(BookJson{{"courses", std::move(courses)}, {"links", std::move(links)}}, 2) + "\n";
}

Book::Course& Book::CourseOf(const Platform& platform, const Launch& launch) {
  for (Course& course : courses_) {
    if (course.issuer != platform.issuer || course.client_id != platform.client_id || course.id != launch.course)
      continue;
    if (!launch.course_title.empty()) course.title = launch.course_title;
    return course;
  }
  Course& course = courses_.emplace_back();
  course.issuer = platform.issuer;
  course.client_id = platform.client_id;
  course.id = launch.course;
  course.title = launch.course_title.empty() ? platform.name : launch.course_title;
  course.list = serve::ClassList::WithKey(serve::NewId());
  return course;
}

void Book::Add(Course& course, const std::string& subject, const std::string& place, std::string name) {
  if (const auto before = course.places.find(subject); before != course.places.end()) {
    course.list.Remove(before->second);
    names_.erase(before->second);
  }
  const auto is_taken = [&](const std::string& wanted) {
    return std::ranges::any_of(course.list.learners(), [&](const auto& learner) { return learner.name == wanted; });
  };
  const std::string base = name.empty() ? "Learner" : name;
  for (std::size_t number = name.empty() ? course.list.learners().size() + 1 : 2; name.empty() || is_taken(name);
       ++number)
    name = base + " " + std::to_string(number);
  course.list.Add({name, place});
  course.places[subject] = place;
  names_[place] = name;
}

void Book::AddLink(const Platform& platform, const Launch& launch, const std::string& place) {
  if (launch.line_item.empty() || launch.lesson.empty()) return;
  const auto found = std::ranges::find_if(
      links_, [&](const Link& link) { return link.place == place && link.line_item == launch.line_item; });
  if (found != links_.end() && found->lesson == launch.lesson) {
    // The platform may now accept a score that it refused before.
    if (found->state == ScoreState::kRefused) found->state = ScoreState::kWaits;
    found->next_s = 0;
    return;
  }
  if (found != links_.end()) links_.erase(found);
  links_.push_back({platform.issuer, platform.client_id, launch.subject, place, launch.lesson, launch.line_item});
}

bool Book::Note(Link& link, const serve::Progress& progress, std::int64_t now_ms) {
  const bool is_new = progress.is_passed != link.is_passed || (progress.attempts != link.tries && !progress.is_passed);
  link.tries = progress.attempts;
  link.is_passed = progress.is_passed;
  if (!is_new) return false;
  link.state = ScoreState::kWaits;
  link.graded_ms = std::max(now_ms, link.graded_ms + 1);
  link.comment = (progress.is_passed ? "Passed after " : "Not passed yet, after ") +
                 CountOf(progress.attempts, "try", "tries") + " and " + CountOf(progress.hints, "hint", "hints") + ".";
  link.failures = 0;
  link.next_s = 0;
  return true;
}

std::string Book::NameOf(std::string_view place) const {
  const auto found = names_.find(place);
  return found == names_.end() ? std::string() : found->second;
}

const serve::ClassList* Book::FindByKey(std::string_view key) const {
  for (const Course& course : courses_)
    if (course.list.IsKey(key)) return &course.list;
  return nullptr;
}

}  // namespace soarbox::lti
