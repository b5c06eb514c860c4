// SPDX-License-Identifier: BSD-2-Clause
#include "mission/read_mission.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "diagnostics/nearest_hint.h"
#include "diagnostics/plain_text.h"
#include "mission/check_sentences.h"
#include "sim/table_reader.h"

namespace soarbox::mission {
namespace {

constexpr std::size_t kMostChecks = 1000;

/// Keys of a check that are not conditions.
constexpr std::string_view kCheckWords[] = {
    "name",   "agent",   "team",     "item",  "who",    "with",   "range", "status",      "reason", "level",
    "is",     "support", "by",       "for",   "always", "never",  "from",  "to",          "after",  "before",
    "within", "until",   "whenever", "times", "hint",   "marker", "pass",  "selected_by", "count"};

class MissionReader : public sim::TableReader {
 public:
  MissionReader(std::string file, std::vector<Diagnostic>& problems)
      : TableReader(std::move(file), "docs/missions.md", problems) {}

  /// Converts a text, a number or a truth value to the word that rules would test: true to "yes".
  std::optional<std::string> Word(const toml::node& node) {
    if (const auto text = node.value_exact<std::string>()) return *text;
    if (const auto whole = node.value_exact<std::int64_t>()) return std::to_string(*whole);
    if (const auto truth = node.value_exact<bool>()) return *truth ? "yes" : "no";
    if (const auto number = node.value_exact<double>()) return NumberText(*number);
    return std::nullopt;
  }

  std::vector<std::string> Words(const toml::table& table, std::string_view key) {
    std::vector<std::string> words;
    const toml::node* node = table.get(key);
    if (node == nullptr) return words;
    if (const toml::array* list = node->as_array()) {
      for (const toml::node& entry : *list) {
        if (const auto word = entry.value_exact<std::string>()) words.push_back(*word);
      }
      if (words.empty() || words.size() != list->size())
        Problem(*node, "'" + std::string(key) + "' takes a text in quotes, or a list of them");
      return words;
    }
    if (const auto word = Word(*node); word && !node->is_boolean() && !word->empty()) {
      words.push_back(*word);
    } else {
      Problem(*node, "'" + std::string(key) + "' takes a text in quotes, or a list of them");
    }
    return words;
  }

  Bounds ReadBounds(const toml::node& node, std::string_view key, bool number_is_exact) {
    Bounds bounds;
    if (node.is_number()) {
      const double number = node.value<double>().value_or(0);
      if (!number_is_exact) {
        Problem(node, "'" + std::string(key) + "' takes bounds",
                "write { min = " + NumberText(number) + " } or { max = " + NumberText(number) + " }");
      }
      bounds.min = bounds.max = number;
      return bounds;
    }
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      Problem(node, "'" + std::string(key) + "' takes bounds: { min = 1, max = 3 }");
      return bounds;
    }
    CheckKeys(*table, "a bound", {"min", "max", "is"});
    bounds.min = Number(*table, "min", -1e12, 1e12);
    bounds.max = Number(*table, "max", -1e12, 1e12);
    if (const auto is = Number(*table, "is", -1e12, 1e12)) bounds.min = bounds.max = is;
    if (table->empty()) Problem(node, "'" + std::string(key) + "' has neither 'min' nor 'max'");
    if (bounds.min && bounds.max && *bounds.min > *bounds.max) Problem(node, "'min' is above 'max'");
    return bounds;
  }

  void ReadFrame(const toml::table& table, Mission& mission) {
    if (const toml::node* node = table.get("seeds")) {
      std::optional<std::vector<std::uint64_t>> seeds;
      if (const auto text = node->value_exact<std::string>()) {
        seeds = ParseSeeds(*text);
      } else if (const auto one = node->value_exact<std::int64_t>(); one && *one >= 0) {
        seeds = std::vector<std::uint64_t>{static_cast<std::uint64_t>(*one)};
      } else if (const toml::array* list = node->as_array()) {
        seeds.emplace();
        bool is_good = true;
        for (const toml::node& entry : *list) {
          const auto seed = entry.value_exact<std::int64_t>();
          const auto number = static_cast<std::uint64_t>(seed.value_or(0));
          is_good &= seed.has_value() && *seed >= 0;
          if (std::find(seeds->begin(), seeds->end(), number) == seeds->end()) seeds->push_back(number);
        }
        if (seeds->empty() || !is_good) seeds.reset();
      }
      if (!seeds) Problem(*node, "'seeds' takes \"1..20\" or [1, 5, 9]");
      mission.seeds = seeds.value_or(std::vector<std::uint64_t>{});
    }
    mission.pass = WholeNumber(table, "pass", 0, 1'000'000);
    if (mission.pass && !mission.seeds.empty() && static_cast<std::size_t>(*mission.pass) > mission.seeds.size())
      Problem(*table.get("pass"), "'pass' is more than there are seeds");
    mission.seconds = Number(table, "seconds", 0.1, 1e6);
    mission.wall_s = Number(table, "wall", 0.1, 1e6);
  }

