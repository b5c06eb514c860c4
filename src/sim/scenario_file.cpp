// SPDX-License-Identifier: BSD-2-Clause
#include "sim/scenario_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <system_error>

#include "diagnostics/plain_text.h"
#include "diagnostics/read_text.h"
#include "sim/table_reader.h"
#include "world/body_values.h"

namespace soarbox::sim {
namespace {

constexpr std::size_t kMostEntries = 10'000;
constexpr double kFarthest_m = 1e5;
constexpr std::size_t kLongestName = 100;
constexpr std::uintmax_t kLargestFile = 4 << 20;

/// The node at a dotted name in a table, or its nearest parent that is an entry.
const toml::node& EntryAt(const toml::table& table, std::string_view name) {
  const std::size_t dot = name.find('.');
  const toml::node* entry = table.get(name.substr(0, dot));
  if (entry == nullptr) return table;
  const toml::table* below = entry->as_table();
  if (dot == std::string_view::npos || below == nullptr) return *entry;
  const toml::node& found = EntryAt(*below, name.substr(dot + 1));
  return &found == below ? *entry : found;
}

/// The text of a line, counted from 1.
std::string_view LineOf(std::string_view text, int number) {
  while (number-- > 1) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
}

/// A hint for the parser's error about this line; empty if the line does not look like the syntax of another language.
std::string HintOfLine(std::string_view line, std::string_view complaint) {
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  for (const std::string_view mark : {"//", "--", ";", "/*"})
    if (line.substr(first).starts_with(mark)) return "comments start with #";
  if (complaint.find("expected '=', saw ':'") != std::string_view::npos) return "write = between a key and its value";
  if (complaint.find("escape sequence") != std::string_view::npos) return "write / between folders, not \\";
  const std::size_t sign = line.find('=');
  const std::size_t begin = line.find_first_not_of(" \t", sign == std::string_view::npos ? sign : sign + 1);
  if (begin == std::string_view::npos) return {};
  const std::string_view value = line.substr(begin);
  if (value.starts_with('(')) return "write a list in square brackets: [1, 2]";
  for (const std::string_view word : {"yes", "no", "on", "off", "True", "False", "TRUE", "FALSE"})
    if (value.starts_with(word) && (value.size() == word.size() || value.find_first_of(" \t\r#") == word.size()))
      return "write true or false";
  return {};
}

/// A hint for the parser's error.
std::string HintOf(std::string_view complaint, std::string_view line) {
  if (std::string hint = HintOfLine(line, complaint); !hint.empty()) return hint;
  constexpr std::pair<std::string_view, std::string_view> kHints[] = {
      {"could not determine value type", "put text between quotes: name = \"scout\""},
      {"expected 'nan'", "put text between quotes: name = \"scout\""},
      {"expected 'inf'", "put text between quotes: name = \"scout\""},
      {"expected 'true'", "put text between quotes: name = \"scout\""},
      {"expected 'false'", "put text between quotes: name = \"scout\""},
      {"unescaped control characters", "the text that begins in this line has no closing quote"},
      {"cannot redefine", "a key may occur once in its table; [[agent]] begins the next one"},
  };
  for (const auto& [part, hint] : kHints)
    if (complaint.find(part) != std::string_view::npos) return std::string(hint);
  return "scenario files are TOML; docs/scenarios.md shows one";
}

/// Reads tables and collects errors.
class Reader : public TableReader {
 public:
  Reader(std::string file, std::vector<Diagnostic>& problems)
      : TableReader(std::move(file), "docs/scenarios.md", problems) {}

  /// A name, which people write in rules and read in messages.
  std::string Name(const toml::table& table, std::string otherwise = {}) {
    std::string name = Text(table, "name", std::move(otherwise));
    const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7F; };
    if (std::any_of(name.begin(), name.end(), is_control))
      Problem(*table.get("name"), "this name has control characters");
    if (name.size() > kLongestName)
      Problem(*table.get("name"), "this name has " + std::to_string(name.size()) + " characters: 100 at most");
    return name;
  }

  /// [x, z] or [x, y, z]
  std::optional<world::Vec3> Point(const toml::table& table, std::string_view key, bool wants_three = false) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return std::nullopt;
    const toml::array* list = node->as_array();
    const std::size_t size = list ? list->size() : 0;
    if ((size == 2 && !wants_three) || size == 3) {
      float part[3] = {};
      bool good = true;
      for (std::size_t i = 0; i < size; ++i) {
        const auto number = list->get(i)->is_number() ? list->get(i)->value<double>() : std::nullopt;
        good &= number && std::abs(*number) <= kFarthest_m;
        part[i] = number ? static_cast<float>(*number) : 0;
      }
      if (good) return size == 2 ? world::Vec3{part[0], 0, part[1]} : world::Vec3{part[0], part[1], part[2]};
    }
    Problem(*node,
            "'" + std::string(key) + "' takes " + (wants_three ? "[width, height, length]" : "[x, z]") + " in metres");
    return std::nullopt;
  }

