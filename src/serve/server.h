// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "diagnostics/result.h"
#include "serve/settings.h"

namespace soarbox::serve {

/// Serves pages in browsers until the process gets SIGINT or SIGTERM (docs/serve.md). `on_listening` gets the addresses
/// to open: the first is everybody's; then the class's, if there is one, with their names. Returns why it could not
/// serve, or nothing.
struct Address {
  std::string name, link;
};
Result<void> Serve(Settings settings, std::unique_ptr<const Catalog> catalog,
                   const std::function<void(const std::vector<Address>&)>& on_listening);

}  // namespace soarbox::serve
