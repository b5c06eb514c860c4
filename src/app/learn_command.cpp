// SPDX-License-Identifier: BSD-2-Clause
#include "app/learn_command.h"

#include <unistd.h>

#include <algorithm>
#include <functional>
#include <iostream>

#include "app/data_folders.h"
#include "app/diagnostic_json.h"
#include "app/exit_codes.h"
#include "app/lesson.h"
#include "app/lesson_progress.h"
#include "app/own_world.h"
#include "app/refuse.h"
#include "app/run_session.h"
#include "diagnostics/diagnostic.h"
#include "diagnostics/read_text.h"
#include "mission/check_sentences.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;

/// Number of seeds with which a wrong answer is tested. With a single seed, it might pass by chance.
constexpr std::size_t kWrongSeeds = 4;
/// Minimum number of wrong answers of a lesson.
constexpr std::size_t kFewestWrong = 4;
/// The exit code after Ctrl-C.
constexpr int kInterrupted = 130;
/// Maximum number of sentences about what went wrong.
constexpr std::size_t kMostFindings = 6;

class Learner {
 public:
  /// `course` is the name of a course in the folder of lessons, "eaters"; empty: none.
  Learner(const LearnOptions& options, const std::string& course, const sim::DataFolders& data,
          std::vector<Lesson> lessons)
      : options_(options),
        data_(data),
        command_("soarbox learn " + course + (course.empty() ? "" : " ")),
        lessons_(std::move(lessons)) {
    folder_ = options.folder.empty() ? LessonsFolder() : options.folder;
  }

  int List() {
    for (std::size_t i = 0; i < lessons_.size(); ++i) {
      const Lesson& lesson = lessons_[i];
      const int attempts = progress_.Get(lesson.name, "attempts"), hints = progress_.Get(lesson.name, "hints");
      if (options_.json) {
        std::cout << JsonText(Json{{"number", i + 1},
                                   {"name", lesson.name},
                                   {"title", lesson.title},
                                   {"passed", progress_.IsPassed(lesson.name)},
                                   {"attempts", attempts},
                                   {"hints", hints}})
                  << '\n';
        continue;
      }
      std::cout << (progress_.IsPassed(lesson.name) ? "done  " : "      ") << (i + 1 < 10 ? " " : "") << i + 1 << "  "
                << lesson.title;
      if (attempts > 0)
        std::cout << "  (" << attempts << (attempts == 1 ? " attempt" : " attempts")
                  << (hints > 0 ? ", " + std::to_string(hints) + (hints == 1 ? " hint" : " hints") : std::string())
                  << ")";
      std::cout << '\n';
    }
    if (!options_.json)
      std::cout << '\n'
                << command_ << "N" << WithFolder() << " begins a lesson, " << command_ << "next" << WithFolder()
                << " begins the first that is not done\n";
    return kOk;
  }

  const Lesson* Find(const std::string& word) const {
    for (std::size_t i = 0; i < lessons_.size(); ++i)
      if (word == std::to_string(i + 1) || word == lessons_[i].name) return &lessons_[i];
    if (word != "next") return nullptr;
    const auto at = std::find_if(lessons_.begin(), lessons_.end(),
                                 [&](const Lesson& lesson) { return !progress_.IsPassed(lesson.name); });
    return at != lessons_.end() ? &*at : &lessons_.back();
  }

  fs::path FolderOf(const Lesson& lesson) const { return folder_ / lesson.name; }

  bool Prepare(const Lesson& lesson) {
    const Result<void> prepared = PrepareLesson(lesson, FolderOf(lesson));
    if (!prepared) std::cerr << Format(prepared.error());
    return prepared.ok();
  }

  int Begin(const Lesson& lesson) {
    if (!Prepare(lesson)) return kCannotStart;
    const fs::path folder = FolderOf(lesson);
    const std::string number = std::to_string(&lesson - lessons_.data() + 1);
    std::cout << "Lesson " << number << ". " << lesson.title << "\n\n"
              << lesson.idea << "\n\nTask: " << lesson.task << "\nEdit:  " << (folder / lesson.rules).string()
              << "\nSee:   soarbox run " << Quoted(folder) << "\nGrade: " << command_ << "check " << number
              << WithFolder() << "\nStuck: " << command_ << "hint " << number << WithFolder() << "\n";
    if (!lesson.panel.empty()) {
      std::cout << "Look:  the panel " << lesson.panel;
      for (std::size_t i = 0; i < lesson.also.size(); ++i) std::cout << (i == 0 ? "; also " : ", ") << lesson.also[i];
      std::cout << "\n";
    }
    if (options_.headless) return kOk;
    std::cout.flush();
    RunOptions run = options_.window;
    run.scenario = folder.string();
    run.lesson = lesson.folder;
    run.watch = true;
    return Run(run);
  }