  /// `earlier`: checks that these can refer to; indices continue after them.
  void ReadChecks(const toml::table& root, std::string_view key, std::vector<Check>& checks, std::size_t most_seeds,
                  const std::vector<Check>& earlier = {}) {
    const std::vector<const toml::table*> tables = Tables(root, key, kMostChecks);
    std::map<std::string, std::size_t> names;
    for (std::size_t i = 0; i < earlier.size(); ++i) names.emplace(earlier[i].name, i);
    const std::size_t first = earlier.size();
    for (const toml::table* table : tables) {
      Check& check = checks.emplace_back();
      check.file = file();
      check.line = static_cast<int>(table->source().begin.line);
      ReadCheck(*table, key == "mistake", check);
      if (check.pass && most_seeds > 0 && static_cast<std::size_t>(*check.pass) > most_seeds)
        Problem(*table->get("pass"), "'pass' is more than there are seeds");
      if (check.name.empty()) continue;
      if (!names.emplace(check.name, first + checks.size() - 1).second)
        Problem(*table, "there are two checks named '" + check.name + "'");
    }
    for (std::size_t i = 0; i < tables.size(); ++i) {
      Refer(*tables[i], "after", names, checks[i].after);
      Refer(*tables[i], "before", names, checks[i].before);
      Refer(*tables[i], "until", names, checks[i].until);
      Refer(*tables[i], "whenever", names, checks[i].whenever);
      Refer(*tables[i], "unless", names, checks[i].unless);
      for (const auto& [key_of, index] :
           {std::pair{"before", checks[i].before}, {"until", checks[i].until}, {"whenever", checks[i].whenever}})
        if (index == first + i) Problem(*tables[i]->get(key_of), "this check refers to itself");
      const std::size_t late = checks[i].after;
      if (late != kNoCheck && late >= first && checks[late - first].mode == Mode::kNever)
        Problem(*tables[i]->get("after"),
                "'" + checks[late - first].name + "' must never come true: nothing comes after it");
    }
    for (std::size_t i = 0; i < tables.size(); ++i) {
      std::size_t at = checks[i].after;
      for (std::size_t steps = 0; at != kNoCheck && at >= first && at != first + i && steps < checks.size(); ++steps)
        at = checks[at - first].after;
      if (at == first + i)
        Problem(*tables[i]->get("after"), "these checks wait for each other: 'after' goes in a circle");
    }
    // A check without a name is named after its requirement, which may contain names of others.
    Mission named;
    named.checks = earlier;
    named.checks.insert(named.checks.end(), checks.begin(), checks.end());
    for (Check& check : checks)
      if (check.name.empty()) check.name = Expectation(check, {}, named);
  }

 private:
  void Refer(const toml::table& table, std::string_view key, const std::map<std::string, std::size_t>& names,
             std::size_t& index) {
    const toml::node* node = table.get(key);
    if (node == nullptr || node->is_number()) return;
    const std::string name = Text(table, key);
    if (name.empty()) return;
    if (const auto at = names.find(name); at != names.end()) {
      index = at->second;
      return;
    }
    std::vector<std::string_view> known;
    for (const auto& [other, number] : names) known.push_back(other);
    Problem(*node, "there is no check '" + name + "'",
            NearestHint(name, known, "give the check that is meant this name"));
  }

