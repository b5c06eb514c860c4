// SPDX-License-Identifier: BSD-2-Clause
// A client that implements the wire protocol itself, with a listening kernel.
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "sml/wire/channel.h"
#include "sml/wire/message.h"
#include "sml_Client.h"
#include "sml_test_files.h"

namespace {

using soarbox::wire::Channel;
using soarbox::wire::IoThread;
using soarbox::wire::Message;
using std::chrono::milliseconds;

struct Server {
  Server() : kernel(sml::Kernel::CreateKernelInNewThread(sml::Kernel::kUseAnyPort)) {
    EXPECT_FALSE(kernel->HadError()) << kernel->GetLastErrorDescription();
  }
  int port() const { return kernel->GetListenerPort(); }
  std::unique_ptr<sml::Kernel> kernel;
};

/// Replies to events while it waits for a response.
struct Client {
  explicit Client(int port) {
    auto connected = soarbox::wire::Connect(io, "127.0.0.1", port);
    EXPECT_TRUE(connected.ok());
    channel = std::move(connected.value());
  }

  void Send(const std::string& document) { channel->Send(document); }
  /// The next document; empty after the time-out.
  std::string Receive(milliseconds timeout = milliseconds(5000)) {
    std::string document;
    return channel->Wait(document, timeout) ? document : std::string();
  }
  std::string Exchange(const std::string& document) {
    Send(document);
    return Receive();
  }
  /// Replies to an event.
  void Answer(const std::string& document) {
    const auto message = soarbox::wire::ReadMessage(document);
    Message response = soarbox::wire::MakeResponse(message.value().id);
    response.id = std::to_string(next_id++);
    Send(ToDocument(response));
  }
  /// Sends <command ...>...</command> and returns the contents of the response.
  std::string Ask(const std::string& command) {
    const std::string id = std::to_string(next_id++);
    Send("<sml doctype=\"call\" id=\"" + id + "\" smlversion=\"9.6.3\">" + command + "</sml>");
    while (true) {
      const std::string document = Receive();
      if (document.empty()) return "no answer";
      const auto message = soarbox::wire::ReadMessage(document);
      EXPECT_TRUE(message.ok()) << document;
      if (message.value().type == soarbox::wire::DocType::kCall) {
        events.push_back(document);
        Answer(document);
        continue;
      }
      if (message.value().ack != id) continue;
      const std::size_t begin = document.find('>') + 1;
      return document.substr(begin, document.rfind("</sml>") - begin);
    }
  }
  std::string Line(const std::string& agent, const std::string& line) {
    return Ask("<command name=\"cmdline\" output=\"raw\"><arg param=\"agent\">" + agent + "</arg><arg param=\"line\">" +
               line + "</arg></command>");
  }
  bool Heard(const std::string& piece) const {
    for (const std::string& event : events) {
      if (event.find(piece) != std::string::npos) return true;
    }
    return false;
  }

