// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sml_ClientWMElement.h"

namespace sml {

/// An element with a string value.
class EXPORT StringElement : public WMElement {
 public:
  ~StringElement() override;

  char const* GetValue() const { return value_.c_str(); }

  /// Same as Agent::Update(this, value).
  void Update(char const* value);

  char const* GetValueType() const override { return "string"; }
  char const* GetValueAsString() const override;
  char const* GetValueAsString(std::string& buf) const override;
  StringElement* ConvertToStringElement() override { return this; }

 private:
  friend class WorkingMemory;
  friend class ObjectPool<StringElement>;
  StringElement() : WMElement(Kind::kString) {}

  std::string value_;
};

}  // namespace sml