  void ReadCheck(const toml::table& table, bool is_mistake, Check& check) {
    std::vector<std::string_view> known(std::begin(kCheckWords), std::end(kCheckWords));
    if (is_mistake) known.insert(known.end(), {"unless", "written", "unwritten"});
    for (const KeyRow& row : Keys()) known.push_back(row.name);
    CheckKeys(table, "a check", known);
    check.name = Text(table, "name");
    check.hint = Text(table, "hint");
    if (is_mistake) {
      ReadPattern(table, "written", check.written);
      ReadPattern(table, "unwritten", check.unwritten);
    }
    check.marker = Truth(table, "marker");
    check.pass = WholeNumber(table, "pass", 0, 1'000'000);
    ReadWho(table, check);
    for (const auto& [key, value] : table)
      if (const KeyRow* row = FindKey(key.str())) ReadCondition(table, *row, value, check);
    // TOML sorts keys. Conditions are reported in the order of their lines.
    std::stable_sort(check.conditions.begin(), check.conditions.end(),
                     [](const Condition& a, const Condition& b) { return a.line < b.line; });
    ReadWhen(table, check);
    ReadModifiers(table, check);
    const bool of_world = std::all_of(check.conditions.begin(), check.conditions.end(),
                                      [](const Condition& condition) { return condition.row->of_world; });
    if (check.conditions.empty() && check.written.empty()) {
      Problem(table, "this check does not say what must be true",
              "at = \"gate\", operator = \"go\": docs/missions.md lists what there is");
    } else if (!of_world && check.agents.empty() && check.team.empty() && check.item.empty()) {
      Problem(table, "this check does not name the agent, team or item it is about",
              "write agent = NAME, team = NAME or item = NAME");
    }
  }

  void ReadPattern(const toml::table& table, const std::string& word, RulePattern& pattern) {
    const toml::node* node = table.get(word);
    if (node == nullptr) return;
    const toml::table* parts = node->as_table();
    if (parts == nullptr)
      return Problem(*node, "'" + word + "' says what a rule of the learner has",
                     word + " = { tests = [\"^status complete\"], makes = [\"^closed\"] }");
    CheckKeys(*parts, "'" + word + "'", {"tests", "makes", "calls", "without"});
    pattern.tests = Words(*parts, "tests");
    pattern.makes = Words(*parts, "makes");
    pattern.calls = Words(*parts, "calls");
    pattern.without = Words(*parts, "without");
    for (const auto* clauses : {&pattern.tests, &pattern.makes, &pattern.without})
      for (const std::string& clause : *clauses)
        if (const std::string problem = ProblemOfClause(clause); !problem.empty())
          Problem(*node, "'" + clause + "' is not a clause", problem);
    if (pattern.empty()) Problem(*node, "'" + word + "' names nothing that a rule has");
  }

  void ReadWho(const toml::table& table, Check& check) {
    check.agents = Words(table, "agent");
    check.team = Text(table, "team");
    check.item = Text(table, "item");
    if ((check.agents.empty() ? 0 : 1) + (check.team.empty() ? 0 : 1) + (check.item.empty() ? 0 : 1) > 1)
      Problem(table, "a check is about agents, a team or an item: one of them");
    const toml::node* who = table.get("who");
    if (who == nullptr) return;
    if (const auto some = who->value_exact<std::int64_t>(); some && *some > 0 && *some <= 10'000) {
      check.who = Who::kSome;
      check.some = static_cast<int>(*some);
      return;
    }
    const std::string word = who->value_exact<std::string>().value_or("");
    if (word == "any") {
      check.who = Who::kAny;
    } else if (word == "together") {
      check.who = Who::kTogether;
    } else if (word != "each") {
      Problem(*who, "'who' takes \"each\", \"any\", \"together\" or a number");
    }
  }

  void ReadCondition(const toml::table& table, const KeyRow& row, const toml::node& value, Check& check) {
    Condition condition;
    condition.row = &row;
    condition.line = static_cast<int>(value.source().begin.line);
    if (row.names == Names::kNothing) {
      condition.bounds = ReadBounds(value, row.name, false);
    } else if (row.names == Names::kTruth) {
      if (!value.is_boolean()) Problem(value, "'" + std::string(row.name) + "' takes true or false");
      condition.truth = value.value_exact<bool>().value_or(true);
    } else {
      condition.words = Words(table, row.name);
    }
    if (row.key == Key::kCarried && check.item.empty())
      Problem(value, "'carried' is about an item", "write item = NAME");
    if (!check.item.empty() && row.key != Key::kCarried && row.key != Key::kAt && row.key != Key::kInside &&
        row.key != Key::kNear)
      Problem(value, "'" + std::string(row.name) + "' is about an agent, not about an item");
    const auto is_event = [](const Condition& other) { return other.row->kind == Kind::kEvent; };
    if (row.kind == Kind::kEvent && std::any_of(check.conditions.begin(), check.conditions.end(), is_event))
      Problem(value, "two events are two checks", "give each a name and join them: after = NAME, within = SECONDS");
    check.conditions.push_back(std::move(condition));
  }

