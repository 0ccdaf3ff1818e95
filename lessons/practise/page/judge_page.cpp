// The judge of the exercises in a page. What a worker asks:
//
//     {"ask": "judge", "exercise": "08_bias", "said": the compiler's warnings}
//                                              {"kind", "sentence", "details", "printed", "line", "frames"}
//                                              and, of right code, "solution" and "derivation"
//     {"ask": "refused", "exercise": "08_bias", "said": …, "text": …, "by": "clang", "lld" or
//                                              "nobody", which broke off}    the same
//     {"ask": "excerpt", "exercise": "sweep", "said": …}
//                                              {"kind", "sentence", "details", "printed", "line", "svg"}: what a
//                                              lesson draws with its plain function, beside the reader's
//     {"ask": "masked", "exercise": "08_bias"} {"code", "test"}: a wrong code, and a test that it passes
//     {"ask": "unmask", "exercise": "08_bias", "numbers": "h=0.5"}    {"unmasked", "report"}
//     {"ask": "picture", "index": 12}          {"svg"}: the code that was judged last beside the right one
//     {"ask": "given", "exercise": "08_bias", "seed": 7}     numbers of all probes, which tests compare
//     {"ask": "film"}                          numbers of each frame of the code that was judged last, likewise
//
// The learner's functions are in another module with a memory of its own; the worker copies numbers between them.

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "lessons/02_single_constraint/plain_figure.hpp"
#include "lessons/02_single_constraint/plain_step.hpp"
#include "lessons/03_iterations/plain_figure.hpp"
#include "lessons/03_iterations/plain_sweep.hpp"
#include "lessons/04_baumgarte/plain_bias.hpp"
#include "lessons/04_baumgarte/plain_figure.hpp"
#include "lessons/05_contact/plain_clamp.hpp"
#include "lessons/05_contact/plain_figure.hpp"
#include "lessons/page/answered.hpp"
#include "lessons/practise/judge/comparison.hpp"
#include "lessons/practise/judge/compiled.hpp"
#include "lessons/practise/judge/judge.hpp"
#include "lessons/practise/judge/stopped.hpp"
#include "lessons/practise/judge/unmask.hpp"
#include "renderer/svg_canvas.hpp"

#define PAGE(name) extern "C" __attribute__((import_module("page"), import_name(#name)))

/// Calls function `which` of the learner's module. Returns how many numbers it answers, which take() copies, or
/// −1: it stopped, and stop() says why.
PAGE(call) int page_call(int which, const double* in, int count);
PAGE(take) void page_take(double* out);
/// An index of `Why`, the learner's line or 0, and a number that belongs to the reason.
PAGE(stop) void page_stop(double* why);
/// What the learner's code printed.
PAGE(printed_size) int page_printed_size();
PAGE(printed) void page_printed(char* out);

