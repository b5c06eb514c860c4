// SPDX-License-Identifier: BSD-2-Clause
#include "editors/byte_pipe.h"
#include "editors/lsp_server.h"
#include "editors/message_stream.h"

namespace soarbox::editors {

int ServeLsp(int in, int out, const sim::DataFolders* data) {
  constexpr int kIdle_ms = 150;  // So long nobody types before all rules are looked over.
  LspServer server(data);
  BytePipe pipe(in, out);
  MessageStream stream;
  const auto send = [&](const std::vector<Json>& messages) {
    for (const Json& message : messages)
      pipe.Write(MessageStream::Frame(message.dump(-1, ' ', false, Json::error_handler_t::replace)));
  };
  while (!server.is_over() && !pipe.is_broken()) {
    if (const std::optional<MessageStream::Message> message = stream.Next()) {
      if (message->fault.empty()) {
        send(server.Handle(message->body));
      } else {
        send({LspServer::Fault(message->fault)});
      }
      continue;
    }
    const BytePipe::Got got = pipe.Read(server.HasIdleWork() ? kIdle_ms : -1);
    if (got.ended) break;
    stream.Add(got.bytes);
    if (got.bytes.empty()) send(server.Idle());
  }
  return server.exit_code();
}

}  // namespace soarbox::editors
