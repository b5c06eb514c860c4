// SPDX-License-Identifier: BSD-2-Clause
#include "language/visual_soar.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "diagnostics/number_from_chars.h"
#include "diagnostics/plain_text.h"
#include "diagnostics/read_text.h"

namespace soarbox::language {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Kind = Datamap::Kind;

constexpr std::size_t kMostVertices = 200'000;
constexpr int kDeepest = 100;

Diagnostic Problem(const fs::path& file, int line, std::string message, std::string hint = {}) {
  Diagnostic problem;
  problem.file = file.string();
  problem.line = line;
  problem.message = std::move(message);
  problem.hint = std::move(hint);
  return problem;
}

std::vector<std::string> Words(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(std::move(word));
  return words;
}

/// A path of a project: VisualSoar writes the separators of its system.
fs::path PathOf(std::string written) {
  std::ranges::replace(written, '\\', '/');
  return fs::path(written).relative_path();
}

/// "-Infinity", "2147483647"; any other word counts as no limit.
double Limit(const std::string& word) {
  double number = 0;
  const auto [end, error] = NumberFromChars(word, number);
  if (error != std::errc{} || end != word.data() + word.size())
    return word.starts_with('-') ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  return number;
}

std::optional<std::size_t> Count(const std::string& word) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return number;
}

/// Adds a file of the layout if it exists and is below the project's folder.
void AddRules(VisualSoarProject& project, const fs::path& file, int line, std::vector<Diagnostic>& problems) {
  const fs::path base = project.file.has_parent_path() ? project.file.parent_path() : fs::path(".");
  if (IsPlainFileBelow(file, std::vector<fs::path>{base})) {
    project.rules.push_back(file.lexically_normal());
    return;
  }
  Diagnostic problem =
      Problem(project.file, line, "the layout names " + file.lexically_relative(base).string() + ", which is not there",
              "remove it from the project, or bring the file back");
  problem.severity = Severity::kWarning;
  problems.push_back(std::move(problem));
}

/// Parses the datamap of a text project.
class DatamapText {
 public:
  DatamapText(const fs::path& file, const std::string& text) : file_(file), in_(text) {}

  Result<Datamap> Read() {
    std::string line;
    if (!Next(line)) return Fault("this datamap is empty");
    const std::optional<std::size_t> count = Count(line);
    if (!count || *count > kMostVertices) return Fault("expected the number of vertices here");
    std::map<std::string, std::size_t> places;
    Datamap datamap;
    for (std::size_t i = 0; i < *count; ++i) {
      if (!Next(line)) return Fault("the datamap ends after " + std::to_string(i) + " of its vertices");
      const std::vector<std::string> words = Words(line);
      if (words.size() < 2) return Fault("expected the type and the number of a vertex here");
      places[words[1]] = datamap.vertices.size();
      if (!AddVertex(datamap, words)) return Fault("there is no type of vertex " + words[0]);
    }
    if (datamap.vertices.empty()) return Fault("the datamap has no vertices");
    if (!Next(line) || !Count(line)) return Fault("expected the number of edges here");
    for (std::size_t left = *Count(line); left > 0 && Next(line); --left) {
      const std::vector<std::string> words = Words(line);
      const auto from = words.size() < 3 ? places.end() : places.find(words[0]);
      const auto to = words.size() < 3 ? places.end() : places.find(words[2]);
      if (from == places.end() || to == places.end()) return Fault("expected an edge here: number, attribute, number");
      datamap.vertices[from->second].edges.push_back({words[1], to->second});
    }
    return datamap;
  }