  IoThread io;
  std::unique_ptr<Channel> channel;
  int next_id = 100;
  std::vector<std::string> events;
};

TEST(Protocol, TheCapturedStartOfASessionIsAnsweredByteForByte) {
  Server server;
  Client client(server.port());
  const std::string port = std::to_string(server.port());
  const std::vector<std::pair<std::string, std::string>> exchanges = {
      {R"(<sml doctype="call" id="0" smlversion="9.6.3"><command name="version"></command></sml>)",
       R"(<sml ack="0" doctype="response" id="0" smlversion="9.6.3"><result output="raw">9.6.3</result></sml>)"},
      {R"(<sml doctype="call" id="1" smlversion="9.6.3"><command name="initial_time_tag"></command></sml>)",
       R"(<sml ack="1" doctype="response" id="1" smlversion="9.6.3"><result output="raw">-134217729</result></sml>)"},
      {R"(<sml doctype="call" id="2" smlversion="9.6.3"><command name="register_for_event"><arg param="eventid">after-agent-reinitialized</arg></command></sml>)",
       R"(<sml ack="2" doctype="response" id="2" smlversion="9.6.3"></sml>)"},
      {R"(<sml doctype="call" id="3" smlversion="9.6.3"><command name="get_agent_list"></command></sml>)",
       R"(<sml ack="3" doctype="response" id="3" smlversion="9.6.3"><result output="structured"></result></sml>)"},
      {R"(<sml doctype="call" id="4" smlversion="9.6.3"><command name="set_connection_info"><arg param="id-x">y</arg></command></sml>)",
       R"(<sml ack="4" doctype="response" id="4" smlversion="9.6.3"><result output="raw">Invalid arguments for command : set_connection_infoConnection name is missing</result><error>Invalid arguments for command : set_connection_infoConnection name is missing</error></sml>)"},
      {R"(<sml doctype="call" id="7" smlversion="9.6.3"><command name="create_agent"><arg param="name">hal</arg></command></sml>)",
       R"(<sml ack="7" doctype="response" id="5" smlversion="9.6.3"></sml>)"},
      {R"(<sml doctype="call" id="8" smlversion="9.6.3"><command name="get_agent_list"></command></sml>)",
       R"(<sml ack="8" doctype="response" id="6" smlversion="9.6.3"><result output="structured"><name>hal</name></result></sml>)"},
      {R"(<sml doctype="call" id="12" smlversion="9.6.3"><command name="get_input_link"><arg param="agent">hal</arg></command></sml>)",
       R"(<sml ack="12" doctype="response" id="7" smlversion="9.6.3"><result output="raw">I2</result></sml>)"},
      {R"(<sml doctype="call" id="14" smlversion="9.6.3"><command name="cmdline" output="raw"><arg param="agent">hal</arg><arg param="line">print s1</arg><arg param="echo">false</arg><arg param="nofilter">true</arg></command></sml>)",
       "<sml ack=\"14\" doctype=\"response\" id=\"8\" smlversion=\"9.6.3\"><result output=\"raw\">(S1 ^epmem E1 ^io I1 "
       "^reward-link R1 ^smem L1 ^superstate nil\n       ^type state)\n</result></sml>"},
      {R"(<sml doctype="call" id="17" smlversion="9.6.3"><command name="cmdline" output="raw"><arg param="agent">hal</arg><arg param="line">bogus-command</arg></command></sml>)",
       "<sml ack=\"17\" doctype=\"response\" id=\"9\" smlversion=\"9.6.3\"><result output=\"raw\">No such command: "
       "bogus-command\n</result><error code=\"1\">No such command: bogus-command\n</error></sml>"},
      {R"(<sml doctype="call" id="18" smlversion="9.6.3"><command name="cmdline"><arg param="agent">hal</arg><arg param="line">bogus-command</arg></command></sml>)",
       R"(<sml ack="18" doctype="response" id="10" smlversion="9.6.3"><result output="raw"></result><error code="1"></error></sml>)"},
      {R"(<sml doctype="call" id="19" smlversion="9.6.3"><command name="bogus"></command></sml>)",
       R"(<sml ack="19" doctype="response" id="11" smlversion="9.6.3"><result output="raw">Command bogus is not recognized by the kernel</result><error>Command bogus is not recognized by the kernel</error></sml>)"},
      {R"(<sml doctype="call" id="20" smlversion="9.6.3"><command name="get_input_link"><arg param="agent">nobody</arg></command></sml>)",
       R"(<sml ack="20" doctype="response" id="12" smlversion="9.6.3"><result output="raw">Could not find an agent with name: nobody</result><error>Could not find an agent with name: nobody</error></sml>)"},
      {R"(<sml doctype="call" id="21" smlversion="9.6.3"><command name="get_listener_port"></command></sml>)",
       "<sml ack=\"21\" doctype=\"response\" id=\"13\" smlversion=\"9.6.3\"><result output=\"raw\">" + port +
           "</result></sml>"},
      {R"(<sml doctype="call" id="23" smlversion="9.6.3"><command name="get_run_state"><arg param="agent">hal</arg><arg param="value">phase</arg></command></sml>)",
       R"(<sml ack="23" doctype="response" id="14" smlversion="9.6.3"><result output="raw">0</result></sml>)"},
      {R"(<sml doctype="call" id="26" smlversion="9.6.3"><command name="last_run_result"><arg param="agent">hal</arg></command></sml>)",
       R"(<sml ack="26" doctype="response" id="15" smlversion="9.6.3"><result output="raw">3</result></sml>)"},
  };
  for (const auto& [sent, expected] : exchanges) EXPECT_EQ(client.Exchange(sent), expected);
}

TEST(Protocol, InputRunOutputUpdateAndInitGoOverTheWireAsCaptured) {
  Server server;
  const RuleFile rules("sml_protocol_test", kMoverRules);
  Client client(server.port());
  client.Ask("<command name=\"create_agent\"><arg param=\"name\">hal</arg></command>");
  client.Ask(
      "<command name=\"register_for_event\"><arg param=\"agent\">hal</arg><arg "
      "param=\"eventid\">output-phase</arg></command>");
  client.Ask(
      "<command name=\"register_for_event\"><arg param=\"agent\">hal</arg><arg "
      "param=\"eventid\">print</arg></command>");
  client.Line("hal", "source {" + rules.path() + "}");
  EXPECT_EQ(client.Ask(
                "<command name=\"input\"><arg param=\"agent\">hal</arg><wme action=\"add\" attr=\"distance\" id=\"I2\" "
                "tag=\"-134217730\" valtype=\"double\" value=\"10.\"></wme></command>"),
            "");
  EXPECT_EQ(
      client.Ask("<command name=\"input\"><arg param=\"agent\">hal</arg><wme action=\"add\" attr=\"place\" id=\"I2\" "
                 "tag=\"-134217731\" valtype=\"id\" value=\"p7\"></wme><wme action=\"add\" attr=\"name\" id=\"p7\" "
                 "tag=\"-134217732\" value=\"a &lt;b&gt;\"></wme></command>"),
      "");
  EXPECT_NE(client.Line("hal", "run --self --output").find("--&gt; "), std::string::npos);
  EXPECT_TRUE(client.Heard("forward)</arg>"));
  EXPECT_TRUE(client.Heard(
      "<command name=\"output\"><arg param=\"agent\">hal</arg><wme action=\"add\" attr=\"output-link\" id=\"I1\" "
      "tag=\"13\" valtype=\"id\" value=\"I3\"></wme>"));
  EXPECT_TRUE(client.Heard("attr=\"forward\" id=\"I3\""));
  EXPECT_TRUE(client.Heard("valtype=\"double\" value=\"10.000000\""));
  EXPECT_EQ(
      client.Ask(
          "<command name=\"convert_identifier\"><arg param=\"agent\">hal</arg><arg param=\"name\">p7</arg></command>"),
      "<result output=\"raw\">P1</result>");
  const std::string input = client.Ask("<command name=\"get_all_input\"><arg param=\"agent\">hal</arg></command>");
  EXPECT_NE(input.find("<wme action=\"add\" attr=\"name\" id=\"P1\" tag=\"-134217732\" value=\"a &lt;b&gt;\"></wme>"),
            std::string::npos)
      << input;
  client.events.clear();
  client.Line("hal", "init-soar");
  EXPECT_TRUE(client.Heard("<command name=\"output_init\"><arg param=\"agent\">hal</arg></command>"));
}

TEST(Protocol, ForeignInputIsRefusedOrIgnoredAndTheConnectionStaysUp) {
  Server server;
  Client client(server.port());
  for (const char* garbage :
       {"", "x", "<sml", "<sml></sml>", "<xml doctype=\"call\"></xml>", "<sml doctype=\"notify\" id=\"1\"></sml>",
        "<sml doctype=\"call\" id=\"1\"><command name=\"version\">&#65</command></sml>",
        "<!DOCTYPE a [<!ENTITY b \"c\">]><sml doctype=\"call\">&b;</sml>"}) {
    client.Send(garbage);
  }
  std::string deep;
  for (int i = 0; i < 50000; ++i) deep += "<a>";
  client.Send(deep);
  EXPECT_EQ(client.Ask("<command name=\"version\"></command>"), "<result output=\"raw\">9.6.3</result>");
  // Input that crashes the reference is an error here, or works.
  EXPECT_NE(client.Exchange("<sml doctype=\"call\"><command name=\"version\"></command></sml>").find("9.6.3</result>"),
            std::string::npos);
  EXPECT_NE(client.Ask("<command name=\"get_run_state\"><arg param=\"value\">phase</arg></command>").find("<error>"),
            std::string::npos);
  EXPECT_NE(client.Ask("").find("did not contain a &lt;command&gt; tag"), std::string::npos);
  EXPECT_NE(client.Ask("<command></command>").find("name attribute"), std::string::npos);
  EXPECT_NE(client.Ask("<command name=\"input\"><wme action=\"add\"/></command>").find("<error>"), std::string::npos);
  for (const char* command :
       {"create_agent", "destroy_agent", "cmdline", "register_for_event", "fire_event", "suppress_event",
        "set_interrupt_check_rate", "send_client_message", "is_production_loaded", "convert_identifier"}) {
    EXPECT_NE(client.Ask("<command name=\"" + std::string(command) + "\"></command>").find("<error>"),
              std::string::npos)
        << command;
  }
}

TEST(Protocol, AClientThatNeverAnswersStallsTheKernelOnceAndForALimitedTime) {
  Server server;
  server.kernel->CreateAgent("hal");
  Client silent(server.port());
  silent.Ask(
      "<command name=\"register_for_event\"><arg param=\"agent\">hal</arg><arg "
      "param=\"eventid\">output-phase</arg></command>");
  silent.Exchange(
      "<sml doctype=\"call\" id=\"0\"><command name=\"register_for_event\"><arg param=\"agent\">hal</arg><arg "
      "param=\"eventid\">after-decision-cycle</arg></command></sml>");
  // Without rules each decision adds a state; the default limit would halt the agent first.
  server.kernel->GetAgent("hal")->ExecuteCommandLine("soar max-goal-depth 100");
  const auto start = std::chrono::steady_clock::now();
  server.kernel->GetAgent("hal")->RunSelf(20);
  EXPECT_LT(std::chrono::steady_clock::now() - start, milliseconds(4000));
  EXPECT_EQ(server.kernel->GetAgent("hal")->GetDecisionCycleCounter(), 20);
}

/// The name of an event; empty for other documents.
std::string EventOf(const std::string& document) {
  const auto message = soarbox::wire::ReadMessage(document);
  const auto* command = message.ok() ? message.value().Command() : nullptr;
  const std::string* event = command ? command->Arg("eventid") : nullptr;
  return event ? *event : std::string();
}

TEST(Protocol, AClientThatOnlyWatchesHoldsUpNoRunAndHearsOfWhatItMissedOnceAndInOrder) {
  Server server;
  sml::Agent* agent = server.kernel->CreateAgent("hal");
  agent->ExecuteCommandLine(kCounterRules);
  Client watcher(server.port());
  for (const char* event : {"system-start", "system-stop"}) {
    watcher.Ask("<command name=\"register_for_event\"><arg param=\"eventid\">" + std::string(event) +
                "</arg></command>");
  }
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 20; ++i) agent->RunSelf(1);
  EXPECT_LT(std::chrono::steady_clock::now() - start, milliseconds(1500)) << "less than a single wait";
  std::vector<std::string> heard;
  for (std::string document = watcher.Receive(); !document.empty(); document = watcher.Receive(milliseconds(1000))) {
    heard.push_back(EventOf(document));
    watcher.Answer(document);
  }
  EXPECT_EQ(heard, (std::vector<std::string>{"system-start", "system-start", "system-stop"}));
}

