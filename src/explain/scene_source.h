// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::explain {

/// The part of an Inspector that reports what a mind imagines. Inspectors of living minds also implement it.
class SceneSource {
 public:
  virtual ~SceneSource() = default;

  /// The output of `svs facts` (cli/svs_facts.h). Its first line is "version N". If the kernel does not support the
  /// command, the output is arbitrary text.
  virtual std::string SceneFacts() = 0;
};

}  // namespace soarbox::explain
