// SPDX-License-Identifier: BSD-2-Clause
#include "sim/input_mirror.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "sim/client_input.h"
#include "sml_Client.h"
#include "vocabulary/vocabulary_percepts.h"

namespace soarbox::sim {
namespace {

class InputMirrorTest : public testing::Test {
 protected:
  ~InputMirrorTest() override { kernel_->Shutdown(); }

  /// The elements below an identifier: "name value", and "name {...}" for objects, in the order of creation.
  std::string Link(const sml::Identifier* parent = nullptr) {
    if (parent == nullptr) parent = agent_->GetInputLink();
    std::string text;
    for (int n = 0; n < parent->GetNumberChildren(); ++n) {
      sml::WMElement* child = const_cast<sml::Identifier*>(parent)->GetChild(n);
      text += std::string(n == 0 ? "" : " ") + child->GetAttribute() + " ";
      text += child->IsIdentifier() ? "{" + Link(child->ConvertToIdentifier()) + "}" : child->GetValueAsString();
    }
    return text;
  }
  long long TagOf(const char* attribute, int index = 0) {
    return agent_->GetInputLink()->FindByAttribute(attribute, index)->GetTimeTag();
  }
  /// Reports an agent with a name and a range.
  static void TellAgent(InputMirror& sink, std::uint32_t key, std::string_view name, double range_m) {
    sink.Open(vocabulary::RowOf("agent"), key);
    sink.Word(vocabulary::RowOf("agent.name"), name);
    sink.Number(vocabulary::RowOf("agent.range"), range_m);
    sink.Close();
  }