  std::vector<const toml::table*> Tables(const toml::table& root, std::string_view key) {
    return TableReader::Tables(root, key, kMostEntries);
  }

  /// Stores the contents of a table under dotted names.
  void Flatten(const toml::table& table, const std::string& prefix, Options& options) {
    for (const auto& [key, value] : table) FlattenValue(value, prefix + std::string(key.str()), options);
  }

 private:
  void FlattenValue(const toml::node& value, const std::string& name, Options& options) {
    if (const auto* table = value.as_table()) {
      Flatten(*table, name + ".", options);
    } else if (const auto* list = value.as_array()) {
      int index = 0;
      for (const toml::node& entry : *list) FlattenValue(entry, name + "." + std::to_string(++index), options);
    } else if (const auto text = value.value_exact<std::string>()) {
      options[name] = *text;
    } else if (value.is_boolean()) {
      options[name] = *value.value<bool>();
    } else if (value.is_number()) {
      options[name] = *value.value<double>();
    } else {
      Problem(value, "'" + name + "' takes a text, a number, true or false");
    }
  }

  std::string HintFor(std::string_view key, const std::vector<std::string_view>& known) const override {
    if (IsOfWholeScenario(key)) return std::string(kOnTop);
    std::string hint = "there are:";
    for (const std::string_view name : known) hint += " " + std::string(name);
    return hint;
  }
};

void ReadPlaces(Reader& reader, const toml::table& root, ScenarioFile& read) {
  std::set<std::string> names;
  for (const toml::table* table : reader.Tables(root, "waypoint")) {
    reader.CheckKeys(*table, "a waypoint", {"name", "position"});
    Waypoint& made = read.waypoints.emplace_back();
    made.name = reader.Name(*table, "waypoint-" + std::to_string(read.waypoints.size()));
    const auto position = reader.Point(*table, "position");
    if (!position && !table->contains("position")) reader.Problem(*table, "this waypoint has no 'position'");
    made.position = position.value_or(world::Vec3{});
    if (!names.insert(made.name).second) reader.Problem(*table, "there are two waypoints named '" + made.name + "'");
  }
  names.clear();
  for (const toml::table* table : reader.Tables(root, "region")) {
    reader.CheckKeys(*table, "a region", {"name", "position", "radius", "size"});
    Region& made = read.regions.emplace_back();
    made.name = reader.Name(*table, "region-" + std::to_string(read.regions.size()));
    made.center = reader.Point(*table, "position").value_or(world::Vec3{});
    made.radius_m = static_cast<float>(reader.Number(*table, "radius", 0.1, kFarthest_m).value_or(0));
    if (const auto size = reader.Point(*table, "size")) {
      made.half_x_m = size->x / 2;
      made.half_z_m = size->z / 2;
    } else if (!table->contains("radius") && !table->contains("size")) {
      reader.Problem(*table, "this region has neither 'radius' nor 'size'");
    }
    if (!names.insert(made.name).second) reader.Problem(*table, "there are two regions named '" + made.name + "'");
  }
}

/// Reports invalid sizes, because another size would be used than the one that is written.
void CheckSize(Reader& reader, const toml::table& table, ScenarioFile::Thing& made) {
  const toml::node& at = table.contains("size") ? *table.get("size") : static_cast<const toml::node&>(table);
  const auto check = [&](const world::BodyValue& taken, float& size) {
    if (!taken.problem.empty()) reader.Problem(at, taken.problem.substr(0, taken.problem.find(':')));
    size = taken.value;
  };
  check(world::BodySize("width", made.size.x), made.size.x);
  check(world::BodySize("height", made.size.y), made.size.y);
  check(world::BodySize("length", made.size.z), made.size.z);
  if (made.shape != "column") return;
  if (made.size.x != made.size.z) reader.Problem(at, "a column is as long as it is wide");
  if (made.size.y < made.size.x) reader.Problem(at, "a column is at least as high as it is wide");
}

constexpr float kLeastItem_m = 0.1f, kMostItem_m = 1.6f;

