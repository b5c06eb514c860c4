// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

/// A file with rules that exists as long as the object.
class RuleFile {
 public:
  /// Tests run in parallel in separate processes, so the name contains the process.
  RuleFile(const std::string& name, const std::string& rules)
      : path_(std::filesystem::temp_directory_path() / (name + "_" + std::to_string(getpid()) + ".soar")) {
    std::ofstream(path_) << rules;
  }
  ~RuleFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// An agent that distinguishes far from near: ^distance above 3 gives (forward), else (stop), until the command is
/// completed.
inline constexpr const char* kMoverRules = R"(
sp {propose*forward (state <s> ^superstate nil ^io <io>) (<io> ^input-link.distance > 3 ^output-link <ol>) -(<ol> ^forward)
  --> (<s> ^operator <o> + =) (<o> ^name forward)}
sp {propose*stop (state <s> ^superstate nil ^io <io>) (<io> ^input-link.distance <= 3 ^output-link <ol>) -(<ol> ^stop)
  --> (<s> ^operator <o> + =) (<o> ^name stop)}
sp {apply*act (state <s> ^operator.name { << forward stop >> <n> } ^io <io>) (<io> ^output-link <ol> ^input-link.distance <d>)
  --> (<ol> ^<n> <c>) (<c> ^speed <d> ^mode walk)}
sp {apply*cleanup (state <s> ^operator.name { << forward stop >> } ^io.output-link <ol>) (<ol> ^<n> <c>) (<c> ^status complete)
  --> (<ol> ^<n> <c> -)}
sp {propose*cleanup (state <s> ^superstate nil ^io.output-link.<n> <c>) (<c> ^status complete)
  --> (<s> ^operator <o> + >) (<o> ^name cleanup)}
sp {apply*cleanup*operator (state <s> ^operator.name cleanup ^io.output-link <ol>) (<ol> ^<n> <c>) (<c> ^status complete)
  --> (<ol> ^<n> <c> -)}
)";

/// An agent that counts forever.
inline constexpr const char* kCounterRules =
    "sp {start (state <s> ^superstate nil -^count) --> (<s> ^operator <o> +) (<o> ^name start)}\n"
    "sp {start*apply (state <s> ^operator.name start) --> (<s> ^count 0)}\n"
    "sp {count (state <s> ^count <c>) --> (<s> ^operator <o> + =) (<o> ^name count ^from <c>)}\n"
    "sp {count*apply (state <s> ^operator <o> ^count <c>) (<o> ^name count ^from <c>) --> (<s> ^count <c> - (+ <c> "
    "1))}\n";
