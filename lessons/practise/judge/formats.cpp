#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>
#include <numeric>

#include "lessons/practise/judge/submission.hpp"
#include "renderer/data_url.hpp"

// What each consumer of results reads. Each format says the same of a submission.
namespace byhand::practise {
namespace {

using Json = nlohmann::ordered_json;
using All = std::vector<Graded>;

std::string title(const Graded& graded) {
  return fmt::format("{}. {}", graded.exercise->number(), task(*graded.exercise).title);
}

int score(const All& all) {
  return static_cast<int>(
      std::count_if(all.begin(), all.end(), [](const Graded& graded) { return graded.verdict.is_right(); }));
}

std::string summary_line(const All& all) {
  return fmt::format("{} of {} exercises are right.", score(all), all.size());
}

std::string output(const Verdict& verdict) {
  std::string text = verdict.sentence + "\n";
  if (!verdict.details.empty()) text += "\n" + verdict.details;
  if (!verdict.printed.empty()) text += "\nYour code printed:\n" + verdict.printed.substr(0, 2000);
  return text;
}

/// Titles and sentences are UTF-8, and check() has made the rest so.
std::string dump(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

/// https://gradescope-autograders.readthedocs.io/en/latest/specs
std::string gradescope(const All& all) {
  Json tests = Json::array();
  for (const Graded& graded : all)
    tests.push_back({{"score", graded.verdict.is_right() ? 1 : 0},
                     {"max_score", 1},
                     {"status", graded.verdict.is_right() ? "passed" : "failed"},
                     {"name", title(graded)},
                     {"number", std::to_string(graded.exercise->number())},
                     {"output", output(graded.verdict)},
                     {"output_format", "text"},
                     {"visibility", "visible"}});
  return dump({{"score", score(all)},
               {"output", summary_line(all)},
               {"output_format", "text"},
               {"visibility", "visible"},
               {"stdout_visibility", "hidden"},
               {"tests", tests}});
}

/// classroom50/result/v1. The runner gives the names of the submission.
std::string classroom50(const All& all) {
  const auto given = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value && *value ? value : "none");  // outside of a runner; its schema wants words
  };
  Json tests = Json::array();
  for (const Graded& graded : all)
    tests.push_back({{"test-name", title(graded)},
                     {"passed", graded.verdict.is_right()},
                     {"score", graded.verdict.is_right() ? 1 : 0},
                     {"max-score", 1},
                     {"message", graded.verdict.sentence}});
  const std::string review = given("REVIEW_URL");
  const std::time_t now = std::time(nullptr);
  return dump({{"schema", "classroom50/result/v1"},
               {"classroom", given("CLASSROOM")},
               {"assignment", given("ASSIGNMENT")},
               {"submission", given("SUBMISSION_TAG")},
               {"commit", given("COMMIT_URL")},
               {"release", given("RELEASE_URL")},
               {"review", review == "none" ? given("COMMIT_URL") : review},
               {"datetime", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now))},
               {"score", score(all)},
               {"max-score", all.size()},
               {"tests", tests}});
}

/// https://prairielearn.readthedocs.io/en/latest/externalGrading: at most 1 MB. It costs no attempt if nothing
/// that was submitted compiles; one file that does not leaves the others gradable.
std::string prairielearn(const All& all) {
  Json tests = Json::array(), mistakes = Json::array();
  std::size_t room = 700000;
  for (const Graded& graded : all) {
    Json test = {{"name", title(graded)},
                 {"points", graded.verdict.is_right() ? 1 : 0},
                 {"max_points", 1},
                 {"message", graded.verdict.sentence},
                 {"output", output(graded.verdict)}};
    if (const std::string url = renderer::data_url(graded.picture);
        !graded.picture.empty() && url.size() <= room) {
      room -= url.size();
      test["images"] = {{{"label", "Your code and the right one"}, {"url", url}}};
    }
    tests.push_back(test);
    if (graded.verdict.kind == Verdict::Kind::does_not_compile)
      mistakes.push_back(graded.file + ": " + output(graded.verdict));
  }
  const bool gradable = mistakes.empty() || std::any_of(all.begin(), all.end(), [](const Graded& graded) {
                          return graded.verdict.kind != Verdict::Kind::does_not_compile &&
                                 graded.verdict.kind != Verdict::Kind::not_written;
                        });
  Json results = {{"gradable", gradable}, {"score", all.empty() ? 0 : double(score(all)) / double(all.size())}};
  if (!mistakes.empty()) results["format_errors"] = mistakes;
  results["message"] = summary_line(all);
  results["tests"] = tests;
  return dump(results);
}

std::string xml(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&': escaped += "&amp;"; break;
      case '<': escaped += "&lt;"; break;
      case '>': escaped += "&gt;"; break;
      case '"': escaped += "&quot;"; break;
      case '\n': escaped += "&#10;"; break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) escaped += c;
    }
  }
  return escaped;
}

