// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <map>
#include <utility>

#include "kernel/imagery/imagery.h"

namespace soarbox::kernel::imagery {

StateScene::StateScene(const Parts& parts, std::unique_ptr<Scene> scene) : parts_(parts), scene_(std::move(scene)) {
  MemoryWriter& writer = parts_.writer;
  link_ = writer.AddObject(parts_.goal, "svs", 'V');
  command_link_ = writer.AddObject(link_, "command");
  scene_link_ = writer.AddObject(link_, "spatial-scene");
  view_ = std::make_unique<SceneView>(writer, *scene_, scene_link_);
}

std::unique_ptr<Scene> StateScene::TakeScene() {
  commands_.clear();
  feed_.reset();
  view_.reset();
  return std::move(scene_);
}

bool StateScene::NoteCommands() {
  std::vector<Listed> listed;
  parts_.writer.ForEachValue(command_link_, [&](Symbol attribute, Symbol value) {
    if (value.IsIdentifier()) listed.push_back({attribute, value});
  });
  if (listed == listed_) return false;
  listed_ = std::move(listed);
  std::map<std::string, Listed> live;
  for (const Listed& item : listed_) live.emplace(parts_.writer.NameOf(item.id), item);
  std::erase_if(commands_, [&](const Entry& entry) {
    if (live.contains(entry.name)) return false;
    gone_ += entry.command->version() + 1;
    return true;
  });
  bool came = false;
  for (const auto& [name, item] : live) {
    const auto place =
        std::lower_bound(commands_.begin(), commands_.end(), name,
                         [](const Entry& entry, const std::string& wanted) { return entry.name < wanted; });
    if (place != commands_.end() && place->name == name) continue;
    const CommandKind* const kind =
        item.attribute.IsString() ? FindCommandKind(parts_.writer.TextOf(item.attribute)) : nullptr;
    if (kind == nullptr) continue;
    commands_.insert(
        place,
        {name, item.id, kind->make({parts_.writer, *scene_, filters_, parts_.random, item.id}), item.attribute, {}});
    came = true;
    ++gone_;
  }
  return came;
}

void StateScene::Update(bool writes, bool look_again) {
  for (const Entry& entry : commands_) {
    if (entry.command->writes() == writes && parts_.writer.IsReached(entry.id)) entry.command->Update(look_again);
  }
  if (!writes) filters_.EndLook();
}

std::uint64_t StateScene::version() const {
  std::uint64_t version = scene_->version() + gone_;
  for (const Entry& entry : commands_) version += entry.command->version();
  return version;
}

void StateScene::TellTroubles(const std::function<void(WmeId, const Trouble&)>& report) {
  for (Entry& entry : commands_) {
    if (!parts_.writer.IsReached(entry.id)) continue;
    const Trouble trouble = entry.command->trouble();
    if (trouble.problem == entry.told) continue;
    entry.told = trouble.problem;
    if (trouble.problem.empty()) continue;
    const WmeId given = parts_.writer.ElementOf(command_link_, entry.attribute, entry.id);
    if (given != WmeId::kNone) report(given, trouble);
  }
}

void StateScene::Mark(const std::function<void(Symbol)>& mark) const {
  for (const Symbol id : {link_, command_link_, scene_link_}) {
    if (id) mark(id);
  }
  for (const Listed& item : listed_) {
    mark(item.attribute);
    mark(item.id);
  }
  for (const Entry& entry : commands_) entry.command->Mark(mark);
  if (view_ != nullptr) view_->Mark(mark);
}

void StateScene::Draw(bool on, const ViewerSink& viewer) {
  drawn_ = on;
  feed_.reset();
  if (drawn_ && viewer) feed_ = std::make_unique<SceneFeed>(*scene_, viewer);
}

}  // namespace soarbox::kernel::imagery
