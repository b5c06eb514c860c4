// SPDX-License-Identifier: BSD-2-Clause
// A build without OpenSSL (-DSOARBOX_LTI=OFF).
#include "diagnostics/problem.h"
#include "serve/lti/tool.h"

namespace soarbox::lti {

Result<std::unique_ptr<Tool>> Tool::Make(const Uses&) {
  return NewProblem("this soarbox was built without LTI", "leave --lti out, or build it with -DSOARBOX_LTI=ON");
}

}  // namespace soarbox::lti