TEST(Protocol, AnAnswerThatAnEventMayHaveCrossedIsSentOnceMore) {
  Server server;
  sml::Agent* agent = server.kernel->CreateAgent("hal");
  Client client(server.port());
  client.Ask("<command name=\"register_for_event\"><arg param=\"eventid\">system-start</arg></command>");
  agent->RunSelf(1);
  const std::string event = client.Receive();
  ASSERT_EQ(EventOf(event), "system-start");
  const std::string outer =
      client.Exchange("<sml doctype=\"call\" id=\"outer\"><command name=\"version\"></command></sml>");
  EXPECT_NE(outer.find("ack=\"outer\""), std::string::npos);
  const std::string inner =
      client.Exchange("<sml doctype=\"call\" id=\"inner\"><command name=\"is_running\"></command></sml>");
  EXPECT_NE(inner.find("ack=\"inner\""), std::string::npos);
  client.Answer(event);
  EXPECT_EQ(client.Receive(), outer);
  EXPECT_EQ(client.Receive(milliseconds(300)), "");
}

TEST(Protocol, AClientThatLeavesInTheMiddleOfARunIsForgotten) {
  Server server;
  sml::Agent* agent = server.kernel->CreateAgent("hal");
  auto leaving = std::make_unique<Client>(server.port());
  leaving->Ask(
      "<command name=\"register_for_event\"><arg param=\"agent\">hal</arg><arg "
      "param=\"eventid\">print</arg></command>");
  agent->RegisterForRunEvent(
      sml::smlEVENT_AFTER_DECISION_CYCLE,
      [](sml::smlRunEventId, void* data, sml::Agent*, sml::smlPhase) {
        static_cast<std::unique_ptr<Client>*>(data)->reset();
      },
      &leaving);
  agent->RunSelf(20);
  Client other(server.port());
  EXPECT_EQ(other.Ask("<command name=\"version\"></command>"), "<result output=\"raw\">9.6.3</result>");
}

