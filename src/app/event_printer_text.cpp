// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "app/event_printer.h"
#include "diagnostics/plain_text.h"
#include "sim/findings.h"

namespace soarbox::app {
namespace {

class TextPrinter : public EventPrinter {
 public:
  TextPrinter(std::ostream& out, std::ostream& errors) : out_(out), errors_(errors) {}

  void Begin(const RunHeader& header) override {
    out_ << fmt::format("soarbox: scenario {}, seed {}{}\n", header.scenario, header.seed,
                        header.headless ? ", headless" : "");
  }

  void Print(const sim::RunEvent& event) override {
    switch (event.kind) {
      case sim::EventKind::kAgentCreated:
        Line(event, "joins: " + event.text);
        break;
      case sim::EventKind::kCommand:
        if (!event.has_perceived) {
          Line(event, event.text + (event.parameters.empty() ? "" : " " + event.parameters));
          break;
        }
        Line(event, fmt::format("{:<14} perceives distance {:.2f}, is at ({:.1f}, {:.1f})", event.text, event.perceived,
                                event.position.x, event.position.z));
        break;
      case sim::EventKind::kOutcome:
      case sim::EventKind::kNews:
        Line(event, event.news + ": " + event.text);
        break;
      case sim::EventKind::kEnded:
        Line(event, "reached: " + event.text);
        break;
      case sim::EventKind::kGap:
        Line(event, "no command: " + event.text);
        for (const explain::Reason& reason : event.reasons) out_ << fmt::format("{:27}- {}\n", "", reason.text);
        break;
      case sim::EventKind::kLog:
        Line(event, event.text);
        break;
      case sim::EventKind::kAnswer:
        if (!event.text.empty()) Line(event, event.text);
        break;
      case sim::EventKind::kMindLost:
        Line(event, "paused: " + event.text);
        break;
      case sim::EventKind::kMindBack:
        Line(event, "resumes: " + event.text);
        break;
      case sim::EventKind::kAgentFailed:
        Line(event, "stops: its script failed");
        Problem(event.diagnostic);
        break;
      case sim::EventKind::kMindFailed:
        Line(event, "stops: its Soar program failed");
        Problem(event.diagnostic);
        break;
      case sim::EventKind::kDiagnostic:
        Problem(event.diagnostic);
        break;
    }
  }

  void Report(const world::SceneSnapshot& snapshot) override {
    for (const world::AgentSnapshot& agent : snapshot.agents) {
      sim::RunEvent event;
      event.time_s = snapshot.time_s;
      event.agent = agent.name;
      Line(event, fmt::format("at ({:7.2f}, {:6.2f}, {:7.2f})  {:5.2f} m/s  {}", agent.position.x, agent.position.y,
                              agent.position.z, world::Length(agent.velocity), agent.last_command));
    }
  }

  void End(const RunFooter& footer) override {
    const auto counted = [](std::uint64_t number, const char* word) {
      return fmt::format("{} {}{}", number, word, number == 1 ? "" : "s");
    };
    PrintFindings(footer);
    out_ << fmt::format(
        "soarbox: {}, {:.1f} s simulated, {} ({} of them Soar), {}, state {:016x}\n", counted(footer.ticks, "tick"),
        footer.time_s, counted(footer.agents, "agent"), footer.soar_agents,
        // After a list of what went wrong, "0 problems" would contradict it.
        counted(footer.problems, footer.problems == 0 && IsWrong(footer) ? "error" : "problem"), footer.state_hash);
    out_.flush();
  }

 private:
  /// An agent may have nothing to do, for example after a fight. Such findings alone are not called wrong.
  static bool IsWrong(const RunFooter& footer) {
    return footer.problems > 0 || std::ranges::any_of(footer.findings, [](const sim::Finding& finding) {
             return finding.cause <= sim::Cause::kRefused;
           });
  }

  void PrintFindings(const RunFooter& footer) {
    constexpr std::size_t kMost = 5;
    const std::vector<sim::Finding>& findings = footer.findings;
    if (findings.empty()) return;
    out_ << (IsWrong(footer) ? "soarbox: what went wrong, the cause first:\n"
                             : "soarbox: when agents had nothing to do, and why:\n");
    for (std::size_t i = 0; i < findings.size() && i < kMost; ++i)
      out_ << fmt::format("  {}. {}\n", i + 1, Printable(findings[i].text, "", findings[i].text.size()));
    if (findings.size() > kMost) out_ << fmt::format("  and {} more\n", findings.size() - kMost);
  }

  void Line(const sim::RunEvent& event, const std::string& text) {
    // Texts of scripts and rules are printed unchanged, except for terminal control sequences.
    out_ << fmt::format("{:8.2f} s  {:<14} {}\n", event.time_s,
                        event.agent.empty() ? "sandbox" : Printable(event.agent, nullptr),
                        Printable(text, "", text.size()));
  }

  /// Flushes first, so that the problem appears at the right place if both streams share a terminal.
  void Problem(const Diagnostic& diagnostic) {
    out_.flush();
    errors_ << Format(diagnostic);
  }

  std::ostream& out_;
  std::ostream& errors_;
};

}  // namespace

std::unique_ptr<EventPrinter> EventPrinter::MakeText(std::ostream& out, std::ostream& errors) {
  return std::make_unique<TextPrinter>(out, errors);
}

}  // namespace soarbox::app
