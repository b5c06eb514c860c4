// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/scene_lines.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace soarbox::kernel::imagery {
namespace {

std::vector<std::string> WordsOf(std::string_view line) {
  std::vector<std::string> words;
  std::size_t at = 0;
  const auto blank = [&](std::size_t place) { return std::isspace(static_cast<unsigned char>(line[place])) != 0; };
  while (at < line.size()) {
    while (at < line.size() && blank(at)) ++at;
    const std::size_t begin = at;
    while (at < line.size() && !blank(at)) ++at;
    if (at > begin) words.emplace_back(line.substr(begin, at - begin));
  }
  return words;
}

/// The value of a word, if it is a finite number.
std::optional<double> NumberOf(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  // Larger numbers could make products infinite.
  constexpr double kLargest = 1e60;
  if (word.empty() || *end != '\0' || !(std::abs(value) <= kLargest)) return std::nullopt;
  return value;
}

/// The modifications that may follow the names in `add` and `change`.
struct Mods {
  std::optional<Vec3> position, rotation, scale;
  std::optional<std::vector<Vec3>> points;
  std::optional<double> radius;
};

/// Parses one line.
class LineReader {
 public:
  LineReader(Scene& scene, std::string_view line) : scene_(scene), line_(line), words_(WordsOf(line)) {}

  std::optional<LineError> Apply() {
    if (words_.empty()) return std::nullopt;
    switch (words_[0][0]) {
      case 'a':
        return Add();
      case 'c':
        return Change();
      case 'd':
        return Delete();
      case 't':
        return Tag();
      default:
        return Refuse(0, "expected add, change, delete or tag as the first word");
    }
  }

 private:
  LineError Refuse(std::size_t field, std::string text) const {
    return {std::string(line_), static_cast<int>(field), std::move(text)};
  }
  bool Has(std::size_t field) const { return field < words_.size(); }
  LineError NoSuchNode(std::size_t field) const {
    return Refuse(field, "there is no node " + words_[field] + ": add it first");
  }

  std::optional<LineError> ReadVector(std::size_t& field, std::optional<Vec3>& vector) const {
    Vec3 read;
    ++field;
    for (int axis = 0; axis < 3; ++axis, ++field) {
      const std::optional<double> number = Has(field) ? NumberOf(words_[field]) : std::nullopt;
      if (!number) return Refuse(field, "expected a number: three follow p, r and s");
      read[axis] = *number;
    }
    vector = read;
    return std::nullopt;
  }

  std::optional<LineError> ReadPoints(std::size_t& field, std::optional<std::vector<Vec3>>& points) const {
    std::vector<double> numbers;
    for (++field; Has(field); ++field) {
      const std::optional<double> number = NumberOf(words_[field]);
      if (!number) break;
      numbers.push_back(*number);
    }
    if (numbers.size() % 3 != 0) return Refuse(field, "expected a number: each point after v has three");
    points.emplace();
    for (std::size_t n = 0; n < numbers.size(); n += 3) points->push_back({numbers[n], numbers[n + 1], numbers[n + 2]});
    return std::nullopt;
  }

  /// Parses modifications up to the first word that does not start one.
  std::optional<LineError> ReadMods(std::size_t field, Mods& mods) const {
    while (Has(field)) {
      std::optional<LineError> error;
      switch (words_[field][0]) {
        case 'p':
          error = ReadVector(field, mods.position);
          break;
        case 'r':
          error = ReadVector(field, mods.rotation);
          break;
        case 's':
          error = ReadVector(field, mods.scale);
          break;
        case 'v':
          error = ReadPoints(field, mods.points);
          break;
        case 'b':
          ++field;
          mods.radius = Has(field) ? NumberOf(words_[field]) : std::nullopt;
          if (!mods.radius) error = Refuse(field, "expected a radius: a number follows b");
          ++field;
          break;
        default:
          return std::nullopt;
      }
      if (error) return error;
    }
    return std::nullopt;
  }

  std::optional<LineError> Add() {
    if (!Has(1)) return Refuse(1, "expected the id of the new node");
    if (scene_.Find(words_[1]) != nullptr) {
      return Refuse(1, "there is a node " + words_[1] + " already: change it, or use another id");
    }
    if (!Has(2)) return Refuse(2, "expected the id of the parent: world, or another group");
    Node* const parent = scene_.Find(words_[2]);
    if (parent == nullptr) return NoSuchNode(2);
    if (!parent->is_group()) return Refuse(2, words_[2] + " has a shape of its own: only groups have children");
    if (parent->depth() >= Node::kDeepest) return Refuse(2, words_[2] + " is too deep below world to have children");
    Mods mods;
    if (std::optional<LineError> error = ReadMods(3, mods)) return error;
    if (mods.points && mods.radius) return Refuse(1, "give either v or b: a node has one shape");
    NodeSpec spec;
    spec.id = words_[1];
    spec.shape = mods.points ? Shape::kHull : mods.radius ? Shape::kBall : Shape::kGroup;
    if (mods.points) spec.points = std::move(*mods.points);
    spec.radius = mods.radius.value_or(0);
    spec.pose.position = mods.position.value_or(Vec3{});
    spec.pose.rotation = mods.rotation.value_or(Vec3{});
    spec.pose.scale = mods.scale.value_or(Vec3{1, 1, 1});
    scene_.Add(*parent, std::move(spec));
    return std::nullopt;
  }

