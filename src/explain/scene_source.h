// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::explain {

/// What inspectors of living minds also are, see Inspector: what a mind imagines.
class SceneSource {
 public:
  virtual ~SceneSource() = default;

  /// What `svs facts` prints (cli/svs_facts.h): its first line is "version N"; if the kernel reports nothing, anything.
  virtual std::string SceneFacts() = 0;
};

}  // namespace soarbox::explain