void ReadThings(Reader& reader, const toml::table& root, ScenarioFile& read) {
  for (const bool is_item : {false, true}) {
    for (const toml::table* table : reader.Tables(root, is_item ? "item" : "obstacle")) {
      if (is_item) {
        reader.CheckKeys(*table, "an item", {"name", "position", "size", "gives", "amount", "material"});
      } else {
        reader.CheckKeys(*table, "an obstacle", {"name", "shape", "position", "size", "heading", "mass", "material"});
      }
      ScenarioFile::Thing& made = read.things.emplace_back();
      made.is_item = is_item;
      made.name = reader.Name(*table);
      made.position = reader.Point(*table, "position").value_or(world::Vec3{});
      made.material = reader.Text(*table, "material");
      if (is_item) {
        made.size = reader.Point(*table, "size", true).value_or(world::Vec3{0.4f, 0.4f, 0.4f});
        const auto [least, most] = std::minmax({made.size.x, made.size.y, made.size.z});
        if (least < kLeastItem_m || most > kMostItem_m)
          reader.Problem(*table->get("size"), "the sides of an item are 0.1 to 1.6 m: agents carry nothing larger");
        made.gives = reader.Text(*table, "gives");
        if (!made.gives.empty() && made.gives != "ammunition" && made.gives != "health")
          reader.Problem(*table->get("gives"), "an item gives \"ammunition\" or \"health\"");
        made.amount = static_cast<float>(reader.Number(*table, "amount", 0, 10000).value_or(0));
        if (made.material.empty()) made.material = MaterialOfThing(made.name, made.gives, true);
        continue;
      }
      if (made.material.empty()) made.material = MaterialOfThing(made.name, {}, false);
      made.shape = reader.Text(*table, "shape", "box");
      if (made.shape != "box" && made.shape != "column")
        reader.Problem(*table->get("shape"), "an obstacle's shape is \"box\" or \"column\"");
      made.size = reader.Point(*table, "size", true).value_or(world::Vec3{1, 2, 1});
      CheckSize(reader, *table, made);
      made.heading_deg = static_cast<float>(reader.Number(*table, "heading", -360, 360).value_or(0));
      made.mass_kg = static_cast<float>(reader.Number(*table, "mass", 0, 1e6).value_or(0));
    }
  }
}

/// The name of an agent without its number. Without a name, the agent is named after its rules.
std::string NameOf(const ScenarioFile::Agent& agent) {
  if (!agent.name.empty()) return agent.name;
  const std::string rules = agent.rules == kGivenRules ? std::string() : agent.rules;
  return rules.empty() ? "agent" : std::filesystem::path(rules).stem().string();
}

/// A leader must be created before its followers.
void CheckLeader(Reader& reader, const toml::table& table, const ScenarioFile::Agent& agent,
                 const std::set<std::string>& above) {
  const toml::node* node = table.get("leader");
  const auto leader = node == nullptr ? std::nullopt : node->value_exact<std::string>();
  if (!leader || leader->empty() || above.contains(*leader)) return;
  const std::string_view near = Suggest(*leader, {above.begin(), above.end()});
  reader.Problem(*node, "the leader of " + NameOf(agent) + ", '" + *leader + "', is not above it in this file",
                 near.empty() ? "a leader's [[agent]] comes before those of the agents that follow it"
                              : "did you mean '" + std::string(near) + "'?");
}

