// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sml_ClientWMElement.h"

namespace sml {

/// An element with a floating-point value.
class EXPORT FloatElement : public WMElement {
 public:
  ~FloatElement() override;

  double GetValue() const { return value_; }

  /// Same as Agent::Update(this, value).
  void Update(double value);

  char const* GetValueType() const override { return "double"; }
  char const* GetValueAsString() const override;
  char const* GetValueAsString(std::string& buf) const override;
  FloatElement* ConvertToFloatElement() override { return this; }

 private:
  friend class WorkingMemory;
  friend class ObjectPool<FloatElement>;
  FloatElement() : WMElement(Kind::kFloat) {}

  double value_ = 0.0;
};

}  // namespace sml
