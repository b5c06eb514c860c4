// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/plan.h"

#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <system_error>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "mission/read_mission.h"
#include "mission/scenario_names.h"
#include "record/header.h"
#include "sim/replaced_rules.h"
#include "sim/scenario_file.h"
#include "sweep/rows.h"

namespace soarbox::sweep {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFolder = 64 << 20;

class Digest {
 public:
  void Add(std::string_view text) {
    for (const char c : text) value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    value_ = (value_ ^ text.size()) * 0x100000001b3u;
  }
  std::string Text() const {
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value_));
    return text;
  }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

Result<void> Write(const fs::path& file, std::string_view text) {
  if ((std::ofstream(file, std::ios::binary) << text).flush()) return {};
  return ProblemIn(file, "this file cannot be written", "is the disk full, or the folder not yours?");
}

/// The first table of this name, or the second for "NAME-2", as in the world; null if there is none.
toml::node* Named(toml::array& list, std::string_view name) {
  std::map<std::string_view, int> count;
  toml::node* found = nullptr;
  for (toml::node& entry : list) {
    const toml::table* table = entry.as_table();
    const std::string_view own = table != nullptr ? (*table)["name"].value_or(std::string_view()) : std::string_view();
    if (own.empty()) continue;
    const int number = ++count[own];
    if (number == 1 && own == name) return &entry;
    if (number > 1 && found == nullptr && std::string(own) + "-" + std::to_string(number) == name) found = &entry;
  }
  return found;
}

/// Sets a value of a scenario by its path, "agent.scout.senses.sight". Entries of [[agent]] are identified by their
/// names.
bool Set(toml::table& root, std::string_view path, const toml::node& value) {
  toml::node* at = &root;
  while (true) {
    const std::size_t dot = path.find('.');
    const std::string part(path.substr(0, dot));
    if (toml::array* list = at->as_array()) {
      toml::node* found = Named(*list, part);
      if (found == nullptr || dot == std::string_view::npos) return false;
      at = found;
    } else if (toml::table* table = at->as_table()) {
      if (dot == std::string_view::npos) {
        value.visit([&](const auto& concrete) { table->insert_or_assign(part, concrete); });
        return true;
      }
      if (!table->contains(part)) table->insert(part, toml::table{});
      at = table->get(part);
    } else {
      return false;
    }
    path.remove_prefix(dot + 1);
  }
}

/// The path of replacement rules in the copy: their own name, unless it is already in use.
fs::path PlaceForRules(const fs::path& folder, const fs::path& file) {
  const std::optional<std::string> text = ReadText(file);
  fs::path to = folder / file.filename();
  for (int n = 2; fs::exists(to) && ReadText(to) != text; ++n)
    to = folder / (file.stem().string() + "-" + std::to_string(n) + file.extension().string());
  return to;
}

/// Rules that consist of several files have them in a folder of the same name, as Soar's editors create it. Copies this
/// folder, too.
Result<void> CopyProject(const fs::path& file, const fs::path& folder) {
  const fs::path from = file.parent_path() / file.stem(), to = folder / file.stem();
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(from, error))) return {};
  std::uintmax_t bytes = 0;
  for (fs::recursive_directory_iterator it(from, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() != ".soar" || !IsPlainFileBelow(it->path(), {&from, 1})) continue;
    std::error_code failed;
    const fs::path target = to / fs::relative(it->path(), from, failed);
    bytes += it->file_size(failed);
    if (bytes > kLargestFolder) return ProblemIn(from, "this folder is too large to copy for each variant");
    fs::create_directories(target.parent_path(), failed);
    fs::copy_file(it->path(), target, fs::copy_options::overwrite_existing, failed);
    if (failed) return ProblemIn(target, "this file cannot be written: " + failed.message());
  }
  return {};
}