  std::unique_ptr<sml::Kernel> kernel_{sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener)};
  sml::Agent* agent_ = kernel_->CreateAgent("scout");
  PerceptLink link_{OpenClientInput(*agent_)};  // Its elements can be read back.
  InputMirror mirror_{link_};
};

TEST_F(InputMirrorTest, WhatIsToldAsItWasIsNotWrittenAgain) {
  const auto tell = [](InputMirror& sink) {
    sink.Number(vocabulary::RowOf("time"), 1);
    TellAgent(sink, 3, "a name that is longer than sixteen letters", 2.5);
  };
  mirror_.Show(tell);
  EXPECT_EQ(Link(), "time 1 agent {name a name that is longer than sixteen letters range 2.5}");
  const long long tag = TagOf("agent");
  mirror_.Show(tell);
  EXPECT_EQ(mirror_.changes(), 0u);
  EXPECT_EQ(TagOf("agent"), tag);
}

TEST_F(InputMirrorTest, OnlyWhatDiffersIsWrittenAndObjectsKeepTheirIdentifiers) {
  mirror_.Show([](InputMirror& sink) {
    TellAgent(sink, 3, "red", 2);
    TellAgent(sink, 4, "blue", 9);
  });
  const long long tag = TagOf("agent");
  mirror_.Show([](InputMirror& sink) {
    TellAgent(sink, 3, "red", 3);
    TellAgent(sink, 4, "blue", 9);
  });
  EXPECT_EQ(mirror_.changes(), 1u);
  EXPECT_EQ(TagOf("agent"), tag);
  EXPECT_EQ(Link(), "agent {name red range 3} agent {name blue range 9}");
}

TEST_F(InputMirrorTest, SiblingsAreToldApartByTheirKeysInWhateverOrderTheyComeAndGo) {
  const auto tell = [this](std::vector<std::uint32_t> keys) {
    mirror_.Show([&](InputMirror& sink) {
      for (const std::uint32_t key : keys) TellAgent(sink, key, "n" + std::to_string(key), key);
    });
  };
  tell({1, 2, 3});
  const long long second = TagOf("agent", 1);
  tell({3, 2});
  EXPECT_EQ(mirror_.changes(), 1u);  // The first was removed.
  EXPECT_EQ(TagOf("agent", 0), second);
  tell({2, 5, 3});
  EXPECT_EQ(Link(), "agent {name n2 range 2} agent {name n3 range 3} agent {name n5 range 5}");
  tell({});
  EXPECT_EQ(Link(), "");
}

TEST_F(InputMirrorTest, AQueueLosesItsFirstAndGetsNewOnesWhileTheRestStaysUntold) {
  const auto tell = [this](std::uint32_t first, std::vector<std::uint32_t> more) {
    mirror_.Begin();
    while (mirror_.NextKey() != 0 && mirror_.NextKey() < first) mirror_.Drop();
    mirror_.KeepRest();
    for (const std::uint32_t key : more) TellAgent(mirror_, key, "m", key);
    mirror_.End();
  };
  tell(1, {1, 2, 3});
  const long long third = TagOf("agent", 2);
  tell(3, {4});
  EXPECT_EQ(mirror_.changes(), 2u + 3u);  // Two removed, an object with two words added.
  EXPECT_EQ(Link(), "agent {name m range 3} agent {name m range 4}");
  EXPECT_EQ(TagOf("agent", 0), third);
  tell(9, {});
  EXPECT_EQ(Link(), "");
}

TEST_F(InputMirrorTest, AValueMayChangeItsType) {
  const auto show = [this](vocabulary::Percept::Object list) { mirror_.Show(list); };
  show({{"heat", 1, std::int64_t{3}}});
  show({{"heat", 1, 3.5}});
  EXPECT_EQ(Link(), "heat 3.5");
  show({{"heat", 1, vocabulary::PerceptList{{"of", 0, std::string("oven")}}}});
  EXPECT_EQ(Link(), "heat {of oven}");
  show({{"heat", 1, std::string("much")}, {"heat", 2, std::string("more")}});
  EXPECT_EQ(Link(), "heat much heat more");
}

TEST_F(InputMirrorTest, TheLogTellsOneAgentFromTheNext) {
  mind::EventLog log;
  mirror_.SetLog(&log);
  mirror_.Show([](InputMirror& sink) {
    TellAgent(sink, 3, "red", 2);
    TellAgent(sink, 4, "blue", 9);
  });
  mirror_.Show([](InputMirror& sink) { TellAgent(sink, 4, "blue", 8); });
  std::string text;
  log.ForEachOf<mind::PerceptChanged>([&](const mind::PerceptChanged& percept) {
    text += std::string(percept.path) + std::string(percept.attribute) + ' ';
  });
  log.ForEachOf<mind::PerceptGone>([&](const mind::PerceptGone& percept) {
    text += "-" + std::string(percept.path) + std::string(percept.attribute) + '#' + std::to_string(percept.key);
  });
  EXPECT_EQ(text, "agent#3.name agent#3.range agent#4.name agent#4.range agent#4.range -agent#3");
  mirror_.SetLog(nullptr);
}

TEST_F(InputMirrorTest, TextsOfAnyLengthAreToldApart) {
  std::string name;
  for (int length = 0; length < 20; ++length) {
    for (int place = 0; place < length; ++place) {
      std::string other = name;
      other[static_cast<std::size_t>(place)] = 'x';
      for (const std::string& told : {other, name}) {
        mirror_.Show([&](InputMirror& mirror) {
          mirror.Open(vocabulary::RowOf("agent"), 3);
          mirror.Word(vocabulary::RowOf("agent.name"), told);
          mirror.Number(vocabulary::RowOf("agent.range"), 1);
          mirror.Close();
        });
      }
      EXPECT_EQ(Link(), "agent {name " + name + " range 1}") << other;
    }
    name += static_cast<char>('a' + length);
  }
}

TEST_F(InputMirrorTest, LongTextsAreToldApart) {
  // The size of a slot's text is a byte, and its greatest value means a text that is elsewhere.
  for (const std::size_t length : {17, 254, 255, 256, 511}) {
    for (const char letter : {'x', 'y'}) {
      const std::string name(length, letter);
      for (const bool is_new : {true, false}) {
        mirror_.Show([&](InputMirror& mirror) {
          mirror.Open(vocabulary::RowOf("agent"), 3);
          mirror.Word(vocabulary::RowOf("agent.name"), name);
          mirror.Close();
        });
        EXPECT_EQ(mirror_.changes() > 0, is_new) << length;
      }
      EXPECT_EQ(Link(), "agent {name " + name + "}");
    }
  }
}

}  // namespace
}  // namespace soarbox::sim