  std::optional<LineError> Change() {
    if (!Has(1)) return Refuse(1, "expected the id of a node");
    Node* const node = scene_.Find(words_[1]);
    if (node == nullptr) return NoSuchNode(1);
    Mods mods;
    if (std::optional<LineError> error = ReadMods(2, mods)) return error;
    Pose pose = node->pose();
    if (mods.position) pose.position = *mods.position;
    if (mods.rotation) pose.rotation = *mods.rotation;
    if (mods.scale) pose.scale = *mods.scale;
    if (mods.position || mods.rotation || mods.scale) scene_.Move(*node, pose);
    if (mods.points && node->shape() != Shape::kHull) {
      return Refuse(1, words_[1] + " has no points: only nodes added with v have");
    }
    if (mods.radius && node->shape() != Shape::kBall) {
      return Refuse(1, words_[1] + " has no radius: only nodes added with b have");
    }
    if (mods.points) scene_.SetPoints(*node, std::move(*mods.points));
    if (mods.radius) scene_.SetRadius(*node, *mods.radius);
    return std::nullopt;
  }

  std::optional<LineError> Delete() {
    if (!Has(1)) return Refuse(1, "expected the id of a node");
    Node* const node = scene_.Find(words_[1]);
    if (node == nullptr) return NoSuchNode(1);
    if (node == &scene_.root()) {
      return Refuse(1, "world cannot be deleted: delete the nodes in it, or type svs STATE.scene.clear");
    }
    scene_.Remove(*node);
    return std::nullopt;
  }

  std::optional<LineError> Tag() {
    const std::string expected = "expected add, change or delete";
    if (!Has(1)) return Refuse(1, expected);
    const char verb = words_[1][0];
    if (!Has(2)) return Refuse(2, "expected the id of a node");
    Node* const node = scene_.Find(words_[2]);
    if (node == nullptr) return NoSuchNode(2);
    if (!Has(3)) return Refuse(3, "expected the name of a tag");
    if (verb == 'd') {
      scene_.DeleteTag(*node, words_[3]);
      return std::nullopt;
    }
    if (verb != 'a' && verb != 'c') return Refuse(1, expected);
    if (!Has(4)) return Refuse(4, "expected the value of the tag");
    scene_.SetTag(*node, words_[3], words_[4]);
    return std::nullopt;
  }

  Scene& scene_;
  std::string_view line_;
  std::vector<std::string> words_;
};

template <typename Visit>
void ForEachLine(std::string_view text, Visit visit) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    visit(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

std::string VectorText(const Vec3& vector) {
  return NumberText(vector.x) + " " + NumberText(vector.y) + " " + NumberText(vector.z);
}

std::string ListText(const std::vector<std::string>& ids) {
  std::string text = "objs " + std::to_string(ids.size());
  for (const std::string& id : ids) text += " " + id;
  return text;
}

std::string AnswerQuery(const Scene& scene, std::string_view line, const std::vector<std::string>& words) {
  const auto error = [&](int field, const char* text) {
    return "Error in F[" + std::to_string(field) + "] of line [" + std::string(line) + "]: " + text;
  };
  if (words[0] == "obj-info") {
    if (words.size() < 2) return error(2, "Expecting id argument");
    const Node* const node = scene.Find(words[1]);
    if (node == nullptr) return error(2, "Node not found");
    const Pose& pose = node->pose();
    std::string text = "o " + node->id() + " p " + VectorText(pose.position) + " r " + VectorText(pose.rotation) +
                       " s " + VectorText(pose.scale) + " t " + std::to_string(node->tags().size());
    for (const auto& [name, value] : node->tags()) text += " " + name + " " + value;
    return text;
  }
  std::vector<std::string> ids;
  if (words[0] == "list-all-objs") {
    scene.ForEach([&](const Node& node) { ids.push_back(node.id()); });
    return ListText(ids);
  }
  if (words[0] == "objs-with-flag") {
    if (words.size() < 3) return error(2, "Expecting 2 arguments");
    scene.ForEach([&](const Node& node) {
      const std::string* const value = node.Tag(words[1]);
      if (value != nullptr && *value == words[2]) ids.push_back(node.id());
    });
    return ListText(ids);
  }
  return error(1, "Unknown command");
}

}  // namespace

std::string LineError::ToString() const {
  const std::string place = field > 0 ? ", word " + std::to_string(field + 1) : "";
  return "\"" + line + "\"" + place + ": " + text;
}

std::optional<LineError> ApplyLine(Scene& scene, std::string_view line) {
  return LineReader(scene, line).Apply();
}

std::string AnswerQueries(const Scene& scene, std::string_view queries) {
  std::string answers;
  ForEachLine(queries, [&](std::string_view line) {
    const std::vector<std::string> words = WordsOf(line);
    if (!words.empty()) answers += AnswerQuery(scene, line, words) + "\n";
  });
  return answers;
}

std::string NumberText(double value) {
  char text[40];
  const auto end = std::to_chars(std::begin(text), std::end(text), value, std::chars_format::general, 6).ptr;
  return std::string(text, end);
}

}  // namespace soarbox::kernel::imagery
