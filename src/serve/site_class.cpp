// SPDX-License-Identifier: BSD-2-Clause
// The parts of the site for classes: the teacher's table, messages and raised hands, the arena, and links for watching
// a run.
#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "diagnostics/json_text.h"
#include "diagnostics/problem.h"
#include "serve/random_id.h"
#include "serve/site.h"

namespace soarbox::serve {
namespace {

using ClassJson = nlohmann::ordered_json;

/// A quoted table cell that spreadsheets do not treat as a formula.
std::string CsvCell(std::string text) {
  if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos) text.insert(0, "'");
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

std::int64_t EpochSeconds() {
  return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

const char* WordOf(Activity::Kind kind) {
  switch (kind) {
    case Activity::Kind::kMistake:
      return "mistake";
    case Activity::Kind::kStuck:
      return "stuck";
    case Activity::Kind::kIdle:
      return "idle";
    case Activity::Kind::kWorks:
      break;
  }
  return "works";
}

std::string FieldText(const ClassJson& json, const char* field) {
  const auto found = json.is_object() ? json.find(field) : json.end();
  return json.is_object() && found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

int FieldInt(const ClassJson& json, const char* field) {
  const auto found = json.is_object() ? json.find(field) : json.end();
  return json.is_object() && found != json.end() && found->is_number_integer() ? found->get<int>() : 0;
}

ClassJson ToJson(const std::vector<ClassDesk::Note>& notes) {
  ClassJson json = ClassJson::array();
  for (const ClassDesk::Note& note : notes)
    json.push_back({{"text", note.text},
                    {"file", note.file},
                    {"line", note.line},
                    {"when", note.when_s},
                    {"is_read", note.is_read}});
  return json;
}

}  // namespace

void Site::AnswerClass(const WebRequest& request, const std::vector<std::string>& parts, Done done) {
  std::string key = parts[2], form;
  for (const char* const ending : {"-long.csv", ".csv"})
    if (form.empty() && key.ends_with(ending)) {
      form = ending;
      key.resize(key.size() - form.size());
    }
  const ClassList* const list = ClassOf(key);
  if (list == nullptr) return done(Refusal(404, "no class has this link", "the server printed the link when it began"));
  const std::string what = parts.size() > 3 ? parts[3] : "";
  const bool is_post = request.method == "POST";
  if (what.empty() && request.method == "GET") return AnswerTable(*list, form, std::move(done));
  if (what == "arena" && parts.size() == 4 && request.method == "GET") return done(Good(arena_->ToJson({})));
  if (what == "message" && is_post) return done(WriteNote(*list, request.body));
  const ClassJson body = ClassJson::parse(request.body, nullptr, false);
  if (what == "arena" && parts.size() == 5 && is_post) {
    const Result<void> played = arena_->Play(parts[4], FieldInt(body, "seeds"));
    return done(played ? Good(arena_->ToJson({})) : Refusal(400, played.error()));
  }
  if (what == "hand" && is_post) {
    const std::string place = FieldText(body, "place");
    desk_.SetHand(place, false, EpochSeconds());
    SaveDesk();
    GreetAgain(place);
    return done(Good({{"done", true}}));
  }
  done(Refusal(404, "a class has nothing of this name"));
}

WebResponse Site::WriteNote(const ClassList& list, const std::string& body) {
  const ClassJson json = ClassJson::parse(body, nullptr, false);
  const std::string to = FieldText(json, "to");
  if (!to.empty() && list.NameOf(to).empty())
    return Refusal(400, "nobody of the class has this place",
                   "`to` is the id of a learner's place; without it, all get it");
  const std::string file = FieldText(json, "file");
  ClassDesk::Note note{0, FieldText(json, "text"), file.substr(file.rfind('/') + 1), FieldInt(json, "line"),
                       EpochSeconds()};
  for (const ClassList::Learner& learner : list.learners()) {
    if (!to.empty() && learner.place != to) continue;
    if (const Result<void> wrote = desk_.Write(learner.place, note); !wrote) return Refusal(400, wrote.error());
  }
  SaveDesk();
  for (const ClassList::Learner& learner : list.learners())
    if (to.empty() || learner.place == to) GreetAgain(learner.place);
  return Good({{"done", true}});
}

void Site::GreetAgain(const std::string& place) {
  if (const auto session = sessions_.find(place); session != sessions_.end()) session->second->Greet();
}

void Site::SaveDesk() {
  work_.Do(
      "class-desk",
      [file = DeskFile(), text = desk_.ToText()] {
        std::filesystem::path part = file;
        part += ".part";
        std::error_code error;
        {
          std::ofstream out(part, std::ios::binary);
          out << text;
          if (!out.flush()) return;
        }
        std::filesystem::rename(part, file, error);
      },
      [] {});
}

void Site::AnswerLearner(const WebRequest& request, const std::vector<std::string>& parts, Done done) {
  const std::string &id = parts[2], &what = parts[3];
  if (LearnerOf(id).empty())
    return done(Refusal(404, "this place belongs to nobody in a class",
                        "the server has a class if it was started with --class"));
  const bool is_post = request.method == "POST";
  if (what == "hand" && is_post) {
    const ClassJson body = ClassJson::parse(request.body, nullptr, false);
    desk_.SetHand(id, body.is_object() && body.value("is_up", ClassJson()) == true, EpochSeconds());
    SaveDesk();
    GreetAgain(id);
    return done(Good({{"done", true}}));
  }
  if (what == "notes" && is_post && parts.size() == 5) {
    for (const ClassDesk::Note& note : desk_.NotesOf(id))
      if (std::to_string(note.id) == parts[4]) {
        desk_.MarkRead(id, note.id);
        SaveDesk();
        GreetAgain(id);
        return done(Good({{"done", true}}));
      }
    return done(Refusal(404, "there is no message of this number"));
  }
  if (what == "arena" && parts.size() == 4 && request.method == "GET") return done(Good(arena_->ToJson(id)));
  if (what == "arena" && parts.size() == 5 && is_post) return HandIn(parts[4], id, request.body, std::move(done));
  done(Refusal(404, "a place has nothing of this name"));
}

void Site::HandIn(const std::string& game, const std::string& place, const std::string& body, Done done) {
  const ClassJson json = ClassJson::parse(body, nullptr, false);
  std::string file = FieldText(json, "file");
  // Pages send the names of files as they see them.
  const std::string home = std::string(kShownRoot) + "/home/";
  if (file.starts_with(home)) file.erase(0, home.size());
  const auto found = std::make_shared<Result<Place>>(NewProblem("not looked for"));
  work_.Do(
      place, [this, found, place] { *found = places_.Find(place); },
      [this, found, game, file, place, done = std::move(done)] {
        if (!*found) return done(Refusal(404, found->error()));
        arena_->HandIn(game, **found, LearnerOf(place), file, [this, place, done](const Result<void>& result) {
          done(result ? Good(arena_->ToJson(place)) : Refusal(400, result.error()));
        });
      });
}

void Site::AnswerWatchLink(const WebRequest& request, const std::string& id, Done done) {
  if (request.method != "GET" && request.method != "POST" && request.method != "DELETE")
    return done(Refusal(405, "a link to watch is read by GET, made by POST and withdrawn by DELETE"));
  Do(
      id,
      [this, id, method = request.method] {
        const Result<Place> place = places_.Find(id);
        if (!place) return Refusal(404, place.error());
        if (method == "DELETE") watch_links_.Withdraw(*place);
        const Result<std::string> link =
            method == "POST" ? watch_links_.FindOrMake(*place) : Result<std::string>(watch_links_.Find(*place));
        if (!link) return Refusal(507, link.error());
        return Good({{"link", link->empty() ? "" : "/w/" + *link + "/"}});
      },
      std::move(done));
}

void Site::AnswerWatch(const std::string& link, Done done) {
  Do(
      "watch",
      [this, link] {
        const Result<std::string> id = watch_links_.PlaceOf(link);
        const Result<Place> place = id ? places_.Find(*id) : Result<Place>(id.error());
        if (!place) return Refusal(404, place.error());
        ClassJson lessons = ClassJson::array(), none = ClassJson::array();
        for (const Lesson& lesson : catalog_->Lessons())
          lessons.push_back(
              {{"name", lesson.name}, {"title", lesson.title}, {"course", lesson.course}, {"is_passed", false}});
        return Good({{"place", ""},
                     {"learner", LearnerOf(*id)},
                     {"opens", ""},
                     {"lessons", std::move(lessons)},
                     {"scenarios", none},
                     {"files", none},
                     {"recordings", none},
                     {"kept_days", settings_.limits.kept_days},
                     {"has_run", false}});
      },
      std::move(done));
}

void Site::AnswerTable(const ClassList& list, const std::string& form, Done done) {
  // Copies the list, because a course of a learning platform may get a learner while the job runs.
  const auto copy = std::make_shared<const ClassList>(list);
  if (!form.empty()) {
    return Do(
        "class", [this, copy, is_long = form != ".csv"] { return TableAsCsv(*copy, is_long); }, std::move(done));
  }
  const auto doing = std::make_shared<std::map<std::string, Doing>>();
  for (const auto& [id, session] : sessions_)
    if (session->is_running()) (*doing)[id] = {session->what(), session->viewers() > 0, session->Standing()};
  for (const ClassList::Learner& learner : list.learners()) {
    Doing& each = (*doing)[learner.place];
    each.hand_since = desk_.HandSince(learner.place);
    each.notes = desk_.NotesOf(learner.place);
  }
  const lti::ScoreCount scores = lti_ != nullptr && &list != &class_ ? lti_->ScoresOf(list) : lti::ScoreCount();
  Do(
      "class", [this, copy, scores, doing] { return Table(*copy, scores, *doing); }, std::move(done));
}

WebResponse Site::Table(const ClassList& list, const lti::ScoreCount& scores,
                        const std::map<std::string, Doing>& doing) const {
  const std::vector<Lesson> lessons = catalog_->Lessons();
  const std::int64_t now = EpochSeconds();
  ClassJson titles = ClassJson::array(), learners = ClassJson::array();
  for (const Lesson& lesson : lessons)
    titles.push_back({{"name", lesson.name}, {"title", lesson.title}, {"course", lesson.course}});
  for (const ClassList::Learner& learner : list.learners()) {
    const Result<Place> place = places_.Find(learner.place);
    if (!place) continue;
    const Doing& does = doing.at(learner.place);
    std::string last_hint;
    bool has_open_hint = false;
    ClassJson done = ClassJson::object();
    for (const Lesson& lesson : lessons) {
      const Progress progress = catalog_->ProgressOf(place->state(), lesson.name);
      done[lesson.name] = {{"is_done", progress.is_passed}, {"tries", progress.attempts}, {"hints", progress.hints}};
      // The last hint of the open lesson; without one, that of the last lesson that is not passed.
      const bool is_open = does.what == "lesson:" + lesson.name;
      if (!progress.last_hint.empty() && (is_open || (!has_open_hint && !progress.is_passed)))
        last_hint = progress.last_hint;
      has_open_hint |= is_open && !progress.last_hint.empty();
    }
    learners.push_back({{"name", learner.name},
                        {"place", learner.place},
                        {"place_link", "/p/" + learner.place + "/"},
                        {"watch_link", "/p/" + learner.place + "/#watch=" + list.key()},
                        {"done", std::move(done)},
                        {"last_hint", last_hint},
                        {"doing", does.what},
                        {"is_here", does.is_watched},
                        {"standing", WordOf(does.standing.kind)},
                        {"trouble", does.standing.text},
                        {"lasts_s", does.standing.lasts.count()},
                        {"hand_s", does.hand_since ? ClassJson(now - *does.hand_since) : ClassJson()},
                        {"notes", ToJson(does.notes)}});
  }
  ClassJson told = {{"lessons", std::move(titles)}, {"learners", std::move(learners)}};
  if (scores.sent + scores.waiting + scores.refused > 0)
    told["scores"] = {
        {"sent", scores.sent}, {"waiting", scores.waiting}, {"refused", scores.refused}, {"trouble", scores.trouble}};
  return Good(told);
}

WebResponse Site::TableAsCsv(const ClassList& list, bool is_long) const {
  const std::vector<Lesson> lessons = catalog_->Lessons();
  const auto title = [](const Lesson& lesson) {
    return lesson.course.empty() ? lesson.title : lesson.course + ": " + lesson.title;
  };
  std::string csv = is_long ? "learner,course,lesson,title,passed,tries,hints" : "learner,passed,tries,hints";
  if (!is_long)
    for (const Lesson& lesson : lessons) csv += "," + CsvCell(title(lesson));
  csv += is_long ? "\r\n" : ",last hint\r\n";
  for (const ClassList::Learner& learner : list.learners()) {
    const Result<Place> place = places_.Find(learner.place);
    if (!place) continue;
    int passed = 0, tries = 0, hints = 0;
    std::string cells, last_hint;
    for (const Lesson& lesson : lessons) {
      const Progress progress = catalog_->ProgressOf(place->state(), lesson.name);
      passed += progress.is_passed ? 1 : 0;
      tries += progress.attempts;
      hints += progress.hints;
      if (!progress.last_hint.empty() && !progress.is_passed) last_hint = progress.last_hint;
      if (is_long)
        csv += CsvCell(learner.name) + "," + CsvCell(lesson.course) + "," + CsvCell(lesson.name) + "," +
               CsvCell(lesson.title) + "," + (progress.is_passed ? "1," : "0,") + std::to_string(progress.attempts) +
               "," + std::to_string(progress.hints) + "\r\n";
      // A lesson that was never tried has no grade; in the long form it has a row.
      const bool is_begun = progress.is_passed || progress.attempts > 0 || progress.hints > 0;
      cells += std::string(",") + (progress.is_passed ? "1" : is_begun ? "0" : "");
    }
    if (!is_long)
      csv += CsvCell(learner.name) + "," + std::to_string(passed) + "," + std::to_string(tries) + "," +
             std::to_string(hints) + cells + "," + CsvCell(last_hint) + "\r\n";
  }
  WebResponse response;
  response.type = "text/csv; charset=utf-8";
  response.headers.emplace_back("Content-Disposition", std::string("attachment; filename=\"") +
                                                           (is_long ? "class-long.csv" : "class.csv") + "\"");
  response.body = std::move(csv);
  return response;
}

}  // namespace soarbox::serve
