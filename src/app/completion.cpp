// SPDX-License-Identifier: BSD-2-Clause
#include "app/completion.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "app/argument_kinds.h"
#include "app/data_folders.h"
#include "app/lesson.h"
#include "sim/scenario.h"

namespace soarbox::app {
namespace {

class Completion {
 public:
  Completion(const CLI::App& program, std::vector<std::string> words, std::ostream& out)
      : program_(program), out_(out), current_(words.empty() ? "" : words.back()) {
    if (!words.empty()) words.pop_back();
    Read(words);
  }

  void Print() {
    if (command_ == nullptr) {
      if (current_.starts_with('-')) return OfferOptions(program_);
      return OfferCommands();
    }
    if (waits_ != nullptr) return OfferValues(*waits_, "", current_);
    if (const std::size_t sign = current_.find('='); current_.starts_with("--") && sign != std::string::npos) {
      const CLI::Option* option = Find(current_.substr(0, sign));
      if (option != nullptr && TakesValue(*option))
        OfferValues(*option, current_.substr(0, sign + 1), current_.substr(sign + 1));
      return;
    }
    const CLI::Option* positional = NextPositional();
    if (current_.starts_with('-') || (current_.empty() && positional == nullptr)) return OfferOptions(*command_);
    if (positional != nullptr) OfferValues(*positional, "", current_);
  }

 private:
  /// Parses the words before the completed word.
  void Read(const std::vector<std::string>& words) {
    for (const std::string& word : words) {
      if (waits_ != nullptr) {
        waits_ = nullptr;
      } else if (command_ == nullptr) {
        command_ = FindCommand(program_, word);
      } else if (word.starts_with('-') && word.size() > 1) {
        const CLI::Option* option = Find(word.substr(0, word.find('=')));
        used_.insert(option);
        if (option != nullptr && TakesValue(*option) && word.find('=') == std::string::npos) waits_ = option;
      } else {
        positionals_.push_back(word);
      }
    }
  }

  const CLI::Option* Find(const std::string& name) const { return command_->get_option_no_throw(name); }

  /// The next positional argument; null if there is none.
  const CLI::Option* NextPositional() const {
    const std::vector<const CLI::Option*> all = PositionalsOf(*command_);
    if (positionals_.size() < all.size()) return all[positionals_.size()];
    return !all.empty() && MayRepeat(*all.back()) ? all.back() : nullptr;
  }

  void Offer(const std::string& candidate, const std::string& about = {}) {
    if (!candidate.starts_with(current_)) return;
    out_ << candidate;
    if (!about.empty()) out_ << '\t' << about;
    out_ << '\n';
  }

  void OfferCommands() {
    for (const CLI::App* each : ListedCommands(program_)) Offer(each->get_name(), each->get_description());
  }

  void OfferOptions(const CLI::App& command) {
    for (const CLI::Option* option : OptionsOf(command)) {
      if (used_.contains(option) && !MayRepeat(*option)) continue;
      for (const std::string& name : option->get_lnames()) Offer("--" + name, option->get_description());
      if (!current_.starts_with("--") && !current_.empty())
        for (const std::string& name : option->get_snames()) Offer("-" + name, option->get_description());
    }
  }

  /// Offers values of an option. `before`: the part of the word before the value, such as "--detail=".
  void OfferValues(const CLI::Option& option, const std::string& before, const std::string& value) {
    const ArgumentKind kind = KindOf(*command_, option);
    switch (kind.offers) {
      case Offers::kNothing:
        return;
      case Offers::kFiles:
        return OfferFiles(kind, before);
      case Offers::kFolders:
        out_ << ":folders\n";
        return OfferBehind(before);
      case Offers::kNamedFiles:
        if (const std::size_t sign = value.find('='); sign != std::string::npos)
          OfferFiles(kind, before + value.substr(0, sign + 1));
        return;
      case Offers::kScenarios:
        OfferScenarios(before);
        return OfferFiles(kind, before);
      case Offers::kLessons:
        return OfferLessons();
      case Offers::kCommands:
        return OfferCommands();
      case Offers::kWords:
        for (const std::string& word : SplitAtBlanks(kind.words)) Offer(before + word);
        return;
      case Offers::kList:
        return OfferList(kind, before, value);
    }
  }

  void OfferBehind(const std::string& before) {
    if (!before.empty()) out_ << ":behind " << before << '\n';
  }

  void OfferFiles(const ArgumentKind& kind, const std::string& before) {
    out_ << ":files" << (kind.words.empty() ? "" : " ") << kind.words << '\n';
    OfferBehind(before);
  }

  void OfferScenarios(const std::string& before) {
    const Result<sim::DataFolders> data = FindDataFolders();
    if (!data) return;
    for (const std::string& name : sim::ListScenarios(data.value()))
      Offer(before + name, sim::DescribeScenario(name, data.value()));
  }

  void OfferList(const ArgumentKind& kind, const std::string& before, const std::string& value) {
    const std::size_t comma = value.rfind(',');
    const std::string there = comma == std::string::npos ? "" : value.substr(0, comma + 1);
    for (const std::string& word : SplitAtBlanks(kind.words))
      if (("," + there).find("," + word + ",") == std::string::npos) Offer(before + there + word);
    out_ << ":open\n";
  }

  void OfferLessons() {
    const Result<sim::DataFolders> data = FindDataFolders();
    if (!data) return;
    std::filesystem::path folder = ShippedLessons(data.value());
    std::vector<std::string> before = positionals_;
    const std::vector<std::string> courses = CoursesIn(folder);
    const bool in_course = !before.empty() && std::ranges::find(courses, before.front()) != courses.end();
    if (in_course) {
      folder /= before.front();
      before.erase(before.begin());
    }
    static const std::vector<std::string> kVerbs = {"check", "hint", "reset", "test"};
    if (before.size() > 1 || (before.size() == 1 && std::ranges::find(kVerbs, before.front()) == kVerbs.end())) return;
    Offer("next", "The first lesson that is not done");
    if (before.empty()) {
      for (const std::string& verb : kVerbs) Offer(verb);
      if (!in_course)
        for (const std::string& course : courses) Offer(course, "Another course");
    }
    for (const std::filesystem::path& lesson : LessonFolders(folder)) Offer(lesson.filename().string());
  }

  const CLI::App& program_;
  std::ostream& out_;
  std::string current_;
  const CLI::App* command_ = nullptr;
  std::vector<std::string> positionals_;
  std::set<const CLI::Option*> used_;
  const CLI::Option* waits_ = nullptr;  ///< The option whose value is completed; null: none.
};

}  // namespace

void PrintCandidates(const CLI::App& program, std::vector<std::string> words, std::ostream& out) {
  Completion(program, std::move(words), out).Print();
}

}  // namespace soarbox::app
