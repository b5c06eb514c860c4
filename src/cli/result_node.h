// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace soarbox::cli {

/// A structured answer: an element with attributes, children and text, which XML and JSON can both represent.
struct ResultNode {
  std::string tag;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<ResultNode> children;
  std::string text;

  ResultNode& Add(std::string child_tag) {
    children.push_back(ResultNode{std::move(child_tag), {}, {}, {}});
    return children.back();
  }
  ResultNode& Set(std::string name, std::string value) {
    attributes.emplace_back(std::move(name), std::move(value));
    return *this;
  }
  /// A child <arg param="..." type="...">value</arg>, the usual way to return a value of a command.
  void AddArgument(std::string param, std::string type, std::string value) {
    ResultNode& argument = Add("arg");
    argument.Set("param", std::move(param)).Set("type", std::move(type));
    argument.text = std::move(value);
  }
};

/// The result of a command line.
struct CommandResult {
  bool ok = true;
  std::string text;                             ///< As Soar prints it: the output, followed by the message of a
                                                ///< failure.
  ResultNode structured{"result", {}, {}, {}};  ///< The result for programs; empty if the command only printed text.
  std::vector<Diagnostic> diagnostics;          ///< Errors with file, line, column and hint; warnings too.
  std::vector<Diagnostic> traps;                ///< Warnings that require all rules to be known.
};

}  // namespace soarbox::cli
