// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "serve/server_settings.h"
#include "sim/scenario.h"

namespace soarbox::app {

/// The lessons and worlds that come with the program, read once.
class ShippedCatalog final : public serve::Catalog {
 public:
  /// Errors in lessons are printed on standard error.
  explicit ShippedCatalog(const sim::DataFolders& data);

  std::vector<serve::Lesson> Lessons() const override { return lessons_; }
  std::vector<Scenario> Scenarios() const override { return scenarios_; }
  std::vector<serve::Game> Games() const override;
  Recording Describe(const std::filesystem::path& recording) const override;
  serve::Progress ProgressOf(const std::filesystem::path& state, const std::string& lesson) const override;

 private:
  std::vector<serve::Lesson> lessons_;
  std::map<std::string, std::vector<std::string>> hints_;  ///< By lesson.
  std::vector<Scenario> scenarios_;
};

/// Whether a name only contains letters, digits and their separators, so that it is not a path.
bool IsPlainName(std::string_view name);

}  // namespace soarbox::app