 private:
  bool Next(std::string& line) {
    while (std::getline(in_, line)) {
      ++line_;
      if (line.ends_with('\r')) line.pop_back();
      if (line.find_first_not_of(" \t") != std::string::npos) return true;
    }
    return false;
  }
  Diagnostic Fault(std::string message) const {
    return Problem(file_, line_, std::move(message), "save the project again with VisualSoar");
  }
  static bool AddVertex(Datamap& datamap, const std::vector<std::string>& words) {
    const std::string& type = words[0];
    const bool is_range = type == "INTEGER_RANGE" || type == "FLOAT_RANGE";
    const bool is_integer = type.starts_with("INTEGER"), is_float = type.starts_with("FLOAT");
    const Kind kind = type == "SOAR_ID"       ? Kind::kObject
                      : type == "ENUMERATION" ? Kind::kEnumeration
                      : is_integer            ? Kind::kInteger
                      : is_float              ? Kind::kFloat
                                              : Kind::kString;
    if (kind == Kind::kString && type != "STRING" && type != "FOREIGN") return false;
    Datamap::Vertex& vertex = datamap.vertices[datamap.Add(kind)];
    if (kind == Kind::kEnumeration && words.size() > 3) vertex.words.assign(words.begin() + 3, words.end());
    if (is_range && words.size() >= 4) vertex.min = Limit(words[2]), vertex.max = Limit(words[3]);
    return true;
  }

  const fs::path& file_;
  std::istringstream in_;
  int line_ = 0;
};

Result<VisualSoarProject> ReadTextProject(const fs::path& file, const std::string& text,
                                          std::vector<Diagnostic>& problems) {
  VisualSoarProject project;
  project.file = file;
  const fs::path base = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::istringstream in(text);
  std::string line;
  int number = 0;
  fs::path datamap;
  std::map<std::string, fs::path> folders;  // By the number of the node.
  while (std::getline(in, line)) {
    ++number;
    if (line.ends_with('\r')) line.pop_back();
    const std::vector<std::string> words = Words(line);
    if (words.empty() || words[0] == "VERSION") continue;
    if (words[0] == "END") break;
    if (datamap.empty()) {
      datamap = base / PathOf(line);
      continue;
    }
    if (words.size() >= 4 && words[1] == "ROOT") {
      folders[words[0]] = base / PathOf(words[3]);
      continue;
    }
    if (words.size() < 5 || !folders.contains(words[1]))
      return Problem(file, number, "expected a node of the layout here: its number, its parent's, type, name and file",
                     "save the project again with VisualSoar");
    const fs::path& parent = folders[words[1]];
    if (words[2] == "FOLDER") {
      folders[words[0]] = parent / PathOf(words[4]);
    } else if (words[2] != "LINK") {
      folders[words[0]] = words.size() > 6 ? parent / PathOf(words[5]) : parent;
      AddRules(project, parent / PathOf(words[4]), number, problems);
    }
  }
  if (datamap.empty()) return Problem(file, number, "this project names no datamap", "its second line is the .dm file");
  const std::optional<std::string> map =
      IsPlainFileBelow(datamap, std::vector<fs::path>{base}) ? ReadText(datamap) : std::optional<std::string>();
  if (!map) {
    problems.push_back(Problem(file, 2, "the datamap " + datamap.lexically_relative(base).string() + " is not there",
                               "attributes cannot be compared with it"));
    problems.back().severity = Severity::kWarning;
    return project;
  }
  Result<Datamap> read = DatamapText(datamap, *map).Read();
  if (!read) return read.error();
  project.datamap = std::move(*read);
  return project;
}

