// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/book.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "serve/lti/scores.h"
#include "serve/random_id.h"

namespace soarbox::lti {
namespace {

const Platform kMoodle = {"Moodle", "https://moodle.example", "client-1", {}, {}, {}, {}, {"1"}};

Launch LaunchOf(const std::string& subject, const std::string& course, const std::string& line_item = "") {
  Launch launch;
  launch.subject = subject;
  launch.course = course;
  launch.lesson = "02-operators";
  launch.line_item = line_item;
  return launch;
}

TEST(Book, PeopleOfACourseHavePlacesAndDifferentNames) {
  Book book;
  Book::Course& course = book.CourseOf(kMoodle, LaunchOf("1", "a"));
  book.Add(course, "1", "p1", "Ada");
  book.Add(course, "2", "p2", "Ada");
  book.Add(course, "3", "p3", "");
  EXPECT_EQ(book.NameOf("p1") + "," + book.NameOf("p2") + "," + book.NameOf("p3"), "Ada,Ada 2,Learner 3");
  EXPECT_EQ(&book.CourseOf(kMoodle, LaunchOf("9", "a")), &course);
  EXPECT_NE(book.CourseOf(kMoodle, LaunchOf("1", "b")).list.key(), course.list.key());
  EXPECT_EQ(book.FindByKey(course.list.key()), &course.list);
  EXPECT_EQ(book.FindByKey(""), nullptr);
  // A learner without a place gets a new one, with the same name.
  book.Add(course, "1", "p4", "Ada");
  EXPECT_EQ(book.NameOf("p4") + book.NameOf("p1"), "Ada");
  EXPECT_EQ(course.list.learners().size(), 3u);
}

TEST(Book, AScoreWaitsWhenALessonWasTriedOrPassedAndOnlyThen) {
  Book book;
  book.AddLink(kMoodle, LaunchOf("1", "a", "https://m/1"), "p1");
  book.AddLink(kMoodle, LaunchOf("1", "a", "https://m/1"), "p1");
  book.AddLink(kMoodle, LaunchOf("1", "a"), "p1");
  ASSERT_EQ(book.links().size(), 1u);
  Book::Link& link = book.links()[0];
  EXPECT_FALSE(book.Note(link, {false, 0, 2}, 1000)) << "a hint is not a try";
  EXPECT_TRUE(book.Note(link, {false, 1, 2}, 1000));
  EXPECT_EQ(link.comment, "Not passed yet, after 1 try and 2 hints.");
  EXPECT_FALSE(book.Note(link, {false, 1, 2}, 1001));
  EXPECT_TRUE(book.Note(link, {true, 2, 2}, 1000));
  EXPECT_EQ(link.graded_ms, 1001) << "times of scores grow";
  EXPECT_FALSE(book.Note(link, {true, 3, 2}, 2000)) << "passed is passed";
}

TEST(Book, ItIsTheSameAfterARestart) {
  const std::filesystem::path file = testing::TempDir() + "book_" + std::to_string(getpid()) + ".json";
  Book book;
  const std::string place = serve::NewId();
  book.Add(book.CourseOf(kMoodle, LaunchOf("1", "a")), "1", place, "Åsa");
  book.AddLink(kMoodle, LaunchOf("1", "a", "https://m/1"), place);
  book.Note(book.links()[0], {true, 1, 0}, 1000);
  std::ofstream(file) << book.ToText();
  const Result<Book> again = Book::Read(file);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->ToText(), book.ToText());
  EXPECT_EQ(again->NameOf(place), "Åsa");
  EXPECT_EQ(again->links()[0].state, Book::ScoreState::kWaits);
  for (const char* const odd :
       {"", "{}", "{\"courses\":5,\"links\":[]}", "{\"courses\":[{\"issuer\":1}],\"links\":[]}"}) {
    std::ofstream(file) << odd;
    EXPECT_FALSE(Book::Read(file)) << odd;
  }
  std::filesystem::remove(file);
  EXPECT_TRUE(Book::Read(file)->courses().empty());
}

TEST(Scores, TimesAreThoseOfIso8601) {
  EXPECT_EQ(TimeText(0), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(TimeText(1'709'210'096'007), "2024-02-29T12:34:56.007Z");
}

}  // namespace
}  // namespace soarbox::lti
