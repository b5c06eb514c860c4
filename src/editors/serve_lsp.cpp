// SPDX-License-Identifier: BSD-2-Clause
#include "editors/lsp_server.h"
#include "editors/serve_stream.h"

namespace soarbox::editors {

int ServeLsp(int in, int out, const sim::DataFolders* data) {
  constexpr int kIdle_ms = 150;  // After this time without messages, entire programs are checked.
  LspServer server(data);
  ServeStream(
      server, in, out,
      [&](const MessageStream::Message& message) {
        return message.fault.empty() ? server.Handle(message.body) : std::vector<Json>{LspServer::Fault(message.fault)};
      },
      [](LspServer& lsp) { return lsp.HasIdleWork() ? kIdle_ms : -1; }, [](LspServer& lsp) { return lsp.Idle(); });
  return server.exit_code();
}

}  // namespace soarbox::editors