TEST(Protocol, AHundredClientsAreServedAtOnceAndEightMayMakeInput) {
  Server server;
  std::vector<std::unique_ptr<Client>> clients;
  for (int i = 0; i < 100; ++i) clients.push_back(std::make_unique<Client>(server.port()));
  for (auto& client : clients)
    client->Send("<sml doctype=\"call\" id=\"5\"><command name=\"initial_time_tag\"></command></sml>");
  int with_tags = 0;
  for (auto& client : clients) {
    const std::string answer = client->Receive();
    ASSERT_FALSE(answer.empty());
    if (answer.find("<error>") == std::string::npos) ++with_tags;
  }
  EXPECT_EQ(with_tags, 7);
}

/// A connection that has sent only the beginning of a message.
class HalfOpen {
 public:
  explicit HalfOpen(int port) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(send(socket_, "\0\0\1", 3, MSG_NOSIGNAL), 3);
  }
  ~HalfOpen() { close(socket_); }
  HalfOpen(const HalfOpen&) = delete;
  HalfOpen& operator=(const HalfOpen&) = delete;

 private:
  int socket_;
};

TEST(Protocol, WhoHasSaidNothingYetMakesRoomForOthers) {
  Server server;
  Client first(server.port());
  EXPECT_EQ(first.Ask("<command name=\"version\"></command>"), "<result output=\"raw\">9.6.3</result>");
  std::vector<std::unique_ptr<HalfOpen>> silent;
  for (int i = 0; i < 300; ++i) silent.push_back(std::make_unique<HalfOpen>(server.port()));
  std::unique_ptr<sml::Kernel> other(sml::Kernel::CreateRemoteConnection(true, "127.0.0.1", server.port()));
  EXPECT_FALSE(other->HadError()) << other->GetLastErrorDescription();
  EXPECT_EQ(first.Ask("<command name=\"version\"></command>"), "<result output=\"raw\">9.6.3</result>");
  other->Shutdown();
}