  int Hint(const Lesson& lesson) {
    const int used = progress_.Get(lesson.name, "hints");
    const auto count = static_cast<int>(lesson.hints.size());
    for (int i = 0; i <= std::min(used, count - 1); ++i)
      std::cout << i + 1 << ". " << lesson.hints[static_cast<std::size_t>(i)] << '\n';
    if (used >= count) std::cout << "These are all hints.\n";
    if (used < count) progress_.Set(lesson.name, "hints", used + 1);
    return kOk;
  }

  int Check(const Lesson& lesson) {
    const fs::path folder = FolderOf(lesson);
    std::error_code error;
    if (!fs::exists(folder / lesson.rules, error))
      return Refuse("this lesson has not begun", command_ + lesson.name + WithFolder() + " puts its files there",
                    folder.string());
    if (lesson.own) {
      // A learner's own world is graded by the errors that its checks detect.
      const OwnWorldGrade graded = GradeOwnWorld(*lesson.own, folder, data_, ShowProgress());
      return Note(lesson, graded, graded.passed());
    }
    const Result<Grade> graded = GradeRules(lesson, folder, 0, ShowProgress());
    if (!graded) return Refuse(graded.error());
    return Note(lesson, *graded, graded->passed);
  }

  /// Notes a grade in the learner's progress, and prints it. Returns an exit code.
  template <typename Graded>
  int Note(const Lesson& lesson, const Graded& graded, bool passed) {
    if (graded.cancelled) {
      std::cout << "Grading was cancelled. There is no verdict.\n";
      return kInterrupted;
    }
    if (!graded.problems.empty()) {
      for (const Diagnostic& problem : graded.problems) std::cout << Format(problem);
      std::cout << "Fix this first. It does not count as an attempt.\n";
      return kProblems;
    }
    progress_.Set(lesson.name, "attempts", progress_.Get(lesson.name, "attempts") + 1);
    Print(lesson, graded);
    if (passed) progress_.Set(lesson.name, "passed", 1);
    return passed ? kOk : kProblems;
  }

  /// Prints "seed 3 of 10": with --progress a line each; else on a terminal one line that is overwritten.
  OnSeed ShowProgress() const {
    if (options_.progress)
      return [](std::size_t done, std::size_t of) { std::cout << kProgressLine << done << " of " << of << std::endl; };
    if (isatty(STDERR_FILENO) == 0) return {};
    return [](std::size_t done, std::size_t of) {
      if (done < of)
        std::cerr << "\r" << kProgressLine << done << " of " << of << "  " << std::flush;
      else
        std::cerr << "\r                    \r" << std::flush;
    };
  }

  /// Prints the headline first, then the checks of one run, then the other findings.
  void Print(const Lesson& lesson, const Grade& grade) const {
    if (grade.outcome.runs.empty()) return;
    const std::size_t seeds = grade.outcome.runs.size();
    if (grade.passed) {
      std::cout << "Passed with all of " << seeds << " seeds.\n";
      PrintChecks(lesson, grade.outcome.runs.front());
      for (const Diagnostic& warning : grade.warnings) std::cout << Format(warning);
      return;
    }
    const mission::RunResult& run = grade.outcome.runs[grade.example];
    if (!grade.findings.empty()) std::cout << grade.findings.front().text << "\n\n";
    if (run.outcome == "ok") PrintChecks(lesson, run);
    std::cout << grade.outcome.passed << " of " << seeds << " seeds passed; this was seed " << run.seed
              << ": soarbox run " << Quoted(FolderOf(lesson)) << " --seed " << run.seed << '\n';
    const std::size_t count = std::min(grade.findings.size(), kMostFindings);
    if (count > 1) std::cout << "\nThis was found, too:\n";
    for (std::size_t i = 1; i < count; ++i) std::cout << "- " << grade.findings[i].text << '\n';
  }

  static void Print(const Lesson&, const OwnWorldGrade& grade) {
    const OwnWorldPoint* missing = grade.Missing();
    std::cout << (missing == nullptr ? "Passed: your checks notice when rules are left out.\n"
                                     : missing->advice + "\n\n");
    for (const OwnWorldPoint& point : grade.points) {
      std::cout << (point.is_met ? "  yes  " : "  no   ") << point.text << '\n';
      for (const std::string& detail : point.details) std::cout << "         " << detail << '\n';
    }
    for (const Diagnostic& warning : grade.warnings) std::cout << Format(warning);
  }

