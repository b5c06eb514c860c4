// SPDX-License-Identifier: BSD-2-Clause
// Types into a file of 5,000 rules, as in an editor, and measures the time until the language server has reported the
// problems.
//
// usage: editor_keystroke [RULES]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "editors/lsp_server.h"

namespace {

using soarbox::editors::Json;
using soarbox::editors::LspServer;
using Clock = std::chrono::steady_clock;

double Milliseconds(Clock::time_point since) {
  return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
}

std::string Rules(int count) {
  std::string text =
      "sp {scout*make*plan\n   (state <s> ^superstate nil)\n-->\n   (<s> ^plan <p>)\n   (<p> ^next any)\n}\n\n"
      "sp {scout*apply*go\n   (state <s> ^operator <o> ^io.output-link <out>)\n   (<o> ^name go ^waypoint <w>)\n-->\n"
      "   (<out> ^move-to <m>)\n   (<m> ^waypoint <w>)\n}\n\n";
  for (int i = 0; i < count; ++i) {
    const std::string n = std::to_string(i);
    text += "# What to do about place " + n + ".\nsp {scout*propose*go*" + n +
            "\n   (state <s> ^superstate nil\n              ^io.input-link <in>\n              ^plan <p>)\n"
            "   (<in> ^waypoint <w>)\n   (<w> ^name w" +
            n + " ^range > 3)\n   (<p> ^next w" + n +
            ")\n-->\n"
            "   (<s> ^operator <o> + =)\n   (<o> ^name go ^waypoint w" +
            n + ")\n}\n\n";
  }
  return text;
}

std::string Message(const char* method, Json params, int id = 0) {
  Json message = {{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}};
  if (id > 0) message["id"] = id;
  return message.dump();
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 5000;
  const std::string uri = "file:///nowhere/many.soar";
  LspServer server;
  server.Handle(Message("initialize", {{"capabilities", Json::object()}}, 1));
  const std::string text = Rules(count);
  Clock::time_point since = Clock::now();
  server.Handle(Message("textDocument/didOpen", {{"textDocument", {{"uri", uri}, {"text", text}}}}));
  std::printf("%d rules, %.1f MB: open %.0f ms", count, static_cast<double>(text.size()) / 1e6, Milliseconds(since));
  since = Clock::now();
  server.Idle();
  std::printf(", slips of all rules %.0f ms\n", Milliseconds(since));

  // A condition is typed letter by letter into the middle rule.
  const std::string typed = "\n   (<p> ^goal <x>)";
  const long line =
      std::count(text.begin(), text.begin() + static_cast<long>(text.find("*go*" + std::to_string(count / 2))), '\n') +
      5;
  std::vector<double> times;
  std::size_t column = 21;
  long at = line;
  for (const char letter : typed) {
    const Json where = {{"line", at}, {"character", column}};
    const std::string message = Message(
        "textDocument/didChange",
        {{"textDocument", {{"uri", uri}}},
         {"contentChanges", {{{"range", {{"start", where}, {"end", where}}}, {"text", std::string(1, letter)}}}}});
    since = Clock::now();
    server.Handle(message);
    times.push_back(Milliseconds(since));
    ++column;
    if (letter == '\n') ++at, column = 0;
  }
  std::sort(times.begin(), times.end());
  std::printf("a keystroke: median %.1f ms, worst %.1f ms\n", times[times.size() / 2], times.back());
  return 0;
}
