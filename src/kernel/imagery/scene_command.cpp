// SPDX-License-Identifier: BSD-2-Clause
// Commands that change a scene.
#include "kernel/imagery/scene_command.h"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>

#include "diagnostics/diagnostic.h"
#include "kernel/imagery/measures.h"
#include "kernel/imagery/status_line.h"

namespace soarbox::kernel::imagery {
namespace {

class WriteCommand final : public SceneCommand {
 public:
  /// Executes the command and returns the status.
  using Verb = std::string (WriteCommand::*)();
  WriteCommand(const CommandParts& parts, Verb verb)
      : SceneCommand(parts.id), parts_(parts), verb_(verb), status_(parts.writer, parts.id) {}
  bool writes() const override { return true; }
  void Update(bool) override {
    if (done_) return;
    done_ = true;
    answer_ = (this->*verb_)();
    NoteChange();
    status_.Set(answer_);
    // Determined now, because afterwards the missing node may exist.
    if (answer_ != "success") hint_ = HintFor();
  }
  Trouble trouble() const override {
    return answer_.empty() || answer_ == "success" ? Trouble{} : Trouble{answer_, hint_};
  }
  void Mark(const std::function<void(Symbol)>& mark) const override {
    mark(parts_.id);
    if (status_.symbol()) mark(status_.symbol());
  }

  std::string AddNode() {
    Node* const parent = Parent();
    if (parent == nullptr) return "no parent group node found";
    const std::optional<std::string> id = Text("id");
    if (!id) return "no id specified";
    if (scene().Find(*id) != nullptr) return "id already exists";
    NodeSpec spec;
    spec.id = *id;
    ReadPose(spec.pose);
    const std::string geometry = Text("geometry").value_or("group");
    if (geometry == "box") {
      spec.shape = Shape::kHull;
      for (int corner = 0; corner < 8; ++corner) {
        spec.points.push_back({corner & 4 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 1 ? 0.5 : -0.5});
      }
    } else if (geometry == "point") {
      spec.shape = Shape::kHull;
      spec.points.emplace_back();
    } else if (geometry == "sphere") {
      spec.shape = Shape::kBall;
      spec.radius = 1;
    }
    Node* const node = scene().Add(*parent, std::move(spec));
    if (node == nullptr) return "error adding node to scene";
    SetTags(*node);
    return "success";
  }

  std::string CopyNode() {
    Node* const parent = Parent();
    if (parent == nullptr) return "no group node parent";
    const std::optional<std::string> source_id = Text("source");
    if (!source_id) return "must specify a source";
    const Node* const source = scene().Find(*source_id);
    if (source == nullptr) return "Could not find the given source node";
    const std::optional<std::string> id = Text("id");
    if (!id) return "^id must be specified";
    if (scene().Find(*id) != nullptr) return "Node already exists";
    NodeSpec spec;
    spec.id = *id;
    spec.shape = source->shape();
    spec.points = source->points();
    spec.radius = source->radius();
    spec.pose = source->pose();
    ReadPose(spec.pose);
    Node* const node = scene().Add(*parent, std::move(spec));
    if (node == nullptr) return "no group node parent";
    if (Is("copy_tags", {"true"})) {
      for (const auto& [name, value] : source->tags()) scene().SetTag(*node, name, value);
    }
    SetTags(*node);
    if (Is("adjust", {"true"})) ShrinkToFit(scene(), *node);
    return "success";
  }

  std::string CopyTransform() {
    const std::optional<std::string> source_id = Text("source");
    if (!source_id) return "must specify a source";
    const Node* const source = scene().Find(*source_id);
    if (source == nullptr) return "Could not find the given source node";
    const std::optional<std::string> destination_id = Text("destination");
    if (!destination_id) return "must specify a destination";
    Node* const destination = scene().Find(*destination_id);
    if (destination == nullptr) return "Could not find the given destination node";
    Pose pose = destination->pose();
    if (Is("position", {"yes", "true"})) pose.position = source->pose().position;
    if (Is("rotation", {"yes", "true"})) pose.rotation = source->pose().rotation;
    if (Is("scale", {"yes", "true"})) pose.scale = source->pose().scale;
    scene().Move(*destination, pose);
    if (Is("adjust", {"yes", "true"})) ShrinkToFit(scene(), *destination);
    return "success";
  }

