// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/panels/mind_note.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

using debugger::Recall;
using debugger::RecallLog;

/// What the selected agent knows and remembers: objects with their activation, what was recalled and why, episodes.
class LongTermPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    if (!HasMind(frame)) return;
    if (frame.contents.known_search != filter_) frame.Ask(workbench::SearchKnownRequest{filter_});
    const debugger::LongTermView& view = frame.contents.long_term;
    DrawBar(frame, view);
    const Part page("page");
    if (page_ == kKnown) {
      DrawKnown(frame, view);
    } else if (page_ == kRecalled) {
      DrawRecalled(frame);
    } else {
      DrawEpisodes(frame, view);
    }
  }

  std::string Text(const PanelFrame& frame) const override {
    if (!frame.contents.has_mind) return {};
    std::string text = debugger::ToText(frame.contents.long_term);
    if (const RecallLog* const log = frame.contents.recalls) {
      for (const Recall& recall : log->recalls()) {
        text += TimeOf(frame, recall.tick) + " " + debugger::ToText(recall) + "\n";
      }
    }
    if (frame.contents.episode.number != 0) text += "\n" + debugger::ToText(frame.contents.episode);
    return text;
  }

 private:
  enum Page : int { kKnown, kRecalled, kEpisodes };

  void DrawBar(PanelFrame& frame, const debugger::LongTermView& view) {
    const RecallLog* const log = frame.contents.recalls;
    PageButtons(page_,
                {{"Known " + std::to_string(view.facts.objects), "Objects of semantic memory, the most active first"},
                 {"Recalled " + std::to_string(log == nullptr ? 0 : log->count()),
                  "What rules asked of long-term memory, what came, and why"},
                 {"Episodes " + std::to_string(view.facts.episodes),
                  "What episodic memory holds: click one to see that world"}});
    if (page_ == kEpisodes) return;
    FlowLine(frame.Px(90));
    SearchField("##filter", "Filter by text", filter_);
  }

  // Known -------------------------------------------------------------------------------------------------------------

  void DrawKnown(PanelFrame& frame, const debugger::LongTermView& view) {
    if (!view.note.empty()) WrappedText(theme::kQuiet, view.note);
    if (view.facts.known.empty()) {
      if (!filter_.empty())
        EmptyNote("Nothing that is known has this text.");
      else if (view.note.empty())
        EmptyNote("Nothing is known yet.",
                  "Rules store objects with ^smem.command.store; smem --add adds some at once.");
      return;
    }
    if (filter_.empty() && view.facts.known.size() < view.facts.objects) {
      WrappedText(theme::kQuiet, "The " + std::to_string(view.facts.known.size()) +
                                     " most active. The filter looks through all that is known.");
    }
    const List list("known", {{"Object", 1.1f}, {"Activation", 2}, {"Uses", 0.9f}, {"What is known of it", 8}});
    if (!list) return;
    double most = 1e-9;
    for (const explain::KnownObjectFact& object : view.facts.known) most = std::max(most, std::abs(object.activation));
    const std::uint64_t recalled = LastRecalled(frame);
    ForRowsInSight(view.facts.known.size(), [&](int i) {
      const explain::KnownObjectFact& object = view.facts.known[static_cast<std::size_t>(i)];
      NextRow();
      ColoredText(object.number == recalled ? theme::kGood : theme::kVariable, "@" + std::to_string(object.number));
      if (object.number == recalled) Tooltip("Recalled last");
      ImGui::TableNextColumn();
      BarText(frame, object.activation, most);
      Cell(object.uses > 0 ? theme::kText : theme::kQuiet, std::to_string(object.uses));
      CutCell(object.text);
      Tooltip(object.text);
    });
  }

  /// The object that was recalled last; 0: none was.
  static std::uint64_t LastRecalled(const PanelFrame& frame) {
    const RecallLog* const log = frame.contents.recalls;
    if (log == nullptr) return 0;
    for (auto recall = log->recalls().rbegin(); recall != log->recalls().rend(); ++recall) {
      if (!recall->is_episode && recall->number != 0 && recall->tick <= frame.contents.moment.shown_tick)
        return recall->number;
    }
    return 0;
  }

  // Recalled ----------------------------------------------------------------------------------------------------------

  void DrawRecalled(PanelFrame& frame) {
    const RecallLog* const log = frame.contents.recalls;
    if (log == nullptr || log->recalls().empty()) {
      EmptyNote("Nothing was asked yet.",
                "Rules ask with ^smem.command.query or ^epmem.command.query. This panel shows what they got, and why.");
      return;
    }
    std::vector<const Recall*> rows;
    for (auto recall = log->recalls().rbegin(); recall != log->recalls().rend(); ++recall) {
      if (HasPart(recall->question + " " + recall->answer, filter_)) rows.push_back(&*recall);
    }
    const List list("recalled", {{"When", 1.2f}, {"Asked for", 4}, {"Came", 4}, {"Why", 5}});
    if (list) ForRowsInSight(rows.size(), [&](int i) { DrawRecall(frame, *rows[static_cast<std::size_t>(i)], i); });
  }

  void DrawRecall(PanelFrame& frame, const Recall& recall, int number) {
    const IdScope id(number);
    NextRow();
    const bool is_later = recall.tick > frame.contents.moment.shown_tick;
    TimeLink(frame, recall.tick, is_later ? "Later than the moment that is shown; a click goes there" : "Go there",
             is_later ? theme::kQuiet : theme::kAccent);
    CutCell(recall.question);
    Tooltip(recall.question);
    ImGui::TableNextColumn();
    if (recall.number == 0) {
      ColoredText(theme::kBad, "nothing");
    } else if (recall.is_episode) {
      if (Link("episode", "episode " + std::to_string(recall.number))) {
        frame.Ask(workbench::EpisodeRequest{static_cast<std::size_t>(recall.number)});
        page_ = kEpisodes;
      }
    } else {
      const std::string came = "@" + std::to_string(recall.number) + " " + recall.answer;
      CutText(came, theme::kVariable);
      Tooltip(came);
    }
    CutCell(recall.reason, theme::kQuiet);
    Tooltip(recall.reason);
  }

  // Episodes ----------------------------------------------------------------------------------------------------------

  void DrawEpisodes(PanelFrame& frame, const debugger::LongTermView& view) {
    const std::size_t episodes = view.facts.episodes;
    if (episodes == 0) {
      if (!view.note.empty()) WrappedText(theme::kQuiet, view.note);
      if (view.note.empty()) EmptyNote("There are no episodes yet.", "epmem --enable takes one in each decision.");
      return;
    }
    const debugger::EpisodeView& episode = frame.contents.episode;
    const std::size_t chosen = episode.number;
    if (ImGui::SmallButton("<") && chosen > 1) frame.Ask(workbench::EpisodeRequest{chosen - 1});
    Tooltip("The episode before");
    ImGui::SameLine();
    if (ImGui::SmallButton(">") && chosen < episodes) frame.Ask(workbench::EpisodeRequest{chosen + 1});
    Tooltip("The next episode");
    ImGui::SameLine();
    if (chosen == 0) {
      ColoredText(theme::kQuiet, "Click the strip: that world appears as ghosts.");
    } else {
      std::string text = "Episode " + std::to_string(chosen) + " of " + std::to_string(episodes);
      const std::vector<std::uint64_t>& decisions = view.facts.decisions;
      if (chosen <= decisions.size()) {
        const std::uint64_t decision = decisions[chosen - 1];
        text += decision == 0 ? ", from an earlier run" : ", taken in decision " + std::to_string(decision);
      }
      ColoredText(theme::kText, text);
      FlowLine(ButtonWidth("Close"));
      if (ImGui::SmallButton("Close")) frame.Ask(workbench::EpisodeRequest{0});
    }
    DrawStrip(frame, episodes, chosen);
    if (chosen == 0) return;
    const Part lines("lines");
    if (episode.things.empty())
      WrappedText(theme::kQuiet, "Nothing in this episode has a ^position, so it has no ghosts.");
    const FontScope mono(frame.fonts.mono);
    ForRowsInSight(episode.lines.size(), [&](int i) { CutText(episode.lines[static_cast<std::size_t>(i)]); });
  }

  /// All episodes from left to right, those that were recalled marked; a click or a drag chooses one.
  static void DrawStrip(PanelFrame& frame, std::size_t episodes, std::size_t chosen) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = std::max(frame.Px(40), ImGui::GetContentRegionAvail().x), height = frame.Px(26);
    ImGui::InvisibleButton("strip", {width, height});
    const auto place = [&](std::uint64_t number) {
      return at.x + width * (static_cast<float>(number) - 0.5f) / static_cast<float>(episodes);
    };
    const auto under = [&]() {
      const float share = std::clamp((ImGui::GetIO().MousePos.x - at.x) / width, 0.0f, 0.9999f);
      return static_cast<std::size_t>(share * static_cast<float>(episodes)) + 1;
    };
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(at, {at.x + width, at.y + height}, theme::Packed(theme::kField));
    const float each = width / static_cast<float>(episodes);
    if (each >= frame.Px(4)) {
      for (std::size_t n = 1; n < episodes; ++n) {
        const float x = at.x + each * static_cast<float>(n);
        draw.AddLine({x, at.y}, {x, at.y + height}, theme::Packed(theme::kEdge));
      }
    }
    if (const RecallLog* const log = frame.contents.recalls) {
      for (const Recall& recall : log->recalls()) {
        if (!recall.is_episode || recall.number == 0 || recall.number > episodes) continue;
        const float x = place(recall.number);
        draw.AddLine({x, at.y + frame.Px(3)}, {x, at.y + height - frame.Px(3)}, theme::Packed(theme::kGood),
                     frame.Px(2));
      }
    }
    if (chosen != 0) {
      const float x = place(chosen), half = std::max(frame.Px(1.5f), each / 2);
      draw.AddRect({x - half, at.y}, {x + half, at.y + height}, theme::Packed(theme::kAccent), 0, 0, frame.Px(2));
    }
    if (ImGui::IsItemActive() && under() != chosen) frame.Ask(workbench::EpisodeRequest{under()});
    if (ImGui::IsItemHovered()) Tooltip("Episode " + std::to_string(under()) + "; green: recalled by rules");
  }

  int page_ = kKnown;
  std::string filter_;
};

}  // namespace

std::unique_ptr<Panel> MakeLongTermPanel() {
  return std::make_unique<LongTermPanel>();
}

}  // namespace soarbox::viewer