/// Applies the variant's changes to the copy of a scenario file.
Result<void> Change(const fs::path& definition, const Variant& variant, const Spec& spec) {
  if (variant.rules.empty() && variant.parameters.empty() && variant.setup.empty()) return {};
  const bool is_file = definition.extension() == ".toml";
  const auto refuse = [&](std::string message, std::string hint) {
    Diagnostic problem = ProblemIn(spec.file, "variant '" + variant.name + "': " + std::move(message), std::move(hint));
    problem.line = variant.line;
    return problem;
  };
  const fs::path folder = definition.parent_path();
  std::error_code error;
  std::map<std::string, std::string> of_agents;
  for (const auto& [who, file] : variant.rules) {
    const bool is_rules = who.ends_with(".soar");
    const fs::path to = is_rules ? sim::FindInFolders(who, {folder}) : PlaceForRules(folder, file);
    if (to.empty())
      return refuse("the scenario has no rules '" + who + "'", "name an agent, or a file of rules in its folder");
    const fs::path beside = spec.file.has_parent_path() ? spec.file.parent_path() : fs::path(".");
    if (!IsPlainFileBelow(file, {&beside, 1})) return refuse("'" + file + "' is not a file beside the sweep", {});
    fs::copy_file(file, to, fs::copy_options::overwrite_existing, error);
    if (error) return refuse("'" + file + "' cannot be copied: " + error.message(), {});
    if (is_rules) continue;
    of_agents[who] = to.filename().string();
    if (const Result<void> copied = CopyProject(file, folder); !copied) return copied;
  }
  if (!is_file) {
    if (of_agents.empty() && variant.parameters.empty() && variant.setup.empty()) return {};
    return refuse("a scenario made by a script takes other files of rules only",
                  "write rules = { \"file.soar\" = \"other.soar\" }");
  }
  toml::table root = toml::parse(ReadText(definition).value_or(""), definition.string());
  for (const auto& [agent, file] : of_agents)
    if (!Set(root, "agent." + agent + ".rules", toml::value<std::string>(file)))
      return refuse("there is no agent '" + agent + "'", "rules = { AGENT = FILE } names an [[agent]] of the scenario");
  for (const auto& [path, text] : variant.parameters) {
    const toml::table value = toml::parse("value = " + text);
    if (!Set(root, path, *value.get("value")))
      return refuse("there is no parameter '" + path + "'",
                    "\"agent.NAME.senses.sight\" and \"seconds\" are such paths");
  }
  if (!variant.setup.empty()) {
    std::string lines;
    for (const std::string& line : variant.setup) lines += line + "\n";
    std::map<std::string, bool> done;
    if (toml::array* agents = root["agent"].as_array()) {
      for (toml::node& entry : *agents) {
        const std::string rules =
            entry.as_table() != nullptr ? (*entry.as_table())["rules"].value_or(std::string()) : std::string();
        if (rules.empty() || done[rules]) continue;
        done[rules] = true;
        // A scenario can name files anywhere; only files in its copy are changed.
        const fs::path file = sim::FindInFolders(rules, {folder});
        if (file.empty())
          return refuse("its rules '" + rules + "' are not in the scenario's folder",
                        "'setup' takes rules that are in it");
        if (const Result<void> written = Write(file, lines + ReadText(file).value_or("")); !written) return written;
      }
    }
  }
  std::ostringstream out;
  out << root << '\n';
  std::vector<Diagnostic> problems;
  (void)sim::ParseScenarioFile(out.str(), definition, problems);
  if (!problems.empty()) return refuse(problems.front().message, problems.front().hint);
  return Write(definition, out.str());
}

/// Whether an entry of a folder belongs to the scenario. Hidden entries, builds, sweeps and recordings do not.
bool BelongsToScenario(const fs::path& entry) {
  const std::string name = entry.filename().string();
  std::error_code error;
  return !name.starts_with('.') && !name.ends_with(".sweep") && !name.ends_with(".soarrec") && name != "build" &&
         !fs::exists(entry / "sweep.id", error);
}

