// SPDX-License-Identifier: BSD-2-Clause
// Two requests of Soarbox's own: trees of a program that an editor shows beside its text.
#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "editors/file_uri.h"
#include "editors/lsp_json.h"
#include "editors/lsp_server.h"
#include "language/datamap.h"

namespace soarbox::editors {
namespace {

constexpr int kDeepest = 8;
constexpr std::size_t kMostNodes = 5000;

using language::Datamap;

std::string DetailOf(const Datamap::Vertex& vertex) {
  const bool is_bounded = vertex.min != 0 || vertex.max != 0;
  const auto bounds = [&](const char* kind) {
    if (!is_bounded) return std::string(kind);
    return std::string(kind) + " from " + Json(vertex.min).dump() + " to " + Json(vertex.max).dump();
  };
  switch (vertex.kind) {
    case Datamap::Kind::kObject:
      return {};
    case Datamap::Kind::kInteger:
      return bounds("integer");
    case Datamap::Kind::kFloat:
      return bounds("number");
    case Datamap::Kind::kString:
      return "text";
    case Datamap::Kind::kEnumeration:
      break;
  }
  std::string words;
  for (const std::string& word : vertex.words) words += (words.empty() ? "" : ", ") + word;
  return words;
}

/// The tree of the attributes below an object, with at most kDeepest levels and kMostNodes attributes. If an object is
/// below itself, its attributes are not repeated there.
class DatamapTree {
 public:
  explicit DatamapTree(const Datamap& datamap) : datamap_(datamap) {}
  Json Below(std::size_t object) {
    Json list = Json::array();
    if (object >= datamap_.vertices.size() || path_.size() >= kDeepest || !path_.insert(object).second) return list;
    std::map<std::string, std::vector<std::size_t>> edges;
    for (const Datamap::Edge& edge : datamap_.vertices[object].edges) edges[edge.attribute].push_back(edge.to);
    for (const auto& [attribute, targets] : edges)
      for (const std::size_t to : targets) {
        if (to >= datamap_.vertices.size() || ++nodes_ > kMostNodes) continue;
        list.push_back({{"name", attribute}, {"detail", DetailOf(datamap_.vertices[to])}, {"children", Below(to)}});
      }
    path_.erase(object);
    return list;
  }

 private:
  const Datamap& datamap_;
  std::set<std::size_t> path_;
  std::size_t nodes_ = 0;
};

struct OperatorNode {
  std::set<std::string> parents;
  Json rules = Json::array();
};

}  // namespace

/// Parameters: {textDocument}. Returns the operators of the file's program, each with `name`, `parents` (the operators
/// in whose substates it is proposed) and `rules` (those that propose or apply it). Two names are special: "(any)" has
/// the rules that do not name their operator, and "" the rules that neither propose nor apply one.
Json LspServer::OperatorTree(const Json& params) {
  const DocumentPtr document = DocumentOf(params);
  const language::Program program = workspace_.ProgramOf(document->path());
  std::map<std::string, OperatorNode> operators;
  for (const DocumentPtr& file : program.documents) {
    for (const language::DocumentCommand& command : file->commands()) {
      for (const explain::RuleText& rule : command.read->texts) {
        const auto add = [&](const std::string& name, const char* role) {
          OperatorNode& node = operators[name];
          node.rules.push_back({{"name", rule.name},
                                {"role", role},
                                {"location",
                                 {{"uri", UriOf(file->path())},
                                  {"range", RangeOf(file->lines(), {command.span.begin, command.span.begin})}}}});
          return &node;
        };
        for (const std::string& name : rule.proposes) {
          OperatorNode* const node = add(name.empty() ? "(any)" : name, "proposes");
          node->parents.insert(rule.works_on.begin(), rule.works_on.end());
        }
        for (const std::string& name : rule.applies)
          if (!rule.proposes.contains(name)) add(name.empty() ? "(any)" : name, "applies");
        if (rule.proposes.empty() && rule.applies.empty()) add({}, "elaborates");
      }
    }
  }
  Json list = Json::array();
  for (auto& entry : operators) {
    const std::string& name = entry.first;
    std::set<std::string>& parents = entry.second.parents;
    std::erase_if(parents, [&](const std::string& parent) { return parent == name || !operators.contains(parent); });
    list.push_back({{"name", name}, {"parents", parents}, {"rules", std::move(entry.second.rules)}});
  }
  return list;
}

/// Parameters: {textDocument}. Returns what working memory may contain, as `soarbox datamap` finds it: the attributes
/// of the top state, each with `name`, `detail` and `children`.
Json LspServer::DatamapOf(const Json& params) {
  const DocumentPtr document = DocumentOf(params);
  const language::Program program = workspace_.ProgramOf(document->path());
  std::vector<const Document*> documents;
  for (const DocumentPtr& one : program.documents) documents.push_back(one.get());
  const Datamap datamap = language::DatamapOf(documents);
  return DatamapTree(datamap).Below(datamap.root);
}

}  // namespace soarbox::editors