TEST(Protocol, WhoComesWhenThereIsNoRoomIsToldSo) {
  Server server;
  std::vector<std::unique_ptr<Client>> clients;
  for (int i = 0; i < 128; ++i) {
    clients.push_back(std::make_unique<Client>(server.port()));
    EXPECT_EQ(clients.back()->Ask("<command name=\"version\"></command>"), "<result output=\"raw\">9.6.3</result>");
  }
  {
    std::unique_ptr<sml::Kernel> late(sml::Kernel::CreateRemoteConnection(true, "127.0.0.1", server.port()));
    EXPECT_TRUE(late->HadError());
    EXPECT_EQ(std::string(late->GetLastErrorDescription()).find("This kernel serves 128 clients already") ==
                  std::string::npos,
              false)
        << late->GetLastErrorDescription();
  }
  EXPECT_EQ(clients.front()->Ask("<command name=\"version\"></command>"), "<result output=\"raw\">9.6.3</result>");
}

TEST(Protocol, AKernelThatRequiresASecretServesThoseWhoShowIt) {
  setenv("SOARBOX_KERNEL_SECRET", "open sesame", 1);
  Server server;
  const auto connect = [&] {
    return std::unique_ptr<sml::Kernel>(sml::Kernel::CreateRemoteConnection(true, "127.0.0.1", server.port()));
  };
  {
    const std::unique_ptr<sml::Kernel> own = connect();
    EXPECT_FALSE(own->HadError()) << own->GetLastErrorDescription();
    EXPECT_NE(own->CreateAgent("mine"), nullptr);
    own->Shutdown();
  }
  setenv("SOARBOX_KERNEL_SECRET", "open sesamf", 1);
  {
    const std::unique_ptr<sml::Kernel> wrong = connect();
    ASSERT_TRUE(wrong->HadError());
    EXPECT_NE(std::string(wrong->GetLastErrorDescription()).find("does not accept this secret"), std::string::npos)
        << wrong->GetLastErrorDescription();
  }
  unsetenv("SOARBOX_KERNEL_SECRET");
  {
    const std::unique_ptr<sml::Kernel> without = connect();
    ASSERT_TRUE(without->HadError());
    EXPECT_NE(std::string(without->GetLastErrorDescription()).find("This kernel requires a secret"), std::string::npos)
        << without->GetLastErrorDescription();
  }
  // The reply to a debugger's first call says so.
  Client debugger(server.port());
  debugger.Send(R"(<sml doctype="call" id="7" smlversion="9.6.3"><command name="create_agent">)"
                R"(<arg param="name">spy</arg></command></sml>)");
  std::string answer = debugger.Receive();
  if (answer.find("doctype=\"notify\"") != std::string::npos) answer = debugger.Receive();
  EXPECT_NE(answer.find("ack=\"7\""), std::string::npos) << answer;
  EXPECT_NE(answer.find("requires a secret"), std::string::npos) << answer;
  EXPECT_EQ(server.kernel->GetAgent("spy"), nullptr);
}

