// SPDX-License-Identifier: BSD-2-Clause
// Generates the page's reader of the records of a scene's stream.
#include <cctype>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "stream/scene_layout.h"

namespace soarbox::stream {
namespace {

/// "PER" in TypeScript: a whole number without a point.
std::string Whole(double number) {
  return std::to_string(static_cast<long long>(number));
}

/// Writes the type of a record, its least number of bytes, and the function that reads it.
class RecordText {
 public:
  void Type(std::string_view name, std::string_view about) {
    name_ = name;
    about_ = about;
  }
  void Number(std::string_view name, std::uint64_t) { Add(name, "number", "input.number()", 1); }
  void Steps(std::string_view name, double, double per_unit) {
    Add(name, "number", "input.signed() / " + Whole(per_unit), 1);
  }
  void Share(std::string_view name, double, double per_unit) {
    Add(name, "number", "input.byte() / " + Whole(per_unit), 1);
  }
  void Float(std::string_view name, float) { Add(name, "number", "input.float()", 4); }
  void Floats(std::string_view name, const world::Vec3&) { Add(name, "Vec3", "readFloats(input)", 12); }
  void Flag(std::string_view name, bool) { Add(name, "boolean", "input.byte() !== 0", 1); }
  void IsZero(std::string_view name, std::uint8_t) { Add(name, "boolean", "input.byte() === 0", 1); }
  void Flags(FlagList flags) {
    reads_ += "  const flags = input.byte();\n";
    least_bytes_ += 1;
    unsigned bit = 1;
    for (const stream::Flag& flag : flags) {
      AddField(flag.first, "boolean", ": (flags & " + std::to_string(bit) + ") !== 0");
      bit *= 2;
    }
  }
  void Words(std::string_view name, std::uint8_t, std::span<const std::string_view> words) {
    std::string list, type;
    for (const std::string_view word : words) {
      list += (list.empty() ? "\"" : ", \"") + std::string(word) + "\"";
      type += (type.empty() ? "\"" : " | \"") + std::string(word) + "\"";
    }
    Add(name, type, "([" + list + "] as const)[input.byte()] ?? \"" + std::string(words.back()) + "\"", 1);
  }
  void Color(std::string_view name, const world::Color&) { Add(name, "Color", "readColor(input)", 4); }
  void Word(std::string_view name, std::string_view) { Add(name, "string", "values.word()", 1); }
  void Turn(std::string_view name, const world::Quat&) {
    Add(name, "Quat", "readTurn(input, " + Whole(kPerRadian) + ")", 3);
  }
  void Place(std::string_view name, const world::Vec3&, double per_unit) {
    Add(name, "Vec3", "readPlace(input, " + Whole(per_unit) + ")", 3);
  }
  void PlaceIf(bool, std::string_view name, const world::Vec3&) {
    Add(name, "Vec3 | null", "input.byte() !== 0 ? readPlace(input, " + Whole(kPerMetre) + ") : null", 1);
  }
  void Point(std::string_view name, const world::Vec3&) { Add(name, "Vec3", "values.point()", 3); }
  void Moment(std::string_view name, double) { Add(name, "number", "input.signed() / 100", 1); }

  std::string Text() const {
    const bool has_values = reads_.find("values.") != std::string::npos;
    std::string constant;
    for (const char c : name_) {
      if (std::isupper(static_cast<unsigned char>(c)) != 0 && !constant.empty()) constant += '_';
      constant += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    return "\n/** " + about_ + " */\nexport interface " + name_ + " {\n" + type_ + "}\nexport const " + constant +
           "_BYTES = " + std::to_string(least_bytes_) + ";\nexport function read" + name_ + "(input: ByteReader" +
           (has_values ? ", values: Values" : "") + "): " + name_ + " {\n" + reads_ + "  return { " + fields_ +
           " };\n}\n";
  }

 private:
  void AddField(std::string_view name, const std::string& type, const std::string& value) {
    type_ += "  readonly " + std::string(name) + ": " + type + ";\n";
    fields_ += (fields_.empty() ? "" : ", ") + std::string(name) + value;
  }
  void Add(std::string_view name, const std::string& type, const std::string& read, std::size_t bytes) {
    reads_ += "  const " + std::string(name) + " = " + read + ";\n";
    least_bytes_ += bytes;
    AddField(name, type, "");
  }

  std::string name_, about_, type_, reads_, fields_;
  std::size_t least_bytes_ = 0;
};

template <typename Record>
std::string TextOf(const Record& record) {
  RecordText text;
  Layout(text, record);
  return text.Text();
}

}  // namespace

std::string SceneRecords() {
  const world::AgentSnapshot agent;
  return "// SPDX-License-Identifier: BSD-2-Clause\n"
         "// Written by reference_pages from src/stream/scene_layout.h.\n"
         "import type { ByteReader } from \"./byte_reader\";\n"
         "import { readColor, readFloats, readPlace, readTurn, type Color, type Quat, type Vec3, type Values } from "
         "\"./scene_values\";\n\n"
         "/** The records of a scene's stream. `_BYTES`: the least number of bytes of one. */\n" +
         TextOf(world::LightSnapshot()) + TextOf(MovedCamera()) + TextOf(AgentLooks{agent}) +
         TextOf(AgentState{agent}) + TextOf(world::ParticleSnapshot()) + TextOf(world::SoundSnapshot()) +
         TextOf(world::LineSnapshot()) + TextOf(world::CircleSnapshot()) + TextOf(world::TriangleSnapshot()) +
         TextOf(world::ContactSnapshot()) + TextOf(world::ShotSnapshot()) + TextOf(world::SpeechSnapshot()) +
         TextOf(world::PlaceSnapshot()) + TextOf(world::PushSnapshot());
}

}  // namespace soarbox::stream
