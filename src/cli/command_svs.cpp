// SPDX-License-Identifier: BSD-2-Clause
#include "cli/command.h"

namespace soarbox::cli {

bool CommandSvs(CommandCall& call) {
  if (call.words.size() < 2) {
    call.Out("Spatial Visual System is disabled.");
    return true;
  }
  const std::string& word = call.words[1].text;
  if (word == "--disable" || word == "--off" || word == "-d") {
    call.Out("Spatial Visual System disabled. ");
    return true;
  }
  if (word == "--enable" || word == "--on" || word == "-e") {
    return call.Fail("The Spatial Visual System is not available in this build.");
  }
  call.Out("Spatial Visual System is currently disabled.  Please enable to execute SVS commands.\n");
  return call.FailPrinted();
}

}  // namespace soarbox::cli
