// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "diagnostics/result.h"
#include "serve/server_settings.h"

namespace soarbox::serve {

/// Serves pages to browsers until the process receives SIGINT or SIGTERM (docs/serve.md). `on_listening` gets the
/// addresses to open: the first is for everyone; the others are those of the class, with names, if there is one. Fails
/// if it cannot serve.
struct Address {
  std::string name, link;
};
Result<void> Serve(Settings settings, std::unique_ptr<const Catalog> catalog,
                   const std::function<void(const std::vector<Address>&)>& on_listening);

}  // namespace soarbox::serve
