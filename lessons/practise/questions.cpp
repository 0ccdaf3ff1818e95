#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/child_process.hpp"
#include "lessons/files/printed_by.hpp"
#include "lessons/page/about.hpp"
#include "lessons/page/error.hpp"
#include "lessons/page/html/escaped.hpp"
#include "lessons/page/progress.hpp"
#include "lessons/practise/export_course.hpp"

// The predictions of the lessons as questions for a course's learning platform.
namespace byhand::practise {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

void add_to(std::vector<Json>& all, const std::string& asked) {
  for (const Json& question : Json::parse(asked)) all.push_back(question);
}

/// Of files that lessons wrote, in the course's order. Throws EnvironmentError if there is none.
std::vector<Json> questions_in(const fs::path& folder) {
  std::vector<Json> all;
  bool found = false;
  for (const course::About& lesson : course::contents())
    if (const auto text = course::read_whole(folder / (lesson.slug + ".json"))) {
      add_to(all, *text);
      found = true;
    }
  if (!found) throw course::EnvironmentError(fmt::format("There is no lesson's file in {}.", folder.string()));
  return all;
}

/// Of the lessons beside this program, built first if `lessons/run` started it.
std::vector<Json> questions() {
  if (const char* builder = std::getenv("BYHAND_BUILD"))
    if (!course::run_program(builder, {"lessons"}, course::Group::ours).well())
      throw course::EnvironmentError("the lessons could not be built");
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  const auto& lessons = course::contents();
  course::Progress progress("the predictions of all lessons", static_cast<int>(lessons.size()), false);
  std::vector<Json> all;
  for (const course::About& lesson : lessons) {
    add_to(all, course::printed_by((folder / lesson.slug).string(), {"--questions", "--quiet"}));
    progress.advance();
  }
  return all;
}

/// Without Markdown's marks, which QTI does not read.
std::string plain_xml(std::string words) {
  std::erase_if(words, [](char c) { return c == '*' || c == '`'; });
  return site::escaped(words);
}

std::string number(const Json& value) { return fmt::format("{:.12g}", value.get<double>()); }

/// The unit behind the question, since the answer is a number alone.
std::string asked(const Json& question) {
  const std::string unit = question["unit"];
  return question["ask"].get<std::string>() + (unit.empty() || unit == "1" ? "" : " [" + unit + "]");
}

std::string name(const Json& question, int index) {
  return fmt::format("{} {}.{}", question["lesson"].get<std::string>(), question["step"].get<std::string>(),
                     index);
}

/// https://docs.moodle.org/en/Moodle_XML_format: numerical questions. Wrong answers earn nothing and get their
/// reply.
std::string moodle(const std::vector<Json>& all) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n";
  std::string lesson;
  int index = 0;
  for (const Json& question : all) {
    if (question["lesson"] != lesson) {
      lesson = question["lesson"];
      index = 0;
      text += fmt::format(
          "  <question type=\"category\"><category><text>$course$/top/Constraints by Hand/{}</text></category>"
          "</question>\n",
          site::escaped(lesson));
    }
    const auto answer = [&](const Json& value, int fraction, const std::string& reply) {
      return fmt::format(
          "    <answer fraction=\"{}\" format=\"moodle_auto_format\">\n      <text>{}</text>\n      "
          "<tolerance>{}</tolerance>\n      <feedback format=\"markdown\"><text>{}</text></feedback>\n    "
          "</answer>\n",
          fraction, number(value), number(question["tolerance"]), site::escaped(reply));
    };
    text += fmt::format(
        "  <question type=\"numerical\">\n    <name><text>{}</text></name>\n    <questiontext format=\"markdown\">"
        "<text>{}</text></questiontext>\n    <generalfeedback "
        "format=\"markdown\"><text>{}</text></generalfeedback>\n"
        "    <defaultgrade>1</defaultgrade>\n    <penalty>0.3333333</penalty>\n    <hidden>0</hidden>\n",
        site::escaped(name(question, ++index)), site::escaped(asked(question)),
        site::escaped(question["right"].get<std::string>()));
    text += answer(question["answer"], 100, question["right"]);
    for (const Json& wrong : question["wrong"]) text += answer(wrong["value"], 0, wrong["reply"]);
    if (const std::string unit = question["unit"]; !unit.empty() && unit != "1")
      text += fmt::format(
          "    <units><unit><multiplier>1</multiplier><unit_name>{}</unit_name></unit></units>\n    "
          "<unitgradingtype>0</unitgradingtype>\n    <unitpenalty>0</unitpenalty>\n    <showunits>0</showunits>\n "
          "   <unitsleft>0</unitsleft>\n",
          site::escaped(unit));
    for (const Json& hint : question["hints"])
      text += fmt::format("    <hint format=\"markdown\"><text>{}</text></hint>\n",
                          site::escaped(hint.get<std::string>()));
    text += "  </question>\n";
  }
  return text + "</quiz>\n";
}

