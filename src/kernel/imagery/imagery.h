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
#include "kernel/imagery/measures.h"
#include "kernel/imagery/memory_writer.h"
#include "kernel/imagery/scene.h"
#include "kernel/imagery/scene_command.h"
#include "kernel/imagery/scene_feed.h"
#include "kernel/imagery/scene_lines.h"
#include "kernel/imagery/scene_view.h"

namespace soarbox::kernel {

class Agent;
class Elaboration;
class GoalStack;
class Modules;
class Observers;

namespace imagery {

/// What a state imagines: its scene, the copy of it in working memory, and the commands of its rules.
class StateScene {
 public:
  struct Parts {
    MemoryWriter& writer;
    PlainRandom& random;
    Symbol goal;
    GoalLevel level;
  };
  /// Writes ^svs with the scene below it.
  StateScene(const Parts& parts, std::unique_ptr<Scene> scene);

  GoalLevel level() const { return parts_.level; }
  Scene& scene() { return *scene_; }
  const Scene& scene() const { return *scene_; }
  /// init-soar: the scene stays, everything else ends.
  std::unique_ptr<Scene> TakeScene();

  /// Output phase: notes which commands came and went. True if one came.
  bool NoteCommands();
  /// Input phase: carries out the commands that write, or those that look.
  void Update(bool writes, bool look_again);
  /// Reports each problem of the commands once: the element on the command link, and the problem.
  void TellTroubles(const std::function<void(WmeId, const Trouble&)>& report);
  void Mark(const std::function<void(Symbol)>& mark) const;

  /// Calls visit(kind, name, element, command) for each command, in the order in which they are carried out.
  template <typename Visit>
  void ForEachCommand(Visit&& visit) const {
    for (const Entry& entry : commands_) {
      visit(parts_.writer.TextOf(entry.attribute), entry.name,
            parts_.writer.ElementOf(command_link_, entry.attribute, entry.id), *entry.command);
    }
  }
  /// Grows when the scene or what extracts show changes.
  std::uint64_t version() const;
  std::size_t MemoryBytes() const { return scene_->MemoryBytes() + filters_.MemoryBytes(); }

  // Whether viewers see it.
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
    std::string told;  ///< The problem reported last.
  };

  Parts parts_;
  Symbol link_, command_link_, scene_link_;
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<SceneView> view_;
  std::unique_ptr<SceneFeed> feed_;
  bool drawn_ = false;
  FilterPool filters_;
  std::vector<Listed> listed_;   ///< What was on the command link at the last look.
  std::vector<Entry> commands_;  ///< By name.
  std::uint64_t gone_ = 0;       ///< Versions of commands that have gone, and how many commands came.
};

}  // namespace imagery

/// The spatial visual system of one agent. Each state has a scene of objects in space. The host feeds the scenes; rules
/// change and query them through ^svs.command, and the answers appear in working memory. It is off until enabled; an
/// agent that never enables it has none.
///
/// Lines for the scene wait until the input phase, in which commands that write come before those that look. Extracts
/// look again only if something may have changed, and compute only what depends on the change (filter.h).
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
  /// Gives the states scenes. Call only between phases. Does nothing if it is on.
  void Enable();
  /// Leaves ^svs as it is until init-soar or the next Enable. Refused while a substate has a scene.
  Result<void> Disable();
  void EnableInSubstates();
  /// Refused while a substate has a scene.
  Result<void> DisableInSubstates();

  /// Lines of the scene graph edit language for the top state's scene. They take effect in the next input phase. False
  /// if it is off.
  bool Send(std::string_view lines);
  /// The lines refused since the last call, each with its reason and a newline; at most the last 1,000.
  std::string TakeRefused();
  /// The answers to queries about the top state's scene; empty if it is off.
  std::string Query(std::string_view queries) const;
  /// Applies a line to any state's scene at once. Call only between phases. Extracts look again in the next input
  /// phase.
  std::optional<imagery::LineError> Apply(imagery::StateScene& state, std::string_view line);
  void Clear(imagery::StateScene& state);

  /// Changes whenever something that a state imagines changes.
  std::uint64_t version() const;
  /// The states that have scenes, from the top down.
  std::span<const std::unique_ptr<imagery::StateScene>> states() const { return states_; }
  /// By the name of the state; null if there is none.
  imagery::StateScene* FindState(std::string_view name);

  /// Shows the drawn scenes to a viewer from now on; null: to none.
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
  std::uint64_t gone_ = 0;  ///< Versions of states that have gone, and how many states came.
  std::vector<std::string> lines_, refused_;
  std::vector<std::unique_ptr<imagery::StateScene>> states_, ended_;
  std::unique_ptr<imagery::Scene> kept_;  ///< The top state's, while init-soar makes a new one.
  imagery::ViewerSink viewer_;
};

}  // namespace soarbox::kernel
