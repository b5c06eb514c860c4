// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>

namespace soarbox::kernel {

/// The name of a file as the user specified it. Copies share the text, because many rules are in one file.
class FileName {
 public:
  FileName() = default;
  FileName(std::string name) : text_(std::make_shared<const std::string>(std::move(name))) {}
  FileName(const char* name) : FileName(std::string(name)) {}

  const std::string& text() const {
    static const std::string kNone;
    return text_ == nullptr ? kNone : *text_;
  }

 private:
  std::shared_ptr<const std::string> text_;
};

}  // namespace soarbox::kernel