TEST(Protocol, ASecretIsShownToKernelsThatRequireNone) {
  Server server;
  setenv("SOARBOX_KERNEL_SECRET", "open sesame", 1);
  const std::unique_ptr<sml::Kernel> client(sml::Kernel::CreateRemoteConnection(true, "127.0.0.1", server.port()));
  unsetenv("SOARBOX_KERNEL_SECRET");
  EXPECT_FALSE(client->HadError()) << client->GetLastErrorDescription();
  client->Shutdown();
}

TEST(Protocol, AKernelIsFoundAtTheFileForItsPortAndLeavesNoneBehind) {
  const std::filesystem::path home =
      std::filesystem::path(testing::TempDir()) / ("soarbox-home-" + std::to_string(getpid()));
  std::filesystem::create_directories(home);
  const char* real_home = std::getenv("HOME");
  const std::string before = real_home ? real_home : "";
  setenv("HOME", home.c_str(), 1);
  int port = 0;
  {
    Server probe;
    port = probe.port();
    // A kernel on any port can be found by its process.
    EXPECT_TRUE(std::filesystem::is_socket(home / ".soartmp" / std::to_string(getpid())));
  }
  EXPECT_FALSE(std::filesystem::exists(home / ".soartmp" / std::to_string(getpid())));
  const std::filesystem::path file = home / ".soartmp" / std::to_string(port);
  EXPECT_EQ(std::filesystem::status(home / ".soartmp").permissions(), std::filesystem::perms::owner_all);
  {
    // Files that a killed kernel left there.
    const int stale = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    file.string().copy(address.sun_path, sizeof address.sun_path - 1);
    ASSERT_EQ(bind(stale, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    close(stale);
  }
  std::unique_ptr<sml::Kernel> kernel(sml::Kernel::CreateKernelInNewThread(port));
  ASSERT_FALSE(kernel->HadError()) << kernel->GetLastErrorDescription();
  {
    IoThread io;
    auto connected = soarbox::wire::ConnectLocal(io, file.string());
    ASSERT_TRUE(connected.ok());
    std::string answer;
    connected.value()->Send("<sml doctype=\"call\" id=\"1\"><command name=\"version\"></command></sml>");
    EXPECT_TRUE(connected.value()->Wait(answer, milliseconds(5000)));
    EXPECT_NE(answer.find("<result output=\"raw\">9.6.3</result>"), std::string::npos);
  }
  const std::unique_ptr<sml::Kernel> remote(sml::Kernel::CreateRemoteConnection(true, nullptr, port));
  EXPECT_FALSE(remote->HadError());
  EXPECT_NE(remote->CreateAgent("a"), nullptr);
  remote->Shutdown();
  kernel.reset();
  EXPECT_FALSE(std::filesystem::exists(file));
  setenv("HOME", before.c_str(), 1);
  std::filesystem::remove_all(home);
}

TEST(Protocol, ADebuggersStartAndItsStopButtonWorkWhileAnAgentRuns) {
  Server server;
  sml::Agent* agent = server.kernel->CreateAgent("hal");
  agent->ExecuteCommandLine(kCounterRules);
  Client debugger(server.port());
  debugger.Ask("<command name=\"register_for_event\"><arg param=\"eventid\">after-agent-reinitialized</arg></command>");
  debugger.Ask("<command name=\"initial_time_tag\"></command>");
  EXPECT_NE(debugger.Ask("<command name=\"get_agent_list\"></command>").find("<name>hal</name>"), std::string::npos);
  for (const char* event : {"after-agent-created", "before-agent-destroyed", "interrupt-check",
                            "after-all-output-phases", "system-start", "system-stop", "system-property-changed"}) {
    EXPECT_EQ(debugger.Ask("<command name=\"register_for_event\"><arg param=\"eventid\">" + std::string(event) +
                           "</arg></command>"),
              "");
  }
  EXPECT_EQ(debugger.Ask("<command name=\"set_interrupt_check_rate\"><arg param=\"value\">50</arg></command>"), "");
  for (const char* event : {"print", "echo", "xml-trace-output", "after-decision-cycle"}) {
    EXPECT_EQ(
        debugger.Ask("<command name=\"register_for_event\"><arg param=\"agent\">hal</arg><arg param=\"eventid\">" +
                     std::string(event) + "</arg></command>"),
        "");
  }
  EXPECT_NE(
      debugger.Ask("<command name=\"cmdline\"><arg param=\"agent\">hal</arg><arg param=\"line\">watch</arg></command>")
          .find("param=\"watchdecisions\""),
      std::string::npos);
  std::thread runner([&] { agent->RunSelfForever(); });
  while (debugger.Ask("<command name=\"is_running\"></command>") != "<result output=\"raw\">true</result>")
    std::this_thread::yield();
  EXPECT_NE(debugger.Line("hal", "print s1").find("^superstate nil"), std::string::npos);
  EXPECT_EQ(debugger.Line("hal", "stop-soar"), "<result output=\"raw\"></result>");
  // Replies to further events, so that the run can end.
  while (debugger.Ask("<command name=\"is_running\"></command>") == "<result output=\"raw\">true</result>") continue;
  runner.join();
  EXPECT_TRUE(debugger.Heard("system-start"));
  EXPECT_TRUE(debugger.Heard("print"));
}

}  // namespace
