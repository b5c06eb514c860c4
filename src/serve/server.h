// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "diagnostics/result.h"
#include "serve/server_settings.h"

namespace soarbox::serve {

/// An address to open in a browser, and the name of the person that it is for; empty: for everyone.
struct Address {
  std::string name, link;
};
/// Serves pages to browsers until the process receives SIGINT or SIGTERM, or all pages are gone if the settings request
/// that (docs/serve.md). `on_listening` gets the addresses to open: the first is for everyone, the others are for the
/// class, if there is one. Fails if it cannot serve.
Result<void> Serve(Settings settings, std::unique_ptr<const Catalog> catalog,
                   const std::function<void(const std::vector<Address>&)>& on_listening);

}  // namespace soarbox::serve
