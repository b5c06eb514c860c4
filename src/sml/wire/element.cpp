// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/element.h"

namespace soarbox::wire {

const std::string* Element::Attribute(std::string_view name) const {
  for (const auto& [key, value] : attributes) {
    if (key == name) return &value;
  }
  return nullptr;
}

const Element* Element::Child(std::string_view child_tag) const {
  for (const Element& child : children) {
    if (child.tag == child_tag) return &child;
  }
  return nullptr;
}

const std::string* Element::Arg(std::string_view name) const {
  for (const Element& child : children) {
    if (child.tag != "arg") continue;
    const std::string* param = child.Attribute("param");
    if (param && *param == name) return &child.text;
  }
  return nullptr;
}

}  // namespace soarbox::wire
