// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "kernel/base/symbol.h"
#include "kernel/imagery/filter_kinds.h"
#include "kernel/imagery/imagery_scene.h"
#include "kernel/imagery/memory_writer.h"

namespace soarbox::kernel::imagery {

class FilterPool;
class PlainRandom;

/// A problem of a command, and a hint; empty if there is none.
struct Trouble {
  std::string problem, hint;
};

/// A hint for an id that no node has: a similar id, or how to list the nodes.
std::string HintForNode(const Scene& scene, std::string_view id);

/// The arguments of a command's construction.
struct CommandParts {
  MemoryWriter& writer;
  Scene& scene;
  FilterPool& filters;
  PlainRandom& random;
  Symbol id;  ///< The identifier of the command.
};

/// A command that rules put on ^svs.command of a state. It exists as long as its element.
class SceneCommand {
 public:
  virtual ~SceneCommand() = default;
  /// Whether it changes the scene, once; otherwise it reads the scene.
  virtual bool writes() const = 0;
  /// Called in the input phase. `look_again`: something may have changed since the last call.
  virtual void Update(bool look_again) = 0;
  virtual void Mark(const std::function<void(Symbol)>& mark) const = 0;
  // For code that inspects commands.
  Symbol id() const { return id_; }
  /// The computation of an extract; null for commands that change the scene, and for invalid commands.
  virtual const Filter* filter() const { return nullptr; }
  /// The identifier of the record in working memory for a value of the filter; none if the value is not shown.
  virtual Symbol RecordOf(const Value& value) const {
    (void)value;
    return {};
  }
  /// Increases when its results change.
  std::uint64_t version() const { return version_; }
  /// The error of the command, or a reference to something that does not exist.
  virtual Trouble trouble() const = 0;

 protected:
  explicit SceneCommand(Symbol id) : id_(id) {}
  void NoteChange() { ++version_; }

 private:
  Symbol id_;
  std::uint64_t version_ = 0;
};

/// A kind of command.
struct CommandKind {
  std::string_view name, meaning;
  std::span<const ParameterInfo> parameters;
  std::unique_ptr<SceneCommand> (*make)(const CommandParts& parts);
};

/// All kinds, sorted by name.
std::span<const CommandKind> CommandKinds();
/// Null if there is no such kind.
const CommandKind* FindCommandKind(std::string_view name);

/// Commands that read the scene.
std::unique_ptr<SceneCommand> MakeExtract(const CommandParts& parts, bool once);

}  // namespace soarbox::kernel::imagery
