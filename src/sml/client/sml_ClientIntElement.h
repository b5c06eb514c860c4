// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sml_ClientWMElement.h"

namespace sml {

/// An element with a 64-bit integer value.
class EXPORT IntElement : public WMElement {
 public:
  ~IntElement() override;

  long long GetValue() const { return value_; }

  /// Same as Agent::Update(this, value).
  void Update(long long value);

  char const* GetValueType() const override { return "int"; }
  char const* GetValueAsString() const override;
  char const* GetValueAsString(std::string& buf) const override;
  IntElement* ConvertToIntElement() override { return this; }

 private:
  friend class WorkingMemory;
  friend class ObjectPool<IntElement>;
  IntElement() : WMElement(Kind::kInt) {}

  long long value_ = 0;
};

}  // namespace sml