  std::string DeleteNode() {
    if (!Has("id")) return "^id must be specified";
    const std::optional<std::string> id = Text("id");
    if (!id) return "^id must be a string";
    Node* const node = scene().Find(*id);
    if (node == nullptr) return "Could not find the given node";
    if (node == &scene().root()) return "the world cannot be deleted";
    scene().Remove(*node);
    return "success";
  }

  std::string SetTransform() {
    Node* node = nullptr;
    if (std::string wrong = FindNode(node); !wrong.empty()) return wrong;
    Pose pose = node->pose();
    ReadPose(pose);
    scene().Move(*node, pose);
    return "success";
  }

  std::string SetTag() { return ChangeTag(true); }
  std::string DeleteTag() { return ChangeTag(false); }

 private:
  Scene& scene() { return parts_.scene; }
  std::optional<std::string> Text(std::string_view attribute) const {
    return parts_.writer.TextOf(parts_.id, attribute);
  }
  bool Has(std::string_view attribute) const { return static_cast<bool>(parts_.writer.ValueOf(parts_.id, attribute)); }
  bool Is(std::string_view attribute, std::initializer_list<std::string_view> words) const {
    const std::optional<std::string> text = Text(attribute);
    return text && std::find(words.begin(), words.end(), *text) != words.end();
  }
  void ReadPose(Pose& pose) const {
    if (const auto vector = parts_.writer.VectorOf(parts_.id, "position")) pose.position = *vector;
    if (const auto vector = parts_.writer.VectorOf(parts_.id, "rotation")) pose.rotation = *vector;
    if (const auto vector = parts_.writer.VectorOf(parts_.id, "scale")) pose.scale = *vector;
  }
  void SetTags(Node& node) {
    const Symbol tags = parts_.writer.ValueOf(parts_.id, "tags");
    if (!tags.IsIdentifier()) return;
    Tags read;
    parts_.writer.ForEachValue(tags, [&](Symbol name, Symbol value) {
      if (name.IsString() && value.IsString()) {
        read[std::string(parts_.writer.TextOf(name))] = parts_.writer.TextOf(value);
      }
    });
    for (const auto& [name, value] : read) scene().SetTag(node, name, value);
  }
  /// The group named by ^parent, or the world.
  Node* Parent() {
    const std::optional<std::string> id = Text("parent");
    Node* const parent = id ? scene().Find(*id) : &scene().root();
    return parent != nullptr && parent->is_group() ? parent : nullptr;
  }
  /// Finds the node named by ^id. Returns an error or an empty text.
  std::string FindNode(Node*& node) {
    if (!Has("id")) return "no object id specified";
    const std::optional<std::string> id = Text("id");
    if (!id) return "object id must be a std::string";
    node = scene().Find(*id);
    return node == nullptr ? "Couldn't find node " + *id : std::string();
  }
  /// The string value of an attribute; `wrong` is set to an error or an empty text.
  std::optional<std::string> Required(std::string_view attribute, std::string_view missing, std::string& wrong) const {
    std::optional<std::string> text = Text(attribute);
    if (!text && wrong.empty()) {
      wrong = Has(attribute) ? std::string(attribute) + " must be a std::string" : std::string(missing);
    }
    return text;
  }
  std::string ChangeTag(bool sets) {
    Node* node = nullptr;
    const std::string missing_node = FindNode(node);
    std::string wrong = Text("id") ? std::string() : missing_node;
    const std::optional<std::string> name = Required("tag_name", "no tag_name specified", wrong);
    const std::optional<std::string> value = sets ? Required("tag_value", "no value specified", wrong) : std::nullopt;
    if (wrong.empty()) wrong = missing_node;
    if (!wrong.empty()) return wrong;
    if (sets) {
      scene().SetTag(*node, *name, *value);
    } else {
      scene().DeleteTag(*node, *name);
    }
    return "success";
  }

  /// A hint for the first name that no node has.
  std::string HintFor() const {
    for (const std::string_view attribute : {"id", "source", "destination", "parent"}) {
      const std::optional<std::string> name = Text(attribute);
      if (name && parts_.scene.Find(*name) == nullptr) return HintForNode(parts_.scene, *name);
    }
    return "svs commands all lists the parameters of all commands";
  }