/// Copies the scenario's folder. Targets of links are copied only if they are in the folder, too. Pipes and devices are
/// skipped.
Result<fs::path> CopyOf(const sim::Scenario& scenario, const fs::path& folder) {
  const fs::path file = scenario.definition.empty() ? scenario.script : scenario.definition;
  const fs::path from = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return ProblemIn(folder, "this folder cannot be made: " + error.message());
  std::uintmax_t bytes = 0;
  // Skips sweeps in the scenario's folder, including the folder of this sweep.
  const std::string inside = fs::weakly_canonical(folder, error).string();
  for (fs::recursive_directory_iterator it(from, error), end; !error && it != end; it.increment(error)) {
    std::error_code unknown;
    const std::string place = fs::weakly_canonical(it->path(), unknown).string() + "/";
    if (!BelongsToScenario(it->path()) || inside.starts_with(place)) {
      it.disable_recursion_pending();
      continue;
    }
    const fs::path target = folder / fs::relative(it->path(), from, unknown);
    std::error_code failed;
    if (!it->is_symlink(unknown) && it->is_directory(unknown)) {
      fs::create_directories(target, failed);
    } else if (IsPlainFileBelow(it->path(), {&from, 1})) {
      bytes += it->file_size(unknown);
      if (bytes > kLargestFolder)
        return ProblemIn(from, "this scenario's folder is too large to copy for each variant");
      fs::copy_file(it->path(), target, fs::copy_options::overwrite_existing, failed);
    }
    if (failed) return ProblemIn(target, "this file cannot be written: " + failed.message());
  }
  if (error) return ProblemIn(from, "this folder cannot be read: " + error.message());
  return folder / file.filename();
}

/// Refuses a folder that contains links, pipes or devices. A sweep's folder and file may come from an untrusted author.
/// Nothing may be written, removed or read through such files.
Result<void> RefuseLinks(const fs::path& folder) {
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const fs::file_type type = it->symlink_status(error).type();
    if (type == fs::file_type::regular || type == fs::file_type::directory) continue;
    return ProblemIn(it->path(), "a sweep's folder may contain only plain files, and this is not one",
                     "remove it, or name another folder with --folder");
  }
  if (error && fs::exists(folder, error)) return ProblemIn(folder, "this folder cannot be read");
  return {};
}

/// Whether a text contains the name of a file, so that a run may read it.
bool Names(std::string_view text, const fs::path& file) {
  return text.find(file.filename().string()) != std::string_view::npos;
}

/// Keeps those rules and scripts that a run of the scenario may read: all scripts, and the rules that the scenario, a
/// script or other such rules name. A script that builds names of rules may read all of them.
void KeepWhatIsUsed(const fs::path& scenario, std::map<fs::path, std::string>& files) {
  std::vector<std::string> texts = {ReadText(scenario).value_or("")};
  for (const auto& [file, text] : files) {
    if (file.extension() != ".lua") continue;
    if (text.find(".soar") != std::string::npos && text.find("..") != std::string::npos) return;
    texts.push_back(text);
  }
  std::map<fs::path, std::string> used;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (const auto& [file, text] : files) {
      const bool is_script = file.extension() == ".lua";
      if (used.contains(file) || (!is_script && file != scenario && !Names(texts[i], file))) continue;
      used[file] = text;
      if (!is_script) texts.push_back(text);
    }
  }
  files = std::move(used);
}

/// Adds the files on which a run of a scenario depends: its own file, scripts below its folder, and the rules that it
/// uses. Other files there can change: pages, pictures, other sweeps and the rules of other variants.
void AddFolder(const fs::path& folder, const fs::path& scenario, Digest& digest) {
  std::map<fs::path, std::string> files;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const fs::path kind = it->path().extension();
    if (it->is_regular_file(error) && (kind == ".soar" || kind == ".lua" || it->path() == folder / scenario))
      files[it->path()] = ReadText(it->path()).value_or("");
  }
  KeepWhatIsUsed(folder / scenario, files);
  for (const auto& [file, text] : files) {
    digest.Add(fs::relative(file, folder, error).string());
    digest.Add(text);
  }
}

