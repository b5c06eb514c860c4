// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::explain {

/// Reports the scenes of the spatial visual system. Inspectors of running agents also implement this class, those of
/// recorded minds do not. Callers get it from an Inspector by dynamic_cast.
class SceneSource {
 public:
  virtual ~SceneSource() = default;

  /// Returns the output of `svs facts` (cli/svs_facts.h). Its first line is "version N". If the kernel does not support
  /// the command, the output is the kernel's error message.
  virtual std::string SceneFacts() = 0;
};

}  // namespace soarbox::explain
