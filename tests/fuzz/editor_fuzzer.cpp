// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary bytes to the framing of editors' messages, and its output to the language server and the debugger,
// after a valid beginning. Launching and opening are left out: there are no scenarios.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "editors/dap_server.h"
#include "editors/lsp_server.h"
#include "editors/message_stream.h"
#include "language/format_rules.h"

using namespace soarbox;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  editors::LspServer server;
  server.Handle(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{}})");
  server.Handle(
      R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":{"uri":"file:///none/a.soar",)"
      R"("text":"sp {a (state <s> ^io.input-link <in>) --> (<s> ^b c)}\n"}}})");
  editors::DapServer debugger(nullptr);
  editors::MessageStream stream;
  // In two pieces, as from a pipe.
  stream.Add(bytes.substr(0, size / 2));
  for (int piece = 0; piece < 2; ++piece) {
    while (const auto message = stream.Next()) {
      if (!message->fault.empty()) continue;
      server.Handle(message->body);
      // Launching and attaching access files and ports.
      if (message->body.find("launch") == std::string::npos && message->body.find("attach") == std::string::npos)
        debugger.Handle(message->body);
    }
    if (piece == 0) stream.Add(bytes.substr(size / 2));
  }
  server.Handle(std::string(bytes));
  const std::string once = language::FormatRules(bytes);
  if (language::FormatRules(once) != once) __builtin_trap();
  return 0;
}