void ReadAgents(Reader& reader, const toml::table& root, ScenarioFile& read) {
  std::vector<BodyKind> kinds(BodyKinds().begin(), BodyKinds().end());
  const auto check = [&](const toml::node& at, const Result<bool>& set, const std::string& name) {
    if (!set) reader.Problem(at, set.error().message, set.error().hint);
    if (set && !set.value()) reader.Problem(at, "a body has no '" + name + "'", "docs/scenarios.md lists the options");
  };
  for (const toml::table* table : reader.Tables(root, "body")) {
    const std::string base = reader.Text(*table, "like", kinds.front().name);
    const auto like = std::find_if(kinds.begin(), kinds.end(), [&](const BodyKind& kind) { return kind.name == base; });
    if (like == kinds.end()) reader.Problem(*table->get("like"), "there is no body '" + base + "'");
    BodyKind made = like == kinds.end() ? kinds.front() : *like;
    made.name = reader.Name(*table);
    made.meaning = reader.Text(*table, "meaning");
    if (made.name.empty()) reader.Problem(*table, "this body has no 'name'");
    Options options;
    reader.Flatten(*table, {}, options);
    for (const auto& [name, value] : options) {
      if (name != "name" && name != "like" && name != "meaning")
        check(EntryAt(*table, name), SetBodyProperty(made, name, value), name);
    }
    kinds.push_back(made);
    read.bodies.push_back(std::move(made));
  }
  std::size_t total = 0;
  std::set<std::string> above;
  for (const toml::table* table : reader.Tables(root, "agent")) {
    ScenarioFile::Agent& made = read.agents.emplace_back();
    made.line = static_cast<int>(table->source().begin.line);
    made.name = reader.Name(*table);
    made.rules = reader.Text(*table, "rules");
    made.count = reader.WholeNumber(*table, "count", 1, static_cast<int>(kMostEntries)).value_or(1);
    made.across = reader.WholeNumber(*table, "across", 1, 1000).value_or(made.across);
    reader.Flatten(*table, {}, made.options);
    if (const toml::node* rules = table->get("rules"))
      made.line_of_rules = static_cast<int>(rules->source().begin.line);
    // A table in place of a text or a number is reported as such, regardless of its contents.
    std::erase_if(made.options, [](const auto& option) {
      const std::string key = option.first.substr(0, option.first.find('.'));
      return key == "rules" || key == "count" || key == "across";
    });
    std::vector<OptionProblem> wrong;
    ReadAgentOptions(made.options, kinds, wrong);
    for (const OptionProblem& each : wrong)
      reader.Problem(EntryAt(*table, each.option), each.problem.message, each.problem.hint);
    total += static_cast<std::size_t>(made.count);
    CheckLeader(reader, *table, made, above);
    const std::string name = NameOf(made);
    for (int i = 1; i <= made.count; ++i) above.insert(made.count > 1 ? name + "-" + std::to_string(i) : name);
    above.insert(name + "-2");  // A second agent of the same name gets a number.
  }
  if (total > kMostEntries) reader.Problem(root, "these are too many agents");
}

/// The names that conditions can refer to.
struct Names {
  std::set<std::string> agents, teams, regions, items;
};

Names NamesIn(const ScenarioFile& read) {
  Names names;
  for (const ScenarioFile::Agent& agent : read.agents) {
    const std::string name = NameOf(agent);
    for (int i = 1; i <= agent.count; ++i) names.agents.insert(agent.count > 1 ? name + "-" + std::to_string(i) : name);
    // A second agent of the same name gets a number.
    names.agents.insert(name + "-2");
    const auto team = agent.options.find("team");
    const auto* word = team == agent.options.end() ? nullptr : std::get_if<std::string>(&team->second);
    if (word != nullptr) names.teams.insert(*word);
  }
  for (const Region& region : read.regions) names.regions.insert(region.name);
  for (const ScenarioFile::Thing& thing : read.things)
    if (thing.is_item) names.items.insert(thing.name);
  return names;
}

class ConditionReader {
 public:
  ConditionReader(Reader& reader, const Names& names) : reader_(reader), names_(names) {}

  ScenarioFile::Condition Read(const toml::table& table, std::string_view what, bool is_part) {
    std::vector<std::string_view> keys = {"after", "team_down", "agent", "region", "carries", "item", "dead"};
    if (!is_part) keys.insert(keys.end(), {"name", "all"});
    reader_.CheckKeys(table, what, keys);
    ScenarioFile::Condition made;
    made.after_s = reader_.Number(table, "after", 0, 1e6);
    made.team_down = Known(table, "team_down", "team", names_.teams);
    made.dead = Known(table, "dead", "agent", names_.agents);
    made.agent = Known(table, "agent", "agent", names_.agents);
    made.region = Known(table, "region", "region", names_.regions);
    made.carries = Known(table, "carries", "item", names_.items);
    made.item = Known(table, "item", "item", names_.items);
    const bool has_agent = !made.agent.empty(), has_item = !made.item.empty();
    if (has_agent && made.region.empty() && made.carries.empty())
      reader_.Problem(table, "'agent' needs 'region' (it is there) or 'carries' (it has that item)");
    if (!has_agent && !made.carries.empty()) reader_.Problem(table, "'carries' needs 'agent': who carries it");
    if (has_item && made.region.empty()) reader_.Problem(table, "'item' needs 'region': where it lies");
    if (!made.region.empty() && !has_agent && !has_item)
      reader_.Problem(table,
                      "'agent' and 'region' belong together: the agent is in the region; so do 'item' and 'region'");
    if (!is_part)
      for (const toml::table* part : reader_.Tables(table, "all"))
        made.all.push_back(Read(*part, "a part of 'all'", true));
    if (!made.after_s && made.team_down.empty() && !has_agent && !has_item && made.dead.empty() && made.all.empty())
      reader_.Problem(table,
                      "nothing says when: write 'after', 'team_down', 'dead', 'agent' with 'region' or 'carries', "
                      "'item' with 'region', or 'all' with several of them");
    return made;
  }

