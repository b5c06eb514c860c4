// SPDX-License-Identifier: BSD-2-Clause
// For systems without other processes (WebAssembly). If the JavaScript that runs this module has functions
// soarboxGrade(lesson, from) and soarboxStopGrading(), another module grades, and its output arrives by
// soarbox_graded(). Otherwise this module grades, and the run waits meanwhile.
#include <emscripten.h>

#include <iostream>
#include <sstream>
#include <utility>

#include "app/grading.h"
#include "app/learn_command.h"

namespace soarbox::app {
namespace {

/// The output of the other module.
struct Told {
  std::string text;
  bool is_over = false;
};
Told& ToldElsewhere() {
  static Told told;
  return told;
}

/// Captures the output of a stream while it exists.
class Printed {
 public:
  Printed(std::ostream& stream, std::ostringstream& text) : stream_(stream), before_(stream.rdbuf(text.rdbuf())) {}
  ~Printed() { stream_.rdbuf(before_); }
  Printed(const Printed&) = delete;
  Printed& operator=(const Printed&) = delete;

 private:
  std::ostream& stream_;
  std::streambuf* before_;
};

}  // namespace

// clang-format off
EM_JS(bool, SoarboxGradesElsewhere, (const char* lesson, const char* from), {
  if (typeof Module["soarboxGrade"] !== "function") return false;
  Module["soarboxGrade"](UTF8ToString(lesson), UTF8ToString(from));
  return true;
});
EM_JS(void, SoarboxStopsGrading, (), { Module["soarboxStopGrading"](); });
// clang-format on

extern "C" {
/// Adds output of the other module. `is_over`: the other module has ended.
EMSCRIPTEN_KEEPALIVE void soarbox_graded(const char* text, int is_over) {
  ToldElsewhere().text += text;
  ToldElsewhere().is_over = is_over != 0;
}
}

struct Grading::Work {
  LearnOptions options;
  bool is_elsewhere = false;
};

Grading::Grading() = default;
Grading::~Grading() {
  Stop();
}

Result<void> Grading::Start(const std::string& lesson, const std::filesystem::path& folder,
                            const std::filesystem::path& from) {
  LearnOptions options;
  options.words = {"check", lesson};
  options.folder = folder;
  options.from = from;
  options.progress = true;
  ToldElsewhere() = {};
  const bool is_elsewhere = SoarboxGradesElsewhere(lesson.c_str(), from.c_str());
  work_ = std::make_unique<Work>(Work{std::move(options), is_elsewhere});
  text_.clear();
  return {};
}

void Grading::Stop() {
  if (work_ != nullptr && work_->is_elsewhere) SoarboxStopsGrading();
  work_.reset();
}

bool Grading::Poll() {
  if (work_ == nullptr) return false;
  if (work_->is_elsewhere) {
    text_ = ToldElsewhere().text;
    if (!ToldElsewhere().is_over) return false;
  } else {
    std::ostringstream text;
    const Printed out(std::cout, text), errors(std::cerr, text);
    Learn(work_->options);
    text_ = text.str();
  }
  work_.reset();
  return true;
}

}  // namespace soarbox::app
