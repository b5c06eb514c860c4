// SPDX-License-Identifier: BSD-2-Clause
// For systems without processes (WebAssembly).
#include "serve/wall.h"

namespace soarbox::serve {

std::vector<std::string> RaiseWall(const WallSettings&) {
  return MissingOfWall();
}

std::vector<std::string> MissingOfWall() {
  return {"this system has no landlock, no seccomp filters and no user namespaces"};
}

}  // namespace soarbox::serve