  Condition* Find(Check& check, std::initializer_list<Key> keys) {
    for (Condition& condition : check.conditions)
      if (std::find(keys.begin(), keys.end(), condition.row->key) != keys.end()) return &condition;
    return nullptr;
  }

  void ReadModifiers(const toml::table& table, Check& check) {
    const auto needs = [&](std::string_view word, std::initializer_list<Key> keys, const char* what) -> Condition* {
      const toml::node* node = table.get(word);
      if (node == nullptr) return nullptr;
      Condition* condition = Find(check, keys);
      if (condition == nullptr) Problem(*node, "'" + std::string(word) + "' belongs to " + what);
      return condition;
    };
    if (Condition* condition = needs("range", {Key::kNear}, "'near'"))
      condition->bounds = ReadBounds(*table.get("range"), "range", false);
    if (Condition* condition = Find(check, {Key::kNear}); condition != nullptr && !table.contains("range"))
      Problem(table, "'near' needs a range", "write range = { max = 2 }, in metres between the centres");
    if (Condition* condition = needs("with", {Key::kCommand, Key::kMessage, Key::kOperator, Key::kImpasse},
                                     "a command, a message, an operator or an impasse")) {
      const toml::node& node = *table.get("with");
      if (const toml::table* with = node.as_table()) {
        for (const auto& [name, value] : *with) {
          const auto word = Word(value);
          if (!word) Problem(value, "'" + std::string(name.str()) + "' takes a text, a number, true or false");
          condition->with.emplace_back(std::string(name.str()), word.value_or(""));
        }
      } else {
        Problem(node, "'with' takes { NAME = VALUE }");
      }
    }
    if (Condition* condition = needs("status", {Key::kCommand, Key::kRetrieval}, "a command or a retrieval")) {
      condition->status = Text(table, "status");
      if (condition->row->key == Key::kRetrieval) {
        if (condition->status != "success" && condition->status != "failure")
          Problem(*table.get("status"), "'status' of a retrieval is \"success\" or \"failure\"");
      } else if (condition->status != "complete" && condition->status != "error" &&
                 condition->status != "interrupted" && condition->status != "said")
        Problem(*table.get("status"), "'status' is \"said\", \"complete\", \"error\" or \"interrupted\"");
      if (condition->status == "said") condition->status.clear();
    }
    if (Condition* condition = needs("reason", {Key::kCommand}, "a command")) {
      condition->reason = Text(table, "reason");
      if (condition->status.empty()) condition->status = "error";
    }
    if (Condition* condition = needs("level", {Key::kOperator}, "an operator"))
      condition->level = WholeNumber(table, "level", 1, 100);
    if (Condition* condition = needs("selected_by", {Key::kOperator}, "an operator")) {
      condition->selected_by = Text(table, "selected_by");
      if (condition->selected_by != "only" && condition->selected_by != "preference" &&
          condition->selected_by != "chance")
        Problem(*table.get("selected_by"), "'selected_by' is \"only\", \"preference\" or \"chance\"");
    }
    if (Condition* condition = needs("is", {Key::kElement}, "an element"))
      condition->is = Word(*table.get("is")).value_or("");
    if (Condition* condition = needs("count", {Key::kElement}, "an element"))
      condition->count = WholeNumber(table, "count", 2, 1000);
    if (Condition* condition = needs("support", {Key::kElement}, "an element")) {
      const std::string support = Text(table, "support");
      if (support != "i" && support != "o") Problem(*table.get("support"), "'support' is \"i\" or \"o\"");
      condition->support = support == "o" ? 'o' : 'i';
    }
  }

