// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <vector>

#include "diagnostics/json_text.h"
#include "editors/byte_pipe.h"
#include "editors/json_type.h"
#include "editors/message_stream.h"

namespace soarbox::editors {

/// Serves a client of the Language Server Protocol or the Debug Adapter Protocol until the server is over or the client
/// has disconnected. `take(message)` returns the answers to a message. If no message arrives for `patience(server)`
/// milliseconds (negative: no limit), the messages of `rest(server)` are sent.
template <typename Server, typename Take, typename Patience, typename Rest>
void ServeStream(Server& server, int in, int out, Take take, Patience patience, Rest rest) {
  BytePipe pipe(in, out);
  MessageStream stream;
  const auto send = [&](const std::vector<Json>& messages) {
    for (const Json& message : messages) pipe.Write(MessageStream::Frame(JsonText(message)));
  };
  while (!server.is_over() && !pipe.is_broken()) {
    if (const std::optional<MessageStream::Message> message = stream.Next()) {
      send(take(*message));
      continue;
    }
    const BytePipe::Got got = pipe.Read(patience(server));
    if (got.ended) return;
    stream.Add(got.bytes);
    if (got.bytes.empty()) send(rest(server));
  }
}

}  // namespace soarbox::editors