std::string junit(const All& all) {
  const auto failures = static_cast<int>(all.size()) - score(all);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"practise\" tests=\"{}\" "
      "failures=\"{}\" errors=\"0\" skipped=\"0\" time=\"{:.3f}\">\n",
      all.size(), failures, std::accumulate(all.begin(), all.end(), 0.0, [](double sum, const Graded& graded) {
        return sum + graded.seconds;
      }));
  for (const Graded& graded : all) {
    text += fmt::format("    <testcase classname=\"practise\" name=\"{}\" time=\"{:.3f}\"", xml(title(graded)),
                        graded.seconds);
    // What a learner printed does not belong to the failure.
    text += graded.verdict.is_right()
                ? "/>\n"
                : fmt::format(">\n      <failure message=\"{}\">{}</failure>\n    </testcase>\n",
                              xml(graded.verdict.sentence), xml(graded.verdict.details));
  }
  return text + "  </testsuite>\n</testsuites>\n";
}

/// Workflow commands of GitHub Actions.
std::string github(const All& all) {
  const auto escaped = [](const std::string& text, bool property) {
    std::string safe;
    for (const char c : text) {
      if (c == '%' || c == '\n' || c == '\r' || (property && (c == ':' || c == ',')))
        safe += fmt::format("%{:02X}", static_cast<unsigned char>(c));
      else
        safe += c;
    }
    return safe;
  };
  std::string text;
  for (const Graded& graded : all)
    if (!graded.verdict.is_right())
      text += fmt::format("::error file={},line={},title={}::{}\n", escaped(graded.file, true),
                          std::max(1, graded.verdict.line), escaped(title(graded), true),
                          escaped(graded.verdict.kind == Verdict::Kind::does_not_compile ? output(graded.verdict)
                                                                                         : graded.verdict.sentence,
                                  false));
  return text;
}

/// A sentence may name what the learner named: no character of it is markup.
std::string markdown(const std::string& sentence) {
  std::string safe;
  for (const char c : sentence) {
    if (std::string_view("\\`*_[]<>|~#&!").find(c) != std::string_view::npos) safe += '\\';
    safe += c;
  }
  return safe;
}

/// For $GITHUB_STEP_SUMMARY.
std::string summary(const All& all) {
  std::string text = "| exercise | | |\n|---|---|---|\n";
  for (const Graded& graded : all)
    text += fmt::format("| {} | {} | {} |\n", title(graded), graded.verdict.is_right() ? "right" : "not yet",
                        markdown(graded.verdict.sentence));
  return text + "\n" + summary_line(all) + "\n";
}

Json to_json(const Sheet& sheet) {
  Json lines = Json::array();
  for (const Line& line : sheet) lines.push_back({int(line.kind), line.name, line.unit, line.values});
  return lines;
}

Sheet sheet_from(const Json& lines) {
  Sheet sheet;
  for (const Json& line : lines) {
    Numbers values;  // JSON has null for what is not finite
    for (const Json& value : line[3]) values.push_back(value.is_null() ? std::nan("") : value.get<double>());
    sheet.push_back({Line::Kind(line[0].get<int>()), line[1], line[2], values});
  }
  return sheet;
}

}  // namespace

const std::map<std::string, Format>& formats() {
  static const std::map<std::string, Format> all = {
      {"gradescope", gradescope}, {"classroom50", classroom50}, {"prairielearn", prairielearn},
      {"junit", junit},           {"github", github},           {"summary", summary}};
  return all;
}

std::string to_json(const Key& key) {
  Json json = {{"seed", key.seed}, {"tolerance", key.tolerance}};
  for (const Sheet& sheet : key.right) json["right"].push_back(to_json(sheet));
  json["misconceptions"] = Json::array();
  for (const auto& known : key.misconceptions) {
    Json sheets = Json::array();
    for (const Sheet& sheet : known.sheets) sheets.push_back(to_json(sheet));
    json["misconceptions"].push_back({{"sentence", known.sentence}, {"sheets", sheets}});
  }
  const Film& film = key.film;
  Json frames = Json::array();
  for (const Frame& frame : film.frames) {
    Json shapes = Json::array();
    for (const Shape& s : frame.shapes) shapes.push_back({int(s.kind), s.at.x, s.at.y, s.to.x, s.to.y, s.angle});
    frames.push_back({frame.reading, shapes});
  }
  json["film_tolerance"] = key.film_tolerance;
  json["film"] = {{"title", film.title}, {"quantity", film.quantity}, {"unit", film.unit}, {"frames", frames}};
  return json.dump() + "\n";
}

Key key_from_json(const std::string& text) {
  const Json json = Json::parse(text);
  Key key;
  key.seed = json.at("seed");
  key.tolerance = json.at("tolerance").get<std::vector<std::vector<Numbers>>>();
  for (const Json& sheet : json.at("right")) key.right.push_back(sheet_from(sheet));
  for (const Json& known : json.at("misconceptions")) {
    Key::Misconception wrong{known.at("sentence"), {}};
    for (const Json& sheet : known.at("sheets")) wrong.sheets.push_back(sheet_from(sheet));
    key.misconceptions.push_back(std::move(wrong));
  }
  key.film_tolerance = json.at("film_tolerance").get<std::vector<double>>();
  const Json& film = json.at("film");
  key.film = {film.at("title"), film.at("quantity"), film.at("unit"), {}};
  for (const Json& frame : film.at("frames")) {
    Frame shown{{}, frame[0]};
    for (const Json& s : frame[1])
      shown.shapes.push_back({Shape::Kind(s[0].get<int>()), {s[1], s[2]}, {s[3], s[4]}, s[5]});
    key.film.frames.push_back(std::move(shown));
  }
  return key;
}

}  // namespace byhand::practise