std::string TextIn(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

void ReadLayout(const Json& node, const fs::path& folder, int depth, VisualSoarProject& project,
                std::vector<Diagnostic>& problems) {
  if (!node.is_object() || depth > kDeepest) return;
  const std::string file = TextIn(node, "file"), below = TextIn(node, "folder");
  if (!file.empty()) AddRules(project, folder / PathOf(file), 0, problems);
  const auto children = node.find("children");
  if (children == node.end() || !children->is_array()) return;
  for (const Json& child : *children)
    ReadLayout(child, below.empty() ? folder : folder / PathOf(below), depth + 1, project, problems);
}

Result<Datamap> ReadDatamapJson(const fs::path& file, const Json& json) {
  const auto vertices = json.find("vertices");
  if (!json.is_object() || vertices == json.end() || !vertices->is_array())
    return Problem(file, 0, "the datamap of this project has no vertices");
  Datamap datamap;
  std::map<std::string, std::size_t> places;
  for (const Json& one : *vertices) {
    if (!one.is_object() || TextIn(one, "id").empty())
      return Problem(file, 0, "vertex " + std::to_string(datamap.vertices.size() + 1) + " of the datamap has no id");
    const std::string type = TextIn(one, "type");
    const Kind kind = type == "SOAR_ID"             ? Kind::kObject
                      : type == "ENUMERATION"       ? Kind::kEnumeration
                      : type.starts_with("INTEGER") ? Kind::kInteger
                      : type.starts_with("FLOAT")   ? Kind::kFloat
                                                    : Kind::kString;
    places[TextIn(one, "id")] = datamap.vertices.size();
    Datamap::Vertex& vertex = datamap.vertices[datamap.Add(kind)];
    if (const auto choices = one.find("choices"); choices != one.end() && choices->is_array())
      for (const Json& choice : *choices)
        if (choice.is_string()) vertex.words.push_back(choice.get<std::string>());
    if (const auto least = one.find("min"), most = one.find("max");
        (least != one.end() && least->is_number()) || (most != one.end() && most->is_number())) {
      constexpr double kAny = std::numeric_limits<double>::infinity();
      vertex.min = least != one.end() && least->is_number() ? least->get<double>() : -kAny;
      vertex.max = most != one.end() && most->is_number() ? most->get<double>() : kAny;
    }
  }
  std::size_t at = 0;
  for (const Json& one : *vertices) {
    const std::size_t from = at++;
    const auto edges = one.find("outEdges");
    if (edges == one.end() || !edges->is_array()) continue;
    for (const Json& edge : *edges) {
      const auto to = places.find(TextIn(edge, "toId"));
      if (to != places.end()) datamap.vertices[from].edges.push_back({TextIn(edge, "name"), to->second});
    }
  }
  const auto root = places.find(TextIn(json, "rootId"));
  if (root == places.end()) return Problem(file, 0, "the datamap's rootId names none of its vertices");
  datamap.root = root->second;
  return datamap;
}

Result<VisualSoarProject> ReadJsonProject(const fs::path& file, const std::string& text,
                                          std::vector<Diagnostic>& problems) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object()) return Problem(file, 1, "this project is not a JSON object");
  VisualSoarProject project;
  project.file = file;
  if (const auto layout = json.find("layout"); layout != json.end())
    ReadLayout(*layout, file.has_parent_path() ? file.parent_path() : fs::path("."), 0, project, problems);
  const auto map = json.find("datamap");
  if (map == json.end()) return project;
  Result<Datamap> read = ReadDatamapJson(file, *map);
  if (!read) return read.error();
  project.datamap = std::move(*read);
  return project;
}

}  // namespace

bool IsVisualSoarProject(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.ends_with(".vsa") || name.ends_with(".vsa.json");
}

fs::path FindVisualSoarProject(const fs::path& folder) {
  constexpr int kAbove = 4;
  std::error_code error;
  fs::path at = fs::absolute(folder.empty() ? fs::path(".") : folder, error).lexically_normal();
  for (int i = 0; i <= kAbove && !at.empty(); ++i, at = at.parent_path()) {
    std::vector<fs::path> found;
    for (fs::directory_iterator it(at, error), end; !error && it != end; it.increment(error))
      if (IsVisualSoarProject(it->path())) found.push_back(it->path());
    if (!found.empty())
      return *std::ranges::max_element(found, [](const fs::path& a, const fs::path& b) {
        return a.filename().string().ends_with(".json") < b.filename().string().ends_with(".json");
      });
    if (at == at.parent_path()) break;
  }
  return {};
}

fs::path RootOfProject(const fs::path& project) {
  std::string name = project.filename().string();
  for (const std::string_view end : {".json", ".vsa"})
    if (name.ends_with(end)) name.resize(name.size() - end.size());
  const fs::path root = project.parent_path() / (name + ".soar");
  std::error_code error;
  return fs::is_regular_file(root, error) ? root : fs::path();
}

Result<VisualSoarProject> ReadVisualSoar(const fs::path& file, std::vector<Diagnostic>& problems) {
  const std::optional<std::string> text = ReadText(file);
  if (!text) return Problem(file, 0, "this project cannot be read");
  if (std::string why = WhyNoPlainText(*text); !why.empty()) return Problem(file, 0, std::move(why));
  return file.extension() == ".json" ? ReadJsonProject(file, *text, problems) : ReadTextProject(file, *text, problems);
}

}  // namespace soarbox::language