  static void PrintChecks(const Lesson& lesson, const mission::RunResult& run) {
    const mission::Mission& mission = lesson.loaded.mission;
    for (std::size_t i = 0; i < mission.checks.size() && i < run.checks.size(); ++i) {
      if (mission.checks[i].marker) continue;
      const mission::CheckResult& check = run.checks[i];
      const bool is_good = check.verdict.state == mission::State::kTrue;
      std::cout << (is_good ? "  yes  " : "  no   ") << mission.checks[i].name;
      if (!is_good) std::cout << "\n         " << check.expected << "; " << check.verdict.was;
      std::cout << '\n';
    }
  }

  int Reset(const Lesson& lesson) {
    const fs::path folder = FolderOf(lesson);
    std::error_code error;
    if (!fs::exists(folder, error)) return Begin(lesson);
    for (int number = 2; number < 1000; ++number) {
      const fs::path kept = folder_ / (lesson.name + "." + std::to_string(number));
      if (fs::exists(kept, error)) continue;
      fs::rename(folder, kept, error);
      if (error) return Refuse("this folder cannot be moved: " + error.message(), {}, folder.string());
      std::cout << "what you wrote is kept in " << kept.string() << '\n';
      return Prepare(lesson) ? kOk : kCannotStart;
    }
    return Refuse("there are too many earlier folders of this lesson", "remove some", folder_.string());
  }

  /// Tests one lesson or all: starters must fail, solutions must pass, and each wrong answer must be recognised as its
  /// mistake.
  int Test(const Lesson* only) {
    int bad = 0;
    const auto tell = [&bad](const Lesson& lesson, const std::string& what, const std::string& wrong) {
      std::cout << lesson.name << "  " << what << ": " << (wrong.empty() ? "as it should" : wrong) << '\n'
                << std::flush;
      bad += wrong.empty() ? 0 : 1;
    };
    for (const Lesson& lesson : lessons_) {
      if (only != nullptr && &lesson != only) continue;
      if (WasInterrupted()) return kInterrupted;
      if (lesson.own) {
        TestWorlds(lesson, tell);
        continue;
      }
      const Result<Grade> starter = GradeRules(lesson, lesson.folder, 1);
      tell(lesson, "starter",
           !starter          ? starter.error().message
           : starter->passed ? "it passes already"
                             : std::string());
      const Result<Grade> solution = GradeRules(lesson, lesson.folder / "solution", 0);
      std::string why;
      if (!solution) {
        why = solution.error().message;
      } else if (!solution->problems.empty()) {
        why = solution->problems.front().message;
      } else if (!solution->passed) {
        Print(lesson, *solution);
        why = std::to_string(solution->outcome.passed) + " of " + std::to_string(solution->outcome.runs.size()) +
              " seeds pass";
      }
      tell(lesson, "solution", why);
      const std::vector<fs::path> wrong = WrongAnswersOf(lesson);
      for (const fs::path& folder : wrong) {
        const std::string expected = ExpectedOf(folder);
        const Result<Grade> grade = GradeRules(lesson, folder, kWrongSeeds);
        std::string problem;
        if (!grade) {
          problem = grade.error().message;
        } else if (expected == "refused") {
          problem = grade->problems.empty() ? "its rules should be refused" : "";
        } else if (!grade->problems.empty()) {
          problem = Format(grade->problems.front());
        } else if (grade->passed) {
          problem = "it passes";
        } else if (grade->mistake != expected) {
          Print(lesson, *grade);
          problem = "it should be reported as \"" + expected + "\", but is reported as \"" + grade->mistake + "\"";
        }
        tell(lesson, "wrong/" + folder.filename().string(), problem);
      }
      if (wrong.size() < kFewestWrong)
        tell(lesson, "wrong", "there are only " + std::to_string(wrong.size()) + " wrong answers");
    }
    return bad == 0 ? kOk : kProblems;
  }

 private:
  static std::vector<fs::path> WrongAnswersOf(const Lesson& lesson) {
    std::vector<fs::path> wrong;
    std::error_code error;
    for (fs::directory_iterator it(lesson.folder / "wrong", error), end; !error && it != end; it.increment(error))
      wrong.push_back(it->path());
    std::sort(wrong.begin(), wrong.end());
    return wrong;
  }

  /// The mistake that a wrong answer demonstrates.
  static std::string ExpectedOf(const fs::path& wrong) {
    std::string expected = ReadText(wrong / "expects").value_or("");
    while (!expected.empty() && expected.back() == '\n') expected.pop_back();
    return expected;
  }

