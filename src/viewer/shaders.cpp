// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/shaders.h"

#include <fstream>
#include <sstream>

#include "diagnostics/problem.h"

namespace soarbox::viewer {
namespace {

namespace fs = std::filesystem;
using Params = Ogre::GpuProgramParameters;

constexpr const char* kSceneValues = "SoarboxScene";

struct BoundValue {
  const char* name;
  Params::AutoConstantType source;
  std::size_t extra;
};

/// The values that Ogre sets in each program that declares them.
constexpr BoundValue kBoundValues[] = {
    {"world", Params::ACT_WORLD_MATRIX, 0},
    {"view_projection", Params::ACT_VIEWPROJ_MATRIX, 0},
    {"world_view_projection", Params::ACT_WORLDVIEWPROJ_MATRIX, 0},
    {"shadow_near_matrix", Params::ACT_TEXTURE_VIEWPROJ_MATRIX, 0},
    {"shadow_far_matrix", Params::ACT_TEXTURE_VIEWPROJ_MATRIX, 1},
    {"camera_place", Params::ACT_CAMERA_POSITION, 0},
    {"viewport", Params::ACT_VIEWPORT_SIZE, 0},
};

/// Returns the text of a shader with its includes. Empty if a file cannot be read; `missing` is then its path.
std::string ReadShader(const fs::path& file, fs::path& missing) {
  std::ifstream in(file);
  if (!in) {
    missing = file;
    return {};
  }
  std::ostringstream text;
  constexpr std::string_view kInclude = "#include \"";
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(kInclude)) {
      const std::string name = line.substr(kInclude.size(), line.rfind('"') - kInclude.size());
      text << ReadShader(file.parent_path() / name, missing);
    } else {
      text << line << '\n';
    }
  }
  return text.str();
}

/// The text with a definition of this name at its top.
std::string WithDefinition(std::string source, const std::string& name) {
  source.insert(source.find('\n', source.find("#version")) + 1, "#define " + name + " 1\n");
  return source;
}

constexpr std::pair<Placing, const char*> kDefinitionOf[] = {{Placing::kMany, "BY_THING"},
                                                             {Placing::kBones, "BY_BONES"}};

void Bind(const Ogre::GpuProgramParametersSharedPtr& params) {
  params->setIgnoreMissingParams(true);
  for (const BoundValue& value : kBoundValues) params->setNamedAutoConstant(value.name, value.source, value.extra);
  params->addSharedParameters(kSceneValues);
}

void NameSamplers(Params& params, const std::vector<std::string>& samplers) {
  for (std::size_t i = 0; i < samplers.size(); ++i) params.setNamedConstant(samplers[i], static_cast<int>(i));
}

}  // namespace

Result<Shaders> Shaders::Load(const fs::path& folder, bool low_detail) {
  struct File {
    const char* name;
    Ogre::GpuProgramType type;
  };
  constexpr File kFiles[] = {{"surface.vert", Ogre::GPT_VERTEX_PROGRAM},  {"surface.frag", Ogre::GPT_FRAGMENT_PROGRAM},
                             {"ground.frag", Ogre::GPT_FRAGMENT_PROGRAM}, {"shadow.vert", Ogre::GPT_VERTEX_PROGRAM},
                             {"shadow.frag", Ogre::GPT_FRAGMENT_PROGRAM}, {"sky.vert", Ogre::GPT_VERTEX_PROGRAM},
                             {"sky.frag", Ogre::GPT_FRAGMENT_PROGRAM},    {"line.vert", Ogre::GPT_VERTEX_PROGRAM},
                             {"line.frag", Ogre::GPT_FRAGMENT_PROGRAM},   {"panel.vert", Ogre::GPT_VERTEX_PROGRAM},
                             {"panel.frag", Ogre::GPT_FRAGMENT_PROGRAM},  {"fill.vert", Ogre::GPT_VERTEX_PROGRAM},
                             {"fill.frag", Ogre::GPT_FRAGMENT_PROGRAM},   {"ghost.frag", Ogre::GPT_FRAGMENT_PROGRAM},
                             {"enlarge.vert", Ogre::GPT_VERTEX_PROGRAM},  {"enlarge.frag", Ogre::GPT_FRAGMENT_PROGRAM}};

  Shaders shaders;
  for (const File& file : kFiles) {
    fs::path missing;
    std::string source = ReadShader(folder / file.name, missing);
    if (low_detail && missing.empty()) source = WithDefinition(std::move(source), "LOW_DETAIL");
    if (!missing.empty()) {
      return ProblemIn(missing.string(), "this shader cannot be read, so nothing can be drawn",
                       "the media folder of Soarbox must be next to its library; specify the folder if it was moved");
    }
    const auto add = [&file](const std::string& name, const std::string& text) {
      Ogre::HighLevelGpuProgramManager::getSingleton().createProgram(name, kGroup, "glsl", file.type)->setSource(text);
    };
    add(file.name, source);
    if (source.find("FURTHER_LIGHTS") != std::string::npos)
      add(WithLights(file.name), WithDefinition(source, "FURTHER_LIGHTS"));
    for (const auto& [placing, definition] : kDefinitionOf) {
      if (source.find(definition) != std::string::npos)
        add(Placed(file.name, placing), WithDefinition(source, definition));
    }
  }
  auto values = Ogre::GpuProgramManager::getSingleton().createSharedParameters(kSceneValues);
  for (const char* name :
       {"sun_direction", "sun_colour", "ambient_colour", "haze", "sky_mean", "haze_colour", "line_scale"}) {
    values->addConstantDefinition(name, Ogre::GCT_FLOAT4);
  }
  for (const char* name : {"light_place", "light_colour", "light_fade"}) {
    values->addConstantDefinition(name, Ogre::GCT_FLOAT4, 4);
  }
  values->addConstantDefinition("sky_turn", Ogre::GCT_MATRIX_4X4);
  shaders.scene_values_ = values;
  return shaders;
}

std::string Shaders::WithLights(const std::string& fragment) {
  return fragment + "/lights";
}

std::string Shaders::Placed(const std::string& vertex, Placing placing) {
  return placing == Placing::kOne ? vertex : vertex + (placing == Placing::kMany ? "/things" : "/bones");
}

void Shaders::Use(Ogre::Pass& pass, const std::string& vertex, const std::string& fragment,
                  const std::vector<std::string>& samplers) const {
  pass.setVertexProgram(vertex);
  Bind(pass.getVertexProgramParameters());
  NameSamplers(*pass.getVertexProgramParameters(), samplers);
  UseFragment(pass, fragment, samplers);
}

void Shaders::UseFragment(Ogre::Pass& pass, const std::string& fragment,
                          const std::vector<std::string>& samplers) const {
  pass.setFragmentProgram(fragment);
  Bind(pass.getFragmentProgramParameters());
  NameSamplers(*pass.getFragmentProgramParameters(), samplers);
}

}  // namespace soarbox::viewer
