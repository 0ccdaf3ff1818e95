// The course as a web site: every lesson's program writes its page, and this one what they share. Started by
// `lessons/run site`.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "lessons/desk/task_files.hpp"
#include "lessons/files/atomic_file.hpp"
#include "lessons/files/child_process.hpp"
#include "lessons/files/command_line.hpp"
#include "lessons/files/options.hpp"
#include "lessons/files/printed_by.hpp"
#include "lessons/files/streams.hpp"
#include "lessons/page/about.hpp"
#include "lessons/page/error.hpp"
#include "lessons/site/course/book.hpp"
#include "lessons/site/course/course_pages.hpp"
#include "lessons/site/course/desk_page.hpp"
#include "lessons/site/course/downloads.hpp"
#include "lessons/site/course/packed.hpp"
#include "lessons/site/course/plan.hpp"
#include "lessons/site/course/playground_page.hpp"
#include "lessons/site/course/site_folder.hpp"
#include "lessons/site/course/slides.hpp"
#include "lessons/site/course/versions.hpp"
#include "lessons/site/course/zip.hpp"
#include "lessons/site/lesson_page.hpp"
#include "lessons/site/page_json.hpp"

namespace {

namespace fs = std::filesystem;
using namespace byhand;

constexpr int fine = 0;

struct Wanted {
  std::string output = course::default_output().string(), repository;
  std::vector<std::string> lessons;  // all if empty
  bool quiet = false, without_slides = false, without_answers = false, exercises = false;
};

/// A program that this one started did not do its work; `status` is its exit status.
struct Failed : std::runtime_error {
  Failed(const std::string& words, const course::Ended& how) : std::runtime_error(words), ended(how) {}
  course::Ended ended;
};

void build(const std::string& target) {
  const char* builder = std::getenv("BYHAND_BUILD");
  if (builder == nullptr) return;
  const course::Ended ended = course::run_program(builder, {target}, course::Group::own);
  if (!ended.well()) throw Failed("", ended);
}

/// Compiles these lessons, all if there is none, for a browser, so that their pages are live. False without what
/// that needs.
bool write_live(const fs::path& folder, const std::vector<std::string>& lessons) {
  const char* builder = std::getenv("BYHAND_LIVE");
  if (builder == nullptr) return false;
  std::vector<std::string> arguments{(folder / "live").string()};
  arguments.insert(arguments.end(), lessons.begin(), lessons.end());
  if (!lessons.empty()) arguments.insert(arguments.end(), {"desk", "playground"});
  const course::Ended ended = course::run_program(builder, arguments, course::Group::own);
  if (ended.by_signal) throw Failed("", ended);
  return ended.well();
}

/// The page in which exercises are compiled and judged, to which all others lead (see has_exercises). False
/// without what that needs, such as a network.
bool write_exercises(const fs::path& folder) {
  const fs::path builder = fs::path(BYHAND_SITE_FOLDER) / "../practise/page/build";
  const course::Ended ended = course::run_program(builder.string(), {folder.string()}, course::Group::own);
  if (ended.by_signal) throw Failed("", ended);
  if (!ended.well()) {
    fs::remove_all(folder / "practise");
    return false;
  }
  build("page_practise");
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "page_practise";
  const course::Ended written = course::run_program(program.string(), {folder.string()}, course::Group::ours);
  if (!written.well()) throw Failed("page_practise ended with an error", written);
  return true;
}

/// Runs a lesson's program and returns the digest that it left in the folder.
site::Digest write_lesson(const std::string& slug, const fs::path& folder, const Wanted& wanted) {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / ("page_" + slug);
  std::vector<std::string> arguments{folder.string()};
  if (wanted.quiet) arguments.emplace_back("--quiet");
  const course::Ended ended = course::run_program(program.string(), arguments, course::Group::ours);
  if (!ended.well()) throw Failed(fmt::format("{} ended with status {}", slug, ended.status), ended);
  const fs::path file = folder / (slug + ".json");
  const auto text = course::read_whole(file);
  if (!text) throw std::runtime_error(fmt::format("{} wrote no {}", slug, file.filename().string()));
  fs::remove(file);
  return site::digest_from_json(*text);
}

/// The casebook, a page for each case. False where its program does not stand beside this one.
bool write_cases(const fs::path& folder, bool quiet) {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "page_cases";
  if (!fs::exists(program)) return false;
  std::vector<std::string> arguments{folder.string()};
  if (quiet) arguments.emplace_back("--quiet");
  const course::Ended ended = course::run_program(program.string(), arguments, course::Group::ours);
  if (!ended.well()) throw Failed(fmt::format("page_cases ended with status {}", ended.status), ended);
  return true;
}

void copy_assets(const fs::path& folder) {
  const fs::path assets = fs::path(BYHAND_SITE_FOLDER) / "assets";
  if (!fs::is_directory(assets))
    throw course::EnvironmentError(
        fmt::format("There is no folder {}: the checkout is not complete.", assets.string()));
  fs::copy(assets, folder / "assets", fs::copy_options::recursive);
}

/// Fetches reveal.js, then writes each lesson as slides. False where it cannot be fetched.
bool write_slides(const fs::path& site, const std::vector<site::Digest>& lessons) {
  const fs::path folder = site / "slides", fetch = fs::path(BYHAND_SITE_FOLDER) / "fetch_reveal";
  const course::Ended ended =
      course::run_program(fetch.string(), {(folder / "reveal").string()}, course::Group::own);
  if (ended.by_signal) throw Failed("", ended);
  if (!ended.well()) return false;
  for (const site::Digest& lesson : lessons)
    course::write_whole(folder / site::page_of(lesson.slug), site::slides(site, lesson));
  return true;
}

/// Quizzes and handouts, which the exercises' program makes from the questions that the lessons left. Nothing
/// where that program does not stand beside this one.
void write_for_a_class(const fs::path& site) {
  build("practise");
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "practise",
                 asked = site / "questions", made = site / "for_a_class";
  if (fs::exists(program)) {
    for (const std::string kind : {"moodle", "qti", "handouts"}) {
      std::vector<std::string> arguments{"--export", kind, "--to", (made / kind).string()};
      if (kind != "handouts") arguments.insert(arguments.end(), {"--questions", asked.string()});
      course::printed_by(program.string(), arguments);
    }
    const fs::path downloads = site / "downloads";
    course::write_whole(downloads / "predictions_moodle.xml",
                        course::read_whole(made / "moodle" / "predictions.xml").value_or(""));
    course::write_whole(downloads / "predictions_qti.zip", site::zip_of(made / "qti"));
    course::write_whole(downloads / "exercises.zip", site::zip_of(made / "handouts"));
  }
  fs::remove_all(made);
  fs::remove_all(asked);
}

/// The lessons of these names, in the course's order; all without a name.
std::vector<course::About> chosen(const std::vector<std::string>& names) {
  std::vector<course::About> all = course::contents();
  for (const std::string& name : names)
    if (std::none_of(all.begin(), all.end(), [&](const course::About& about) { return about.slug == name; }))
      throw std::invalid_argument(fmt::format("--lesson {}: there is no such lesson", course::printable(name)));
  if (!names.empty())
    std::erase_if(all, [&](const course::About& about) {
      return std::find(names.begin(), names.end(), about.slug) == names.end();
    });
  return all;
}

int run(const Wanted& wanted) {
  const fs::path output = fs::path(wanted.output) / "site";
  site::SiteFolder folder(output);
  const std::vector<course::About> contents = chosen(wanted.lessons);
  if (wanted.lessons.empty()) build("pages");
  for (const std::string& lesson : wanted.lessons) build("page_" + lesson);
  if (!wanted.lessons.empty()) build("page_cases");
  const bool live = write_live(folder.path(), wanted.lessons);
  const bool exercises = wanted.exercises && write_exercises(folder.path());
  std::vector<site::Digest> lessons;
  for (const course::About& lesson : contents) {
    if (!wanted.quiet) fmt::print(stderr, "{} of {}: {}\n", lessons.size() + 1, contents.size(), lesson.title);
    lessons.push_back(write_lesson(lesson.slug, folder.path(), wanted));
  }
  const auto write = [&](const char* name, const std::string& bytes) {
    course::write_whole(folder.path() / name, bytes);
  };
  const bool cases = write_cases(folder.path(), wanted.quiet);
  site::pack_narrow_pictures(folder.path());
  copy_assets(folder.path());
  const bool desk = fs::exists(folder.path() / "live" / "desk.js");
  write("index.html", site::contents_page(
                          lessons, {site::cover_scene(folder.path()), desk, exercises, cases, wanted.repository}));
  const fs::path tasks = fs::path(BYHAND_SITE_FOLDER) / "../desk/tasks";
  if (desk) write("desk.html", site::desk_page(desk::read_tasks(tasks), exercises));
  write("playground.html", site::playground_page(fs::exists(folder.path() / "live" / "playground.js"), exercises));
  write("equations.html", site::equations_page(exercises));
  write("laws.html", site::laws_page(lessons, exercises));
  if (!wanted.without_answers) write("answers.html", site::answer_key(folder.path(), lessons));
  for (const site::Digest& lesson : lessons) {
    course::write_whole(folder.path() / "downloads" / (lesson.slug + "_figures.zip"),
                        site::figures_of(folder.path(), lesson));
    fs::remove_all(folder.path() / lesson.slug / "films");
  }
  write("assets/search.js", site::packed_script("byhandSearch", site::search_index(lessons)));
  write("assets/equations.js", site::equations_script());
  write("constraints_by_hand.epub", site::book(folder.path(), lessons));
  const bool slides = wanted.without_slides || write_slides(folder.path(), lessons);
  write_for_a_class(folder.path());
  write("teaching.html",
        site::teaching_page(lessons, site::exercises_by_lesson(fs::path(BYHAND_SITE_FOLDER) / "../practise"),
                            folder.path()));
  site::write_versions(folder.path());
  folder.finish();
  if (!wanted.quiet && !live)
    fmt::print("Its pages are static: what compiles the lessons for a browser is missing.\n");
  if (!wanted.quiet && !slides) fmt::print("It has no slides: they stand on reveal.js, which npm fetches.\n");
  if (wanted.exercises && !exercises)
    fmt::print("It has no exercises: what compiles them in the page is missing, and is fetched by npm.\n");
  if (!wanted.quiet) fmt::print("The course as a web site: {}/index.html\n", course::printable(output.string()));
  return fine;
}

int command(int argc, const char* const* argv) {
  Wanted wanted;
  CLI::App app("The course as a web site, in output/site/", "./lessons/run site");
  app.footer(
      "The pages open from the disk or from any web server, and need nothing from elsewhere. An older site is\n"
      "replaced when the new one is complete; files that you added to it stay.\n\n"
      "Exit status: 0 fine, 1 a claim is false, 2 bad usage, 3 the environment (build, disk full, folder not "
      "writable).");
  app.set_help_flag("--help", "this page");
  app.add_option("--output", wanted.output, "folder that gets the folder site (default output/)")
      ->type_name("DIR")
      ->check(course::not_a_folder);
  app.add_option("--repository", wanted.repository, "address of the source, to which the first page links")
      ->type_name("URL")
      ->check([](const std::string& address) {
        return address.starts_with("https://") ? "" : "begins with https://, not \"" + address + "\"";
      });
  app.add_option(
         "--lesson", wanted.lessons,
         "only this lesson, such as 04_baumgarte; may stand several times. Links to the others lead nowhere")
      ->type_name("NAME");
  app.add_flag("--without-slides", wanted.without_slides,
               "without the lessons as slides, in site/slides/, which take reveal.js from npm");
  app.add_flag("--without-answers", wanted.without_answers, "without answers.html, the key to all questions");
  app.add_flag("--exercises", wanted.exercises,
               "also the exercises, compiled and judged in the page; takes clang from npm");
  app.add_flag("--quiet", wanted.quiet, "no progress, only what is wrong");
  try {
    app.parse(argc, argv);
    return run(wanted);
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", app.help());
    return fine;
  } catch (const CLI::ParseError& bad) {
    throw std::invalid_argument(fmt::format("{}; --help shows the options", bad.what()));
  } catch (const Failed& bad) {
    if (bad.ended.by_signal && bad.ended.passed_on) course::end_by(bad.ended.passed_on);
    if (*bad.what()) course::complain(course::printable(bad.what()) + "; the site stays as it was.\n");
    return bad.ended.status;
  }
}

}  // namespace

int main(int argc, char** argv) {
  return course::exit_status_of([&] { return command(argc, argv); });
}