  CommandParts parts_;
  Verb verb_;
  std::string answer_, hint_;
  StatusLine status_;
  bool done_ = false;
};

template <WriteCommand::Verb verb>
std::unique_ptr<SceneCommand> MakeWriter(const CommandParts& parts) {
  return std::make_unique<WriteCommand>(parts, verb);
}

constexpr ParameterInfo kAddNode[] = {
    {"id", "the new node's id", true},
    {"parent", "the group to put it in; world if missing"},
    {"geometry", "box, point, sphere or group", false, ParameterForm::kWord, "box point sphere group"},
    {"position", "{^x ^y ^z}", false, ParameterForm::kObject},
    {"rotation", "{^x ^y ^z}, in radians", false, ParameterForm::kObject},
    {"scale", "{^x ^y ^z}", false, ParameterForm::kObject},
    {"tags", "an object: its attributes become tags", false, ParameterForm::kObject}};
constexpr ParameterInfo kCopyNode[] = {
    {"id", "the new node's id", true},
    {"source", "the node to copy", true},
    {"parent", "the group to put it in; world if missing"},
    {"position", "{^x ^y ^z}", false, ParameterForm::kObject},
    {"rotation", "{^x ^y ^z}, in radians", false, ParameterForm::kObject},
    {"scale", "{^x ^y ^z}", false, ParameterForm::kObject},
    {"copy_tags", "true: with the tags of the source"},
    {"tags", "an object: its attributes become tags", false, ParameterForm::kObject},
    {"adjust", "true: shrink it until it touches nothing tagged object-source belief"}};
constexpr ParameterInfo kCopyTransform[] = {
    {"source", "the node to copy from", true}, {"destination", "the node to copy to", true},
    {"position", "yes to copy the position"},  {"rotation", "yes to copy the rotation"},
    {"scale", "yes to copy the scale"},        {"adjust", "yes: shrink it as copy_node does"}};
constexpr ParameterInfo kDelete[] = {{"id", "the node's id", true}};
constexpr ParameterInfo kSetTransform[] = {{"id", "the node's id", true},
                                           {"position", "{^x ^y ^z}", false, ParameterForm::kObject},
                                           {"rotation", "{^x ^y ^z}, in radians", false, ParameterForm::kObject},
                                           {"scale", "{^x ^y ^z}", false, ParameterForm::kObject}};
constexpr ParameterInfo kSetTag[] = {
    {"id", "the node's id", true}, {"tag_name", "the tag's name", true}, {"tag_value", "its value", true}};
constexpr ParameterInfo kDeleteTag[] = {{"id", "the node's id", true}, {"tag_name", "the tag's name", true}};
constexpr ParameterInfo kExtract[] = {{"type", "the filter", true}, {"...", "the filter's parameters"}};

constexpr CommandKind kCommandKinds[] = {
    {"add_node", "adds a node", kAddNode, MakeWriter<&WriteCommand::AddNode>},
    {"copy_node", "adds a copy of a node, without its children", kCopyNode, MakeWriter<&WriteCommand::CopyNode>},
    {"copy_transform", "gives a node the position, rotation or scale of another node", kCopyTransform,
     MakeWriter<&WriteCommand::CopyTransform>},
    {"delete_node", "removes a node and all nodes below it", kDelete, MakeWriter<&WriteCommand::DeleteNode>},
    {"delete_tag", "removes a tag", kDeleteTag, MakeWriter<&WriteCommand::DeleteTag>},
    {"extract", "reports what a filter finds, and each change", kExtract,
     [](const CommandParts& parts) { return MakeExtract(parts, false); }},
    {"extract_once", "reports what a filter finds, once", kExtract,
     [](const CommandParts& parts) { return MakeExtract(parts, true); }},
    {"set_tag", "gives a node a tag", kSetTag, MakeWriter<&WriteCommand::SetTag>},
    {"set_transform", "moves, turns or scales a node", kSetTransform, MakeWriter<&WriteCommand::SetTransform>},
};

}  // namespace

std::string HintForNode(const Scene& scene, std::string_view id) {
  std::vector<std::string_view> names;
  scene.ForEach([&](const Node& node) { names.emplace_back(node.id()); });
  const std::string_view near = Suggest(id, names);
  std::string hint = "there is no node " + std::string(id);
  if (!near.empty()) return hint + ": did you mean " + std::string(near) + "?";
  return hint + ": svs " + scene.name() + ".scene.world lists what is there";
}

std::span<const CommandKind> CommandKinds() {
  return kCommandKinds;
}

const CommandKind* FindCommandKind(std::string_view name) {
  for (const CommandKind& kind : kCommandKinds) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

}  // namespace soarbox::kernel::imagery
