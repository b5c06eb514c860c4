// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "kernel/base/symbol.h"
#include "kernel/imagery/filter_kinds.h"
#include "kernel/imagery/memory_writer.h"
#include "kernel/imagery/scene.h"

namespace soarbox::kernel::imagery {

class PlainRandom;

/// What a command is made with.
struct CommandParts {
  MemoryWriter& writer;
  Scene& scene;
  PlainRandom& random;
  Symbol id;  ///< Its identifier.
};

/// A command that rules put on ^svs.command of a state, as long as it is there.
class SceneCommand {
 public:
  virtual ~SceneCommand() = default;
  /// Whether it changes the scene, once; else it looks at it.
  virtual bool writes() const = 0;
  /// In the input phase. `look_again`: something may have changed since the last.
  virtual void Update(bool look_again) = 0;
  virtual void Mark(const std::function<void(Symbol)>& mark) const = 0;
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