 private:
  /// A name that must exist in the scenario.
  std::string Known(const toml::table& table, std::string_view key, std::string_view kind,
                    const std::set<std::string>& names) {
    std::string name = reader_.Text(table, key);
    if (name.empty() || names.contains(name)) return name;
    const std::string_view near = Suggest(name, {names.begin(), names.end()});
    std::string hint = near.empty() ? std::string() : "did you mean '" + std::string(near) + "'?";
    if (near.empty() && !names.empty() && names.size() < 10) {
      for (const std::string& one : names) hint += (hint.empty() ? "there are: " : ", ") + one;
    }
    reader_.Problem(*table.get(key), "there is no " + std::string(kind) + " '" + name + "'", hint);
    return name;
  }

  Reader& reader_;
  const Names& names_;
};

void ReadConditions(Reader& reader, const toml::table& root, ScenarioFile& read) {
  const Names names = NamesIn(read);
  ConditionReader conditions(reader, names);
  for (const bool ends : {true, false}) {
    for (const toml::table* table : reader.Tables(root, ends ? "end" : "goal")) {
      ScenarioFile::Condition made = conditions.Read(*table, ends ? "an end" : "a goal", false);
      made.ends = ends;
      made.name = reader.Name(*table, "the end");
      read.conditions.push_back(std::move(made));
    }
  }
}

}  // namespace

ScenarioFile ParseScenarioFile(std::string_view text, const std::filesystem::path& file,
                               std::vector<Diagnostic>& problems) {
  const auto before = static_cast<std::ptrdiff_t>(problems.size());
  ScenarioFile read;
  read.file = file;
  if (const std::string why = WhyNoPlainText(text); !why.empty()) {
    Diagnostic& problem = problems.emplace_back();
    problem.file = file.string();
    problem.message = why;
    return read;
  }
  toml::table root;
  try {
    root = toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    Diagnostic problem;
    problem.file = file.string();
    problem.line = static_cast<int>(error.source().begin.line);
    problem.column = static_cast<int>(error.source().begin.column);
    problem.message = error.description();
    problem.hint = HintOf(problem.message, LineOf(text, problem.line));
    problems.push_back(std::move(problem));
    return read;
  }
  Reader reader(file.string(), problems);
  reader.CheckKeys(root, "a scenario",
                   // src/mission and src/dis read the last three.
                   {"description", "script", "seed", "seconds", "turn", "waypoint", "region", "obstacle", "item",
                    "body", "agent", "end", "goal", "mission", "check", "dis"});
  read.description = reader.Text(root, "description");
  read.script = reader.Text(root, "script");
  read.has_exercise = root.contains("dis");
  if (const auto seed = reader.Number(root, "seed", 0, 9e15)) read.seed = static_cast<std::uint64_t>(*seed);
  read.seconds = reader.Number(root, "seconds", 0, 1e6);
  constexpr int kLongestTurn = 1000;
  read.turn_ticks = reader.WholeNumber(root, "turn", 1, kLongestTurn).value_or(1);
  ReadPlaces(reader, root, read);
  ReadThings(reader, root, read);
  ReadAgents(reader, root, read);
  ReadConditions(reader, root, read);
  std::stable_sort(problems.begin() + before, problems.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
  return read;
}

Result<ScenarioFile> ReadScenarioFile(const std::filesystem::path& file, std::vector<Diagnostic>* further) {
  Diagnostic refusal;
  refusal.file = file.string();
  std::error_code error;
  if (const std::uintmax_t size = std::filesystem::file_size(file, error); !error && size > kLargestFile) {
    refusal.message = "this scenario file is too large: " + std::to_string(size >> 20) + " MB";
    return refusal;
  }
  const std::optional<std::string> text = ReadText(file);
  if (!text) {
    refusal.message = "this scenario file cannot be read";
    return refusal;
  }
  std::vector<Diagnostic> problems;
  ScenarioFile read = ParseScenarioFile(*text, file, problems);
  if (problems.empty()) return read;
  if (further != nullptr) further->assign(problems.begin() + 1, problems.end());
  return problems.front();
}

std::uint64_t SeedOf(const Scenario& scenario, std::optional<std::uint64_t> asked) {
  if (!asked && !scenario.definition.empty()) {
    if (const Result<ScenarioFile> file = ReadScenarioFile(scenario.definition)) asked = file->seed;
  }
  return asked.value_or(1);
}

int TurnTicks(const Scenario& scenario) {
  if (scenario.definition.empty()) return 1;
  const Result<ScenarioFile> file = ReadScenarioFile(scenario.definition);
  return file ? file->turn_ticks : 1;
}

}  // namespace soarbox::sim
