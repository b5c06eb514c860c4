// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "app/engine/engine_page.h"
#include "app/lesson_desk.h"
#include "diagnostics/problem.h"
#include "workbench/pace.h"
#include "workbench/surroundings.h"

namespace soarbox::app {

/// The surroundings of a desk in an engine.
class EngineDesk final : public workbench::Surroundings {
 public:
  /// `lessons` may be null, for a recording.
  EngineDesk(EnginePage& page, workbench::Pace& pace, LessonDesk* lessons, std::filesystem::path home)
      : page_(page), pace_(pace), lessons_(lessons), home_(std::move(home)) {}

  bool IsPaused() const override { return pace_.paused(); }
  void Pause() override { pace_.Pause(); }
  void GoOn() override { pace_.Resume(); }
  void SetSpeed(double speed) override { pace_.SetSpeed(speed); }
  void Tell(std::string remark) override { page_.Tell(remark); }
  Result<void> OpenInEditor(const std::string&, int) override {
    return NewProblem("a page opens no editor of this machine", "edit the file in the page");
  }
  Result<void> OpenRun(const std::string&, const std::string&) override {
    return NewProblem("an engine has one run", "the page opens another one");
  }
  bool MayWrite(const std::filesystem::path& file) const override { return IsOwn(file); }
  bool IsOwn(const std::filesystem::path& file) const override {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::weakly_canonical(file, error);
    const auto [end, ignored] = std::mismatch(home_.begin(), home_.end(), real.begin(), real.end());
    return !error && end == home_.end();
  }
  workbench::Lessons* lessons() override { return lessons_; }

 private:
  EnginePage& page_;
  workbench::Pace& pace_;
  LessonDesk* lessons_;
  std::filesystem::path home_;  ///< Canonical.
};

}  // namespace soarbox::app