std::string DigestOfFolder(const fs::path& folder, const fs::path& scenario) {
  Digest digest;
  AddFolder(folder, scenario, digest);
  return digest.Text();
}

/// Whether a row's key (KeyOf) belongs to this variant, with any digest.
bool IsOf(std::string_view key, const std::string& variant) {
  const std::size_t begin = key.find('/'), end = key.rfind('/');
  return begin != std::string_view::npos && begin < end && key.substr(begin + 1, end - begin - 1) == variant;
}

/// Whether the sweep's folder contains a run of this variant.
bool HasRows(const fs::path& folder, const std::string& variant) {
  std::vector<Diagnostic> ignored;
  const std::map<std::string, Row> rows = ReadRows(folder / "parts", ignored);
  return std::ranges::any_of(rows, [&](const auto& row) { return IsOf(row.first, variant); });
}

/// The folder of a variant's files. They are first written completely to a temporary folder, so that an interrupted
/// sweep starts again. Existing files must be the same, unless no run has used them.
Result<fs::path> PlaceOf(const Variant& variant, const Spec& spec, const fs::path& folder, const sim::DataFolders& data,
                         Sources sources) {
  std::error_code error;
  const fs::path place = folder / "variants" / variant.name;
  if (sources == Sources::kTrust && fs::exists(place, error)) return place;
  std::string argument = variant.scenario.empty() ? spec.scenario : variant.scenario;
  if (fs::path beside = spec.file.parent_path() / argument; fs::exists(beside, error)) argument = beside.string();
  const Result<sim::Scenario> original = sim::FindScenario(argument, data);
  if (!original) return ProblemIn(spec.file, original.error().message, original.error().hint);
  if (!original->rules.empty())
    return ProblemIn(spec.file, "a sweep needs a scenario, not a file of rules", "soarbox new writes one");
  const fs::path making = folder / "variants" / ("." + variant.name);
  fs::remove_all(making, error);
  const Result<fs::path> copied = CopyOf(*original, making);
  if (!copied) return copied.error();
  if (const Result<void> changed = Change(*copied, variant, spec); !changed) return changed.error();
  if (!fs::exists(place, error)) {
    fs::rename(making, place, error);
    if (error) return ProblemIn(place, "this folder cannot be made: " + error.message());
    return place;
  }
  const fs::path scenario = copied->filename();
  if (DigestOfFolder(making, scenario) == DigestOfFolder(place, scenario)) {
    fs::remove_all(making, error);
    return place;
  }
  // No run of it exists, so it can be replaced.
  if (!HasRows(folder, variant.name)) {
    fs::remove_all(place, error);
    fs::rename(making, place, error);
    if (error) return ProblemIn(place, "this folder cannot be made: " + error.message());
    return place;
  }
  fs::remove_all(making, error);
  return ProblemIn(
      place, "variant '" + variant.name + "' has changed since this sweep began: its scenario, rules or parameters",
      "give the changed variant another name, or name another folder with --folder");
}

/// The scenario file of the copy.
fs::path ScenarioFileIn(const fs::path& place, const Variant& variant, const Spec& spec) {
  std::error_code error;
  const fs::path named = fs::path(variant.scenario.empty() ? spec.scenario : variant.scenario).filename();
  for (const fs::path& file : {named, fs::path("scenario.toml"), fs::path("Sandbox.lua")})
    if (!file.empty() && fs::is_regular_file(place / file, error)) return place / file;
  return place;
}

}  // namespace

