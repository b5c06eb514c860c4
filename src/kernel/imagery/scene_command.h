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
#include "kernel/imagery/memory_writer.h"
#include "kernel/imagery/scene.h"

namespace soarbox::kernel::imagery {

class FilterPool;
class PlainRandom;

/// What is wrong with a command, and what to do about it; empty if nothing is wrong.
struct Trouble {
  std::string problem, hint;
};

/// A hint for a name that no node has: what to write instead.
std::string HintForNode(const Scene& scene, std::string_view id);

/// What a command is made with.
struct CommandParts {
  MemoryWriter& writer;
  Scene& scene;
  FilterPool& filters;
  PlainRandom& random;
  Symbol id;  ///< Its identifier.
};

/// A command that rules put on ^svs.command of a state. Lives as long as it is there.
class SceneCommand {
 public:
  virtual ~SceneCommand() = default;
  /// Whether it changes the scene, once; otherwise it looks at the scene.
  virtual bool writes() const = 0;
  /// In the input phase. `look_again`: something may have changed since the last time.
  virtual void Update(bool look_again) = 0;
  virtual void Mark(const std::function<void(Symbol)>& mark) const = 0;
  // For code that inspects commands.
  Symbol id() const { return id_; }
  /// What an extract computes; null for commands that change the scene, and if the command cannot be read.
  virtual const Filter* filter() const { return nullptr; }
  /// The record that shows a value of the filter; none if the value is not shown.
  virtual Symbol RecordOf(const Value& value) const {
    (void)value;
    return {};
  }
  /// Grows when what it shows changes.
  std::uint64_t version() const { return version_; }
  /// What went wrong, or what the command asks for although it does not exist.
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

/// Commands that look at the scene.
std::unique_ptr<SceneCommand> MakeExtract(const CommandParts& parts, bool once);

}  // namespace soarbox::kernel::imagery