namespace {

using namespace byhand::practise;
using Json = nlohmann::json;

constexpr int most_printed = 64, most_memory = 256;  // KB, MB: as judge_worker.js and commands.js have them

std::string printed() {
  std::string text(static_cast<std::size_t>(page_printed_size()), '\0');
  page_printed(text.data());
  return text;
}

/// Of a program that called abort(): what an assertion, its own or the library's, printed before.
std::string aborted(double line) {
  const std::string text = printed();
  if (const std::string own = rest_of_line(text, "Assertion failed: "); !own.empty())
    return fmt::format("Your assertion `{}' failed{}.", own.substr(0, own.rfind(" (")), in_line(line));
  if (const std::string library = rest_of_line(text, " failed: "); !library.empty())
    return fmt::format("Your code crashed{}: {}.", in_line(line), library);
  return fmt::format("Your code called abort(){}.", in_line(line));
}

/// Why a learner's code stopped, in the order that judge_worker.js has.
enum class Why {
  not_written,
  undefined,
  endless,
  no_memory,
  too_deep,
  crashed,
  aborted,
  exited,
  printed,
  system,
  answered,
  no_room,
  foreign
};

Stopped stopped() {
  std::array<double, 3> said{};
  page_stop(said.data());
  const auto [why, line, more] = said;
  switch (static_cast<Why>(why)) {
    case Why::not_written: return {"Not written yet.", true};
    case Why::undefined:
      if (is_undefined(more, line)) return {undefined_sentence(more, line)};
      break;
    case Why::endless:
      return {fmt::format("Your code did not return{}; look for a loop that never ends.", in_line(line))};
    case Why::no_memory:
      return {fmt::format("Your code asked for more than {} MB of memory{}.", most_memory, in_line(line))};
    case Why::too_deep:
      return {fmt::format("Your code calls itself without an end{}: the stack is full.", in_line(line))};
    case Why::aborted: return {aborted(line)};
    case Why::exited:
      return {fmt::format("Your code ended the program with status {:.0f}{} instead of returning a value.", more,
                          in_line(line))};
    case Why::printed: return {fmt::format("Your code printed more than {} KB.", most_printed)};
    case Why::system:
      return {
          "Your code asked the system for a file, a process, the time or the network; an exercise needs none."};
    case Why::answered: return {"Your code answered more numbers than an exercise has."};
    case Why::no_room:
      return {"This browser has no memory left for your code: close other pages, and check again."};
    case Why::foreign:
      return {
          "Your program does not begin: it imports or exports functions by their names, which an exercise never "
          "does."};
    case Why::crashed: break;
  }
  return {fmt::format("Your code crashed{}: it used memory that is not its own. Look at pointers and indices.",
                      in_line(line))};
}

Numbers call(std::size_t which, const Numbers& in) {
  const int count = page_call(static_cast<int>(which), in.data(), static_cast<int>(in.size()));
  if (count < 0) throw stopped();
  Numbers out(static_cast<std::size_t>(count));
  page_take(out.data());
  return out;
}

std::map<std::string, Key> keys;
Film yours, right;

const Exercise& named(const std::string& name) {
  for (const Exercise& exercise : exercises())
    if (exercise.name == name) return exercise;
  throw std::invalid_argument("There is no exercise " + name);
}

const Key& key_of(const Exercise& exercise) {
  if (!keys.contains(exercise.name)) keys[exercise.name] = key(exercise, 1);
  return keys[exercise.name];
}

const char* word(Verdict::Kind kind) {
  constexpr const char* words[] = {"right",       "misconception", "wrong",
                                   "not_written", "stopped",       "does_not_compile"};
  return words[static_cast<std::size_t>(kind)];
}

Json told(const Verdict& verdict) {
  return {{"kind", word(verdict.kind)},
          {"sentence", verdict.sentence},
          {"details", verdict.details},
          {"printed", verdict.printed},
          {"line", verdict.line}};
}

/// As the compilers know the learner's file.
std::string file_of(const std::string& exercise) { return "/learner/" + exercise + ".cpp"; }

Json judged(const Exercise& exercise, const std::string& said) {
  const Key& key = key_of(exercise);
  Verdict verdict = judge(exercise, key, call);
  verdict.printed = printed();
  finish(verdict, Messages(said, file_of(exercise.name)).warnings);
  yours = verdict.film;
  right = key.film;
  Json answer = told(verdict);
  answer["frames"] = yours.frames.empty() ? 0 : right.frames.size();
  if (verdict.is_right()) {
    answer["solution"] = contents_of(exercise.folder() / "solution.cpp");
    answer["derivation"] = task(exercise).derivation;
  }
  return answer;
}

Verdict not_made(const std::string& exercise, const Json& request) {
  const std::string by = request.at("by"), said = request.at("said"), text = request.at("text");
  if (text.size() > most_text) return not_compiled(too_long(exercise + ".cpp"));
  if (by == "lld") return not_compiled(about_linking(said, text));
  if (by == "clang") return not_compiled("It does not compile.", Messages(said, file_of(exercise)));
  return not_compiled("The compiler broke off: look for what is very long or nested very deeply.");
}

Json refused(const std::string& exercise, const Json& request) {
  Verdict verdict = not_made(exercise, request);
  finish(verdict, "");
  return told(verdict);
}

/// What a lesson draws with its plain function, beside the reader's.
template <auto ours, auto chart_beside_ours>
byhand::renderer::Chart beside(const Code& readers) {
  return chart_beside_ours(Function<decltype(ours)>(readers, 0));
}
const std::map<std::string, byhand::renderer::Chart (*)(const Code&)> excerpts = {
    {"step", beside<&byhand::single_constraint::plain_step, &byhand::single_constraint::chart_beside_ours>},
    {"sweep", beside<&byhand::iterations::plain_sweep, &byhand::iterations::chart_beside_ours>},
    {"bias", beside<&byhand::baumgarte::plain_bias, &byhand::baumgarte::chart_beside_ours>},
    {"clamp", beside<&byhand::contact::plain_change, &byhand::contact::chart_beside_ours>}};

/// An excerpt is not judged: what it does is drawn.
Json drawn(const std::string& name, const std::string& said) {
  Verdict verdict;
  Json svg;
  try {
    const byhand::renderer::Chart chart = excerpts.at(name)(call);
    byhand::renderer::SvgCanvas canvas(1280, "excerpt");
    byhand::renderer::draw(canvas, chart, canvas.page().inset(20));
    svg = canvas.svg("Yours beside the lesson's");
  } catch (const Stopped& stopped) {
    verdict.kind = Verdict::Kind::stopped;
    verdict.sentence = stopped.sentence;
  }
  verdict.printed = printed();
  finish(verdict, Messages(said, file_of(name)).warnings);
  Json answer = told(verdict);
  if (!svg.is_null()) answer["svg"] = svg;
  return answer;
}

Json picture(int index) {
  byhand::renderer::SvgCanvas canvas(1280, "judged");
  draw(canvas, yours, right, index);
  return {{"svg", canvas.svg("Your code beside the right one")}};
}

Json unmasked(const Exercise& exercise, const std::string& numbers) {
  std::string report;
  try {
    const bool wrong = unmask(exercise, numbers, report);
    return {{"unmasked", wrong}, {"report", report}};
  } catch (const std::invalid_argument& bad) {
    return {{"unmasked", false}, {"report", std::string(bad.what()) + ".\n"}};
  }
}

Json film_of(const Film& film) {
  Json all = Json::array();
  for (const Frame& frame : film.frames) all.push_back(numbers_of(frame));
  return all;
}

Json given(const Exercise& exercise, std::uint64_t seed) {
  Json all = Json::array();
  for (int i = 0; i < probes; ++i)
    for (const Line& line : sheet(exercise, exercise.variants.front().code, seed, i))
      if (line.kind == Line::Kind::given) all.push_back({line.name, line.values});
  return all;
}

Json answer_to(const Json& request) {
  const std::string ask = request.at("ask");
  if (ask == "picture") return picture(request.at("index"));
  if (ask == "film") return film_of(yours);
  if (ask == "excerpt") return drawn(request.at("exercise"), request.at("said"));
  if (ask == "refused") return refused(request.at("exercise"), request);
  const Exercise& exercise = named(request.at("exercise"));
  if (ask == "judge") return judged(exercise, request.at("said"));
  if (ask == "given") return given(exercise, request.at("seed"));
  if (ask == "masked") return {{"code", masked_code(exercise)}, {"test", blind_test(exercise)}};
  if (ask == "unmask") return unmasked(exercise, request.at("numbers"));
  throw std::invalid_argument("Asked for " + ask);
}

}  // namespace

std::string byhand::course::answered(const std::string& request) {
  try {
    return answer_to(Json::parse(request)).dump(-1, ' ', false, Json::error_handler_t::replace);
  } catch (const std::exception& error) {
    return Json{{"error", error.what()}}.dump();
  }
}