/// One QTI 2.1 item: a text entry of a number, compared within the tolerance, with modal feedback.
std::string item(const Json& question, const std::string& identifier, const std::string& title) {
  const std::string tolerance = number(question["tolerance"]);
  const auto near = [&](const Json& value) {
    return fmt::format(
        "<equal toleranceMode=\"absolute\" tolerance=\"{0} {0}\"><variable identifier=\"RESPONSE\"/>"
        "<baseValue baseType=\"float\">{1}</baseValue></equal>",
        tolerance, number(value));
  };
  const auto then = [](const std::string& feedback, int score) {
    return fmt::format(
        "<setOutcomeValue identifier=\"FEEDBACK\"><baseValue "
        "baseType=\"identifier\">{}</baseValue></setOutcomeValue>"
        "<setOutcomeValue identifier=\"SCORE\"><baseValue baseType=\"float\">{}</baseValue></setOutcomeValue>",
        feedback, score);
  };
  const auto feedback = [](const std::string& id, const std::string& words) {
    return fmt::format(
        "  <modalFeedback outcomeIdentifier=\"FEEDBACK\" identifier=\"{}\" showHide=\"show\">{}</modalFeedback>\n",
        id, plain_xml(words));
  };
  std::string rules =
      fmt::format("      <responseIf>{}{}</responseIf>\n", near(question["answer"]), then("RIGHT", 1));
  std::string replies = feedback("RIGHT", question["right"]);
  int index = 0;
  for (const Json& wrong : question["wrong"]) {
    const std::string id = fmt::format("WRONG{}", ++index);
    rules += fmt::format("      <responseElseIf>{}{}</responseElseIf>\n", near(wrong["value"]), then(id, 0));
    replies += feedback(id, wrong["reply"]);
  }
  return fmt::format(
      R"(<?xml version="1.0" encoding="UTF-8"?>
<assessmentItem xmlns="http://www.imsglobal.org/xsd/imsqti_v2p1" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:schemaLocation="http://www.imsglobal.org/xsd/imsqti_v2p1 http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd" identifier="{}" title="{}" adaptive="false" timeDependent="false">
  <responseDeclaration identifier="RESPONSE" cardinality="single" baseType="float">
    <correctResponse><value>{}</value></correctResponse>
  </responseDeclaration>
  <outcomeDeclaration identifier="SCORE" cardinality="single" baseType="float"><defaultValue><value>0</value></defaultValue></outcomeDeclaration>
  <outcomeDeclaration identifier="FEEDBACK" cardinality="single" baseType="identifier"/>
  <itemBody>
    <p>{}</p>
    <p><textEntryInteraction responseIdentifier="RESPONSE" expectedLength="12"/> {}</p>
  </itemBody>
  <responseProcessing>
    <responseCondition>
{}    </responseCondition>
  </responseProcessing>
{}</assessmentItem>
)",
      identifier, site::escaped(title), number(question["answer"]), plain_xml(question["ask"]),
      question["unit"] == "1" ? "" : site::escaped(question["unit"].get<std::string>()), rules, replies);
}

void write_qti(const fs::path& folder, const std::vector<Json>& all) {
  std::string resources;
  int index = 0;
  for (const Json& question : all) {
    const std::string identifier = fmt::format("prediction_{:03}", ++index), file = identifier + ".xml";
    course::write_whole(folder / file, item(question, identifier, name(question, index)));
    resources += fmt::format(
        "    <resource identifier=\"{}\" type=\"imsqti_item_xmlv2p1\" href=\"{}\"><file "
        "href=\"{}\"/></resource>\n",
        identifier, file, file);
  }
  course::write_whole(
      folder / "imsmanifest.xml",
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<manifest xmlns=\"http://www.imsglobal.org/xsd/imscp_v1p1\" "
      "identifier=\"constraints_by_hand\">\n  <metadata><schema>QTIv2.1 Package</schema><schemaversion>1.0.0"
      "</schemaversion></metadata>\n  <organizations/>\n  <resources>\n" +
          resources + "  </resources>\n</manifest>\n");
}

}  // namespace

void export_questions(const std::string& kind, const fs::path& folder, const fs::path& asked) {
  const std::vector<Json> all = asked.empty() ? questions() : questions_in(asked);
  if (kind == "moodle")
    course::write_whole(folder / "predictions.xml", moodle(all));
  else
    write_qti(folder, all);
}

}  // namespace byhand::practise