  void ReadWhen(const toml::table& table, Check& check) {
    constexpr double kLongest_s = 1e6;
    check.by_s = Number(table, "by", 0, kLongest_s);
    if (const auto to = Number(table, "to", 0, kLongest_s)) {
      if (check.by_s) Problem(*table.get("to"), "'by' and 'to' say the same: write one of them");
      check.by_s = to;
    }
    check.for_s = Number(table, "for", 0, kLongest_s);
    check.from_s = Number(table, "from", 0, kLongest_s);
    check.within_s = Number(table, "within", 0, kLongest_s);
    if (table.contains("after") && table.get("after")->is_number())
      check.after_s = Number(table, "after", 0, kLongest_s);
    const bool always = Truth(table, "always"), never = Truth(table, "never"), whenever = table.contains("whenever");
    if (table.contains("times")) check.times = ReadBounds(*table.get("times"), "times", true);
    if ((always ? 1 : 0) + (never ? 1 : 0) + (whenever ? 1 : 0) + (table.contains("times") ? 1 : 0) > 1)
      Problem(table, "'always', 'never', 'whenever' and 'times' exclude each other");
    if (always) check.mode = Mode::kAlways;
    if (never) check.mode = Mode::kNever;
    if (whenever) check.mode = Mode::kWhenever;
    if (table.contains("times")) check.mode = Mode::kTimes;
    if (never && table.contains("by"))
      Problem(*table.get("by"), "'never' has no 'by'", "write to = SECONDS for how long it must not");
    if (check.for_s && check.mode != Mode::kComesTrue)
      Problem(*table.get("for"), "'for' belongs to checks that come true once");
    if (whenever && !check.within_s) Problem(table, "'whenever' requires 'within'", "write within = SECONDS");
    if (check.within_s && !whenever && !table.contains("after"))
      Problem(*table.get("within"), "'within' counts from 'after': write which check it follows");
    if (table.contains("until") && !always && !never)
      Problem(*table.get("until"), "'until' is for 'always' and 'never'");
    for (const char* begin : {"from", "after"}) {
      const std::optional<double>& at_s = begin == std::string_view("from") ? check.from_s : check.after_s;
      if (at_s && check.by_s && *at_s >= *check.by_s) Problem(*table.get(begin), "this ends before it begins");
    }
    if (check.for_s && check.by_s &&
        *check.by_s - std::max(check.from_s.value_or(0), check.after_s.value_or(0)) < *check.for_s)
      Problem(*table.get("for"),
              "this cannot last for " + NumberText(*check.for_s) + " s: too little time is left for it");
    if (check.for_s && check.within_s && !whenever && *check.within_s < *check.for_s)
      Problem(*table.get("for"),
              "this cannot last for " + NumberText(*check.for_s) + " s within " + NumberText(*check.within_s) + " s");
    if (table.contains("times") && check.times.max && *check.times.max < 0)
      Problem(*table.get("times"), "nothing happens fewer than 0 times");
    for (const std::optional<double>& bound : {check.times.min, check.times.max})
      if (table.contains("times") && bound && *bound != std::floor(*bound))
        Problem(*table.get("times"), "'times' takes whole numbers");
    const bool has_event = std::ranges::any_of(
        check.conditions, [](const Condition& condition) { return condition.row->kind == Kind::kEvent; });
    const bool says_when = has_event || always || never || whenever || check.by_s || check.for_s || check.within_s ||
                           table.contains("times");
    for (const Condition& condition : check.conditions) {
      if (condition.row->kind == Kind::kGauge && !says_when && !check.marker)
        Problem(table, "'" + std::string(condition.row->name) + "' does not say when",
                "write always = true, never = true or by = SECONDS");
      if (condition.row->kind != Kind::kCounter) continue;
      if (check.conditions.size() > 1)
        Problem(table,
                "'" + std::string(condition.row->name) + "' is counted: it must be the only condition of its check");
      if (check.mode != Mode::kComesTrue || check.for_s) {
        Problem(table, "'" + std::string(condition.row->name) + "' is counted: its bounds say when it holds",
                "leave out always, never, times and for");
      }
      check.mode = Mode::kTimes;
      check.times = condition.bounds;
    }
  }
};

std::optional<toml::table> ParseToml(std::string_view text, const std::filesystem::path& file,
                                     std::vector<Diagnostic>& problems) {
  Diagnostic problem;
  problem.file = file.string();
  problem.message = WhyNoPlainText(text);
  if (problem.message.empty()) {
    try {
      return toml::parse(text, file.string());
    } catch (const toml::parse_error& error) {
      problem.line = static_cast<int>(error.source().begin.line);
      problem.column = static_cast<int>(error.source().begin.column);
      problem.message = error.description();
    }
  }
  problems.push_back(std::move(problem));
  return std::nullopt;
}

void CheckTimesOf(const Check& check, double seconds, std::vector<Diagnostic>& problems) {
  const double begin_s = std::max(check.from_s.value_or(0), check.after_s.value_or(0));
  const std::string end = "the run ends at " + NumberText(seconds) + " s";
  std::string message;
  if (begin_s > 0 && begin_s >= seconds) {
    message = "this is looked at from " + NumberText(begin_s) + " s on, and " + end;
  } else if (check.for_s.value_or(0) > seconds - begin_s) {
    message = "this cannot last for " + NumberText(*check.for_s) + " s: " + end;
  } else if (check.by_s.value_or(0) > seconds) {
    message = "this has time until " + NumberText(*check.by_s) + " s, and " + end;
  } else {
    return;
  }
  Diagnostic& problem = problems.emplace_back();
  problem.file = check.file;
  problem.line = check.line;
  problem.message = std::move(message);
  problem.hint = "seconds = N makes runs longer";
}

void SortByLine(std::vector<Diagnostic>& problems, std::size_t from) {
  std::stable_sort(problems.begin() + static_cast<std::ptrdiff_t>(from), problems.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
}

}  // namespace

Mission ParseMission(std::string_view text, const std::filesystem::path& file, bool is_scenario_file,
                     std::vector<Diagnostic>& problems) {
  const std::size_t before = problems.size();
  Mission mission;
  mission.file = file;
  const std::optional<toml::table> root = ParseToml(text, file, problems);
  if (!root) return mission;
  MissionReader reader(file.string(), problems);
  if (is_scenario_file) {
    if (const toml::node* frame = root->get("mission")) {
      if (const toml::table* table = frame->as_table()) {
        reader.CheckKeys(*table, "[mission]", {"seeds", "pass", "seconds", "wall"});
        reader.ReadFrame(*table, mission);
      } else {
        reader.Problem(*frame, "write [mission] above it");
      }
    }
  } else {
    reader.CheckKeys(*root, "a mission", {"scenario", "seeds", "pass", "seconds", "wall", "check"});
    reader.ReadFrame(*root, mission);
    mission.scenario = reader.Text(*root, "scenario");
    if (const toml::node* named = root->get("scenario"))
      mission.scenario_line = static_cast<int>(named->source().begin.line);
    if (mission.scenario.empty() && !root->contains("scenario"))
      reader.Problem(*root, "this mission names no scenario",
                     "write scenario = \".\" for the one beside it, above the first [[check]]");
  }
  reader.ReadChecks(*root, "check", mission.checks, mission.seeds.size());
  if (!is_scenario_file && mission.checks.empty()) reader.Problem(*root, "this mission has no [[check]]");
  SortByLine(problems, before);
  return mission;
}

Mission ParseChecksBeside(std::string_view text, const std::filesystem::path& file, std::vector<Diagnostic>& problems,
                          const std::string& what, const std::vector<std::string_view>& known) {
  const std::size_t before = problems.size();
  Mission mission;
  mission.file = file;
  const std::optional<toml::table> root = ParseToml(text, file, problems);
  if (!root) return mission;
  MissionReader reader(file.string(), problems);
  if (!known.empty()) reader.CheckKeys(*root, what, known);
  reader.ReadFrame(*root, mission);
  reader.ReadChecks(*root, "check", mission.checks, mission.seeds.size());
  reader.ReadChecks(*root, "mistake", mission.mistakes, 0, mission.checks);
  SortByLine(problems, before);
  return mission;
}

void CheckTimes(const Mission& mission, double seconds, std::vector<Diagnostic>& problems) {
  for (const Check& check : mission.checks) CheckTimesOf(check, seconds, problems);
  for (const Check& check : mission.mistakes) CheckTimesOf(check, seconds, problems);
}

void AddWants(std::span<const Check> checks, Wants& wants) {
  for (const Check& check : checks) {
    for (const Condition& condition : check.conditions) {
      wants.notes |= condition.row->source == Source::kNotes;
      wants.firings |= condition.row->source == Source::kFirings;
      wants.insight |= condition.row->source == Source::kInsight ||
                       (condition.row->key == Key::kOperator && !condition.with.empty());
      wants.learned |= condition.row->key == Key::kReused;
      wants.decisions |= condition.row->key == Key::kOperator || condition.row->key == Key::kImpasse;
      wants.numbers |= condition.row->key == Key::kReward || condition.row->key == Key::kUpdates ||
                       condition.row->key == Key::kValues;
      wants.retrievals |= condition.row->key == Key::kRetrieval;
      if (condition.row->key != Key::kElement) continue;
      for (const std::string& path : condition.words)
        if (std::find(wants.elements.begin(), wants.elements.end(), path) == wants.elements.end())
          wants.elements.push_back(path);
    }
  }
}

Wants WantsOf(const Mission& mission) {
  Wants wants;
  AddWants(mission.checks, wants);
  AddWants(mission.mistakes, wants);
  return wants;
}

}  // namespace soarbox::mission
