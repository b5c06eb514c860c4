// SPDX-License-Identifier: BSD-2-Clause
// Runs one conformance case against any library that offers the SML client API
// (sml_Client.h) and prints a transcript: every command, what the agent printed
// while it ran, and the command's result.
//
//   trace_case CASE.cmd [VERSION]     (run in the folder of the case)
//
// VERSION: if versions of Soar differ, the agent behaves like this one (`soar like`, which only Soarbox has).
//
// A line of CASE.cmd is a Soar command line, or one of these directives:
//   !wme NAME PARENT TYPE ATTR [VALUE]   create a WME; PARENT is `il` or the NAME of an earlier id WME;
//                                        TYPE is string | int | float | id | shared (VALUE names an id WME)
//   !update NAME VALUE                   change the value of a string, int or float WME
//   !destroy NAME                        remove a WME
//   !run N                               run this agent N decision cycles (RunSelf)
//   !run-self N STEP                     the same with a step size: decision | phase | elaboration (RunSelf)
//   !run-all N STEP                      run all agents with a step size (RunAllAgents)
//   !til-output                          run this agent until it produces output (RunSelfTilOutput)
//   !commands                            list the commands on the output link with their string parameters
//   !complete | !error                   add ^status complete / error to every listed command
//   !rhs NAME                            register a RHS function that returns its argument in brackets
//   !init                                init-soar through the client API
//   !autocommit on|off                   commit every input change at once, or only on request
//   !commit                              commit the input changes made so far
//   !svs LINE                            send a line to the scene of the top state (SendSVSInput)
//   !svs? QUERY                          query that scene (SVSQuery)
// Empty lines and lines that begin with # are skipped.
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "sml_Client.h"

using namespace sml;

namespace {
std::string transcript;

void on_print(smlPrintEventId, void*, Agent*, char const* text) {
  transcript += text;
}

std::string on_rhs(smlRhsEventId, void*, Agent*, char const*, char const* argument) {
  return std::string("[") + argument + "]";
}

void flush(std::string const& result) {
  std::string text = transcript + result;
  transcript.clear();
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  if (!text.empty()) std::cout << text << "\n";
}

smlRunStepSize step_size(std::string const& step) {
  return step == "phase" ? sml_PHASE : step == "elaboration" ? sml_ELABORATION : sml_DECIDE;
}

void print_identifier(Identifier* id, std::string const& indent, int depth) {
  for (int i = 0; i < id->GetNumberChildren(); ++i) {
    WMElement* child = id->GetChild(i);
    std::cout << indent << "^" << child->GetAttribute() << " "
              << (child->IsIdentifier() ? "(id)" : child->GetValueAsString()) << " [" << child->GetValueType() << "]\n";
    if (child->IsIdentifier() && depth > 0) print_identifier(child->ConvertToIdentifier(), indent + "  ", depth - 1);
  }
}
}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::cerr << "usage: trace_case CASE.cmd [VERSION]\n";
    return 2;
  }
  std::ifstream in(argv[1]);
  if (!in) {
    std::cerr << "cannot read " << argv[1] << "\n";
    return 2;
  }

  Kernel* kernel = Kernel::CreateKernelInCurrentThread(true, Kernel::kUseAnyPort);
  if (kernel->HadError()) {
    std::cerr << kernel->GetLastErrorDescription() << "\n";
    return 2;
  }
  Agent* agent = kernel->CreateAgent("soar");
  agent->RegisterForPrintEvent(smlEVENT_PRINT, on_print, nullptr);
  if (argc == 3) agent->ExecuteCommandLine((std::string("soar like ") + argv[2]).c_str());

  std::map<std::string, WMElement*> wmes;
  std::map<std::string, Identifier*> ids{{"il", agent->GetInputLink()}};

  std::string line;
  while (std::getline(in, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::cout << "% " << line << "\n";
    if (line[0] != '!') {
      std::string result = agent->ExecuteCommandLine(line.c_str());
      flush((agent->GetLastCommandLineResult() ? "" : "[error] ") + result);
      continue;
    }
    std::istringstream words(line.substr(1));
    std::string verb;
    words >> verb;
    if (verb == "wme") {
      std::string name, parent, type, attr, value;
      words >> name >> parent >> type >> attr >> value;
      Identifier* p = ids.at(parent);
      if (type == "string")
        wmes[name] = agent->CreateStringWME(p, attr.c_str(), value.c_str());
      else if (type == "int")
        wmes[name] = agent->CreateIntWME(p, attr.c_str(), std::atoll(value.c_str()));
      else if (type == "float")
        wmes[name] = agent->CreateFloatWME(p, attr.c_str(), std::atof(value.c_str()));
      else if (type == "id") {
        Identifier* id = agent->CreateIdWME(p, attr.c_str());
        ids[name] = id;
        wmes[name] = id;
      } else if (type == "shared")
        wmes[name] = agent->CreateSharedIdWME(p, attr.c_str(), ids.at(value));
    } else if (verb == "update") {
      std::string name, value;
      words >> name >> value;
      WMElement* w = wmes.at(name);
      std::string type = w->GetValueType();
      if (type == "int")
        agent->Update(static_cast<IntElement*>(w), std::atoll(value.c_str()));
      else if (type == "double")
        agent->Update(static_cast<FloatElement*>(w), std::atof(value.c_str()));
      else
        agent->Update(static_cast<StringElement*>(w), value.c_str());
    } else if (verb == "destroy") {
      std::string name;
      words >> name;
      agent->DestroyWME(wmes.at(name));
      wmes.erase(name);
    } else if (verb == "run") {
      int n = 1;
      words >> n;
      agent->RunSelf(n);
      flush("");
    } else if (verb == "run-self") {
      int n = 1;
      std::string step;
      words >> n >> step;
      agent->RunSelf(n, step_size(step));
      flush("");
    } else if (verb == "run-all") {
      int n = 1;
      std::string step;
      words >> n >> step;
      kernel->RunAllAgents(n, step_size(step));
      flush("");
    } else if (verb == "autocommit") {
      std::string mode;
      words >> mode;
      kernel->SetAutoCommit(mode == "on");
    } else if (verb == "commit")
      agent->Commit();
    else if (verb == "svs" || verb == "svs?") {
      std::string lines;
      std::getline(words >> std::ws, lines);
      if (verb == "svs")
        agent->SendSVSInput(lines);
      else
        std::cout << agent->SVSQuery(lines) << "\n";
    } else if (verb == "til-output") {
      agent->RunSelfTilOutput();
      flush("");
    } else if (verb == "commands") {
      for (int i = 0; i < agent->GetNumberCommands(); ++i) {
        Identifier* command = agent->GetCommand(i);
        std::cout << command->GetCommandName() << "\n";
        print_identifier(command, "  ", 3);
      }
    } else if (verb == "complete" || verb == "error") {
      for (int i = 0; i < agent->GetNumberCommands(); ++i) {
        if (verb == "complete")
          agent->GetCommand(i)->AddStatusComplete();
        else
          agent->GetCommand(i)->AddStatusError();
      }
      agent->ClearOutputLinkChanges();
    } else if (verb == "rhs") {
      std::string name;
      words >> name;
      kernel->AddRhsFunction(name.c_str(), on_rhs, nullptr);
    } else if (verb == "init") {
      std::string result = agent->InitSoar();
      flush(result);
    } else
      std::cout << "[unknown directive]\n";
  }
  kernel->Shutdown();
  delete kernel;
}