Result<Plan> MakePlan(const Spec& spec, const fs::path& folder, const sim::DataFolders& data, Sources sources,
                      const std::vector<std::string>& rules) {
  if (const Result<void> plain = RefuseLinks(folder); !plain) return plain.error();
  Plan plan;
  for (const Variant& variant : spec.variants) {
    const Result<fs::path> place = PlaceOf(variant, spec, folder, data, sources);
    if (!place) return place.error();
    ReadyVariant ready;
    ready.variant = variant;
    ready.argument = ScenarioFileIn(*place, variant, spec).string();
    Result<sim::Scenario> scenario = sim::FindScenario(ready.argument, data);
    if (!scenario) return scenario.error();
    if (const Result<void> replaced = sim::ReplaceRules(*scenario, rules); !replaced) return replaced.error();
    ready.loaded.scenario = std::move(*scenario);
    ready.loaded.mission = spec.mission;
    ready.loaded.mission.name = variant.name;
    ready.loaded.seconds = spec.mission.seconds.value_or(60);
    if (!ready.loaded.scenario.definition.empty()) {
      const Result<sim::ScenarioFile> read = sim::ReadScenarioFile(ready.loaded.scenario.definition);
      if (!read) return read.error();
      if (!spec.mission.seconds) ready.loaded.seconds = read->seconds.value_or(60);
      std::vector<Diagnostic> problems;
      const mission::Cast cast = mission::CastOf(*read);
      mission::CheckNames(spec.mission, cast, problems);
      mission::Mission asked;
      for (const Metric& metric : spec.metrics) {
        asked.checks.push_back(metric.asked);
        asked.checks.back().file = spec.file.string();
      }
      mission::CheckNames(asked, cast, problems);
      if (!problems.empty()) return problems.front();
    }
    std::vector<Diagnostic> late;
    mission::CheckTimes(spec.mission, ready.loaded.seconds, late);
    if (!late.empty()) return late.front();
    Digest digest;
    digest.Add(variant.kernel);
    digest.Add(std::to_string(ready.loaded.seconds));
    digest.Add(spec.judgement);
    for (const auto& [agent, file] : ready.loaded.scenario.replaced_rules) {
      digest.Add(agent);
      digest.Add(ReadText(file).value_or(""));
    }
    AddFolder(*place, fs::path(ready.argument).filename(), digest);
    ready.digest = digest.Text();
    plan.variants.push_back(std::move(ready));
  }
  return plan;
}

fs::path KeptSpec(const fs::path& folder) {
  return folder / "sweep.toml";
}

Result<void> ClaimFolder(const Spec& spec, const Plan& plan, const fs::path& folder, bool mix) {
  const fs::path file = folder / "sweep.id";
  const std::string build = record::BuildId();
  // The file has the build, then a line for each variant with its digest and name.
  std::istringstream known(ReadText(file).value_or(""));
  std::string known_build;
  std::getline(known, known_build);
  std::map<std::string, std::string> digests;
  for (std::string line; std::getline(known, line);)
    if (line.size() > 17) digests[line.substr(17)] = line.substr(0, 16);
  if (!known_build.empty() && known_build != build && !mix) {
    return ProblemIn(folder,
                     "the runs in this folder were made by another build of the program, which may behave differently",
                     "--mix continues anyway; --folder names a new one");
  }
  std::size_t differing = 0;
  for (const ReadyVariant& variant : plan.variants) {
    const auto [at, is_new] = digests.try_emplace(variant.variant.name, variant.digest);
    if (is_new || at->second == variant.digest) continue;
    if (HasRows(folder, variant.variant.name)) {
      ++differing;
    } else {
      at->second = variant.digest;
    }
  }
  if (differing > 0) {
    return ProblemIn(folder, "this folder belongs to another sweep: its scenario, checks, metrics or seconds differ",
                     "name another with --folder, or remove this one");
  }
  std::string text = (known_build.empty() ? build : known_build) + "\n";
  for (const auto& [name, digest] : digests) text += digest + " " + name + "\n";
  // Written to a temporary file first, because other processes of this sweep may read it.
  std::error_code error;
  for (const auto& [place, content] : {std::pair{file, text}, {KeptSpec(folder), spec.whole}}) {
    if (ReadText(place).value_or("") == content) continue;
    fs::path making = place;
    making += ".part";
    if (const Result<void> written = Write(making, content); !written) return written;
    fs::rename(making, place, error);
    if (error) return ProblemIn(place, "this file cannot be written: " + error.message());
  }
  return {};
}

}  // namespace soarbox::sweep
