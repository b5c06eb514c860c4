// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/message.h"

#include <cstdio>

#include "diagnostics/problem.h"
#include "sml/wire/xml_reader.h"
#include "sml/wire/xml_writer.h"

namespace soarbox::wire {

namespace {

std::string_view DocTypeName(DocType type) {
  switch (type) {
    case DocType::kCall:
      return "call";
    case DocType::kResponse:
      return "response";
    case DocType::kNotify:
      return "notify";
  }
  return "notify";
}

Diagnostic NotAMessage(std::string_view why) {
  return NewProblem(std::string(why));
}

}  // namespace

Message MakeCall(std::string_view command) {
  Message message;
  message.root.tag = "sml";
  message.root.Add("command").Set("name", std::string(command));
  return message;
}

Message MakeResponse(std::string_view ack) {
  Message message;
  message.type = DocType::kResponse;
  message.ack = ack;
  message.root.tag = "sml";
  return message;
}

void AddRawResult(Message& response, std::string_view text) {
  response.root.Add("result").Set("output", "raw").text = text;
}

void AddError(Message& response, std::string_view text, std::string_view code) {
  AddRawResult(response, text);
  Element& error = response.root.Add("error");
  if (!code.empty()) error.Set("code", std::string(code));
  error.text = text;
}

std::string ToDocument(const Message& message) {
  std::string out = "<sml";
  if (message.type == DocType::kResponse) {
    out += " ack=\"";
    AppendEscaped(out, message.ack);
    out += '"';
  }
  out += " doctype=\"";
  out += DocTypeName(message.type);
  out += "\" id=\"";
  AppendEscaped(out, message.id);
  out += "\" smlversion=\"";
  out += kSmlVersion;
  out += "\">";
  for (const Element& child : message.root.children) AppendXml(out, child);
  out += "</sml>";
  return out;
}

Result<Message> ReadMessage(std::string_view document) {
  Result<Element> read = ReadXml(document);
  if (!read) return read.error();
  Message message;
  message.root = std::move(read.value());
  if (message.root.tag != "sml") return NotAMessage("the document's element is not <sml>");
  const std::string* type = message.root.Attribute("doctype");
  if (!type) return NotAMessage("the document has no doctype");
  if (*type == "call") {
    message.type = DocType::kCall;
  } else if (*type == "response") {
    message.type = DocType::kResponse;
  } else if (*type == "notify") {
    message.type = DocType::kNotify;
  } else {
    return NotAMessage("the doctype is neither call, response nor notify");
  }
  if (const std::string* id = message.root.Attribute("id")) message.id = *id;
  if (const std::string* ack = message.root.Attribute("ack")) message.ack = *ack;
  return message;
}

std::string ShortDouble(double value) {
  char buffer[40];
  const int length = std::snprintf(buffer, sizeof buffer, "%.16g", value);
  return std::string(buffer, static_cast<std::size_t>(length));
}

std::string FixedDouble(double value) {
  char buffer[400];
  const int length = std::snprintf(buffer, sizeof buffer, "%f", value);
  return std::string(buffer, static_cast<std::size_t>(length));
}

}  // namespace soarbox::wire
