// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soarbox::wire {

/// An element of a message: a tag, attributes, and either text or child elements.
struct Element {
  std::string tag;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<Element> children;
  std::string text;

  Element() = default;
  explicit Element(std::string element_tag) : tag(std::move(element_tag)) {}

  Element& Set(std::string name, std::string value) {
    attributes.emplace_back(std::move(name), std::move(value));
    return *this;
  }
  Element& Add(std::string child_tag) { return children.emplace_back(std::move(child_tag)); }
  /// A child <arg param="name">value</arg>.
  Element& AddArg(std::string name, std::string value) {
    Element& arg = Add("arg");
    arg.Set("param", std::move(name));
    arg.text = std::move(value);
    return *this;
  }

  /// The value of an attribute; null if it does not exist.
  const std::string* Attribute(std::string_view name) const;
  /// The first child with that tag; null if there is none.
  const Element* Child(std::string_view child_tag) const;
  /// The text of the first <arg> with that name; null if there is none.
  const std::string* Arg(std::string_view name) const;
};

}  // namespace soarbox::wire