  /// Tests the worlds of a lesson in which the learner creates the world: a wrong one must fail the requirement that it
  /// demonstrates.
  void TestWorlds(const Lesson& lesson,
                  const std::function<void(const Lesson&, const std::string&, const std::string&)>& tell) const {
    const auto missing_of = [&](const fs::path& folder) -> std::string {
      const OwnWorldGrade grade = GradeOwnWorld(*lesson.own, folder, data_);
      if (!grade.problems.empty()) return Format(grade.problems.front());
      return grade.Missing() == nullptr ? "" : grade.Missing()->name;
    };
    tell(lesson, "starter", missing_of(lesson.folder).empty() ? "it passes already" : "");
    const std::string missing = missing_of(lesson.folder / "solution");
    tell(lesson, "solution", missing.empty() ? "" : "it lacks \"" + missing + "\"");
    const std::vector<fs::path> wrong = WrongAnswersOf(lesson);
    for (const fs::path& folder : wrong) {
      const std::string expected = ExpectedOf(folder), found = missing_of(folder);
      tell(lesson, "wrong/" + folder.filename().string(),
           found == expected ? "" : "it should lack \"" + expected + "\", but lacks \"" + found + "\"");
    }
    if (wrong.size() < kFewestWrong)
      tell(lesson, "wrong", "there are only " + std::to_string(wrong.size()) + " wrong answers");
  }

  /// A path as a word of a command line.
  static std::string Quoted(const fs::path& path) {
    const std::string text = path.string();
    return text.find_first_of(" '\"\\$&;()") == std::string::npos ? text : "\"" + text + "\"";
  }
  /// The option that commands need in addition if the learner's files are not in the default folder: " --folder X".
  std::string WithFolder() const { return options_.folder.empty() ? "" : " --folder " + Quoted(options_.folder); }

  const LearnOptions& options_;
  const sim::DataFolders& data_;
  std::string command_;  ///< "soarbox learn " or, for a course, "soarbox learn COURSE ".
  std::vector<Lesson> lessons_;
  fs::path folder_;
  LessonProgress progress_;
};

}  // namespace

int Learn(const LearnOptions& options) {
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  fs::path from = options.from.empty() ? ShippedLessons(*data) : options.from;
  std::vector<std::string> words = options.words;
  const std::vector<std::string> courses = CoursesIn(from);
  std::string course;
  if (!words.empty() && std::ranges::find(courses, words.front()) != courses.end()) {
    course = words.front();
    from /= course;
    words.erase(words.begin());
  }
  std::vector<Diagnostic> problems;
  std::vector<Lesson> lessons = ReadLessons(from, *data, problems);
  for (const Diagnostic& problem : problems) std::cerr << Format(problem);
  if (!problems.empty()) return kCannotStart;
  if (lessons.empty()) return Refuse("there are no lessons in " + from.string());
  CatchInterrupts();
  Learner learner(options, course, *data, std::move(lessons));
  if (words.empty()) {
    const int listed = learner.List();
    if (!options.json && course.empty())
      for (const std::string& other : courses) {
        const std::string about = AboutCourse(from / other);
        std::cout << "soarbox learn " << other << " lists another course" << (about.empty() ? "" : ": " + about)
                  << '\n';
      }
    return listed;
  }
  const std::string& first = words.front();
  const bool is_test = first == "test";
  if (is_test && words.size() == 1) return learner.Test(nullptr);
  const bool is_verb = is_test || first == "check" || first == "hint" || first == "reset";
  if (is_verb && words.size() > 2) return Refuse("this is one word too many: " + words.back());
  const std::string which = is_verb ? (words.size() > 1 ? words[1] : "next") : first;
  const Lesson* lesson = learner.Find(which);
  if (lesson == nullptr) {
    std::vector<std::string_view> known = {"check", "hint", "reset", "test", "next"};
    if (course.empty()) known.insert(known.end(), courses.begin(), courses.end());
    // "learn chek 1": a word of the command. "learn check eater": only a number can be meant.
    std::string near(is_verb ? std::string_view() : Suggest(which, known));
    if (!near.empty() && !course.empty()) near.insert(0, course + " ");
    if (!near.empty() && words.size() > 1) near += " " + words[1];
    return Refuse("there is no lesson '" + which + "'",
                  near.empty() ? "soarbox learn " + (course.empty() ? "" : course + " ") + "lists them"
                               : "did you mean soarbox learn " + near + "?");
  }
  if (is_test) return learner.Test(lesson);
  if (first == "check") return learner.Check(*lesson);
  if (first == "hint") return learner.Hint(*lesson);
  if (first == "reset") return learner.Reset(*lesson);
  return learner.Begin(*lesson);
}

}  // namespace soarbox::app
