// SPDX-License-Identifier: BSD-2-Clause
// The program soarbox-serve: the same commands as soarbox, with the server of pages.
#include "app/command_line.h"
#include "app/server/serve_pages.h"

namespace {

using namespace soarbox;

class Server final : public app::PageServer {
 public:
  int Serve(const app::ServeOptions& options) const override { return app::ServePages(options); }
  int Show(const app::BrowserOptions& options) const override { return app::ShowInBrowser(options); }
};

}  // namespace

int main(int argc, char** argv) {
  const Server server;
  return app::CommandLine(argc, argv, {nullptr, &server, nullptr});
}
