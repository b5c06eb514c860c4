// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/module.h"
#include "kernel/imagery/filter_pool.h"
#include "kernel/imagery/imagery_scene.h"
#include "kernel/imagery/measures.h"
#include "kernel/imagery/memory_writer.h"
#include "kernel/imagery/scene_command.h"
#include "kernel/imagery/scene_feed.h"
#include "kernel/imagery/scene_in_memory.h"
#include "kernel/imagery/scene_lines.h"

namespace soarbox::kernel {

class Agent;
class Elaboration;
class GoalStack;
class Modules;
class Observers;

namespace imagery {

/// The imagery of a state: its scene, the copy of the scene in working memory, and the commands of the state's rules.
class StateScene {
 public:
  struct Parts {
    MemoryWriter& writer;
    PlainRandom& random;
    Symbol goal;
    GoalLevel level;
  };
  /// Writes ^svs with the contents of the scene.
  StateScene(const Parts& parts, std::unique_ptr<Scene> scene);

  GoalLevel level() const { return parts_.level; }
  Scene& scene() { return *scene_; }
  const Scene& scene() const { return *scene_; }
  /// init-soar: returns the scene and discards everything else.
  std::unique_ptr<Scene> TakeScene();

  /// Output phase: finds new and removed commands. Returns true if there are new ones.
  bool NoteCommands();
  /// Input phase: executes the commands that change the scene (`writes`), or those that read it.
  void Update(bool writes, bool look_again);
  /// Reports each problem of a command once, with its element on the command link.
  void TellTroubles(const std::function<void(WmeId, const Trouble&)>& report);
  void Mark(const std::function<void(Symbol)>& mark) const;

  /// Calls visit(kind, name, element, command) for each command, in the order of execution.
  template <typename Visit>
  void ForEachCommand(Visit&& visit) const {
    for (const Entry& entry : commands_) {
      visit(parts_.writer.TextOf(entry.attribute), entry.name,
            parts_.writer.ElementOf(command_link_, entry.attribute, entry.id), *entry.command);
    }
  }
  /// Increases when the scene or the results of extracts change.
  std::uint64_t version() const;
  std::size_t MemoryBytes() const { return scene_->MemoryBytes() + filters_.MemoryBytes(); }

  // Whether viewers show it.
  bool drawn() const { return drawn_; }
  void Draw(bool on, const ViewerSink& viewer);

 private:
  struct Listed {
    Symbol attribute, id;
    friend bool operator==(const Listed&, const Listed&) = default;
  };
  struct Entry {
    std::string name;
    Symbol id;
    std::unique_ptr<SceneCommand> command;
    Symbol attribute;
    std::string told;  ///< The last reported problem.
  };

  Parts parts_;
  Symbol link_, command_link_, scene_link_;
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<SceneView> view_;
  std::unique_ptr<SceneFeed> feed_;
  bool drawn_ = false;
  FilterPool filters_;
  std::vector<Listed> listed_;   ///< The elements on the command link at the last look.
  std::vector<Entry> commands_;  ///< By name.
  std::uint64_t gone_ = 0;       ///< The sum of the versions of removed commands and the number of added commands.
};

}  // namespace imagery

/// The spatial visual system of one agent. Each state has a scene: objects in space. The host updates the scenes; rules
/// change and query them through ^svs.command, and the results are written to working memory. Off until it is enabled;
/// an agent that never enables it has no scenes.
///
/// Lines for the scene are applied in the input phase. Commands that change the scene are executed before those that
/// read it. Extracts are updated only if something may have changed, and recompute only what depends on the change
/// (filter.h).
class Imagery final : public Module {
 public:
  struct Uses {
    SymbolTable& symbols;
    WorkingMemory& memory;
    const GoalStack& goals;
    WmeChanges& changes;
    PreferenceChanges& preferences;
    Elaboration& elaboration;
    Modules& modules;
    const Observers& observers;
    const Agent& agent;
  };
  explicit Imagery(const Uses& uses);
  ~Imagery() override;

  bool enabled() const { return enabled_; }
  bool in_substates() const { return in_substates_; }
  /// Creates scenes for the states. Call it only between phases. Does nothing if it is enabled already.
  void Enable();
  /// Leaves ^svs in working memory until init-soar. Before that, Enable continues with the same scene. Refused while a
  /// substate has a scene.
  Result<void> Disable();
  void EnableInSubstates();
  /// Refused while a substate has a scene.
  Result<void> DisableInSubstates();

  /// Buffers lines of the scene graph edit language for the top state's scene. They take effect in the next input
  /// phase. Returns false if imagery is off.
  bool Send(std::string_view lines);
  /// Returns the lines refused since the last call, each with the reason and a newline; at most the last 1,000.
  std::string TakeRefused();
  /// Returns the answers to queries about the top state's scene; empty if imagery is off.
  std::string Query(std::string_view queries) const;
  /// Applies a line to the scene of any state immediately. Call it only between phases. Extracts are updated in the
  /// next input phase.
  std::optional<imagery::LineError> Apply(imagery::StateScene& state, std::string_view line);
  void Clear(imagery::StateScene& state);

  /// Changes whenever the imagery of a state changes.
  std::uint64_t version() const;
  /// The states with scenes, from the top down.
  std::span<const std::unique_ptr<imagery::StateScene>> states() const { return states_; }
  /// Finds a state by its name; null if there is none.
  imagery::StateScene* FindState(std::string_view name);

  /// Sends the drawn scenes to a viewer from now on; null: to none.
  void SetViewer(imagery::ViewerSink sink);
  void Draw(imagery::StateScene& state, bool on);

  void Input() override;
  void Output(bool output_changed) override;
  void StateComplete(GoalLevel level) override;
  void StateEnds(GoalLevel level) override;
  void BeforeInit() override;
  void AfterInit() override;
  void Mark(const std::function<void(Symbol)>& mark) override;
  std::size_t MemoryBytes() const override;

 private:
  void MakeState(GoalLevel level);
  void MakeStates();
  void SetHooks();
  void Settle();
  void TellTroubles();

  Uses uses_;
  imagery::MemoryWriter writer_;
  imagery::PlainRandom random_;
  bool enabled_ = false, in_substates_ = true;
  bool look_again_ = true;  ///< Something may have changed since the extracts last looked.
  bool updating_ = false;
  std::uint64_t gone_ = 0;  ///< The sum of the versions of removed states and the number of added states.
  std::vector<std::string> lines_, refused_;
  std::vector<std::unique_ptr<imagery::StateScene>> states_, ended_;
  std::unique_ptr<imagery::Scene> kept_;  ///< The top state's scene while init-soar creates a new state.
  imagery::ViewerSink viewer_;
};

}  // namespace soarbox::kernel
