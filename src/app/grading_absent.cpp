// SPDX-License-Identifier: BSD-2-Clause
// Where there are no other processes (WebAssembly): rules are graded in this one, and the run waits meanwhile.
#include <iostream>
#include <sstream>
#include <utility>

#include "app/grading.h"
#include "app/learn_command.h"

namespace soarbox::app {
namespace {

/// Takes what is printed on a stream, for as long as it lives.
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

struct Grading::Work {
  LearnOptions options;
};

Grading::Grading() = default;
Grading::~Grading() = default;

Result<void> Grading::Start(const std::string& lesson, const std::filesystem::path& folder,
                            const std::filesystem::path& from) {
  LearnOptions options;
  options.words = {"check", lesson};
  options.folder = folder;
  options.from = from;
  options.progress = true;
  work_ = std::make_unique<Work>(Work{std::move(options)});
  text_.clear();
  return {};
}

void Grading::Stop() {
  work_.reset();
}

bool Grading::Poll() {
  if (work_ == nullptr) return false;
  std::ostringstream text;
  const Printed out(std::cout, text), errors(std::cerr, text);
  Learn(work_->options);
  work_.reset();
  text_ = text.str();
  return true;
}

}  // namespace soarbox::app
