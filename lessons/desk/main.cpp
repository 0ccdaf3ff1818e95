// The derivation desk at a terminal and for files. Started by `lessons/run desk`.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>

#include "lessons/desk/print.hpp"
#include "lessons/desk/report.hpp"
#include "lessons/desk/scenes.hpp"
#include "lessons/desk/task_files.hpp"
#include "lessons/files/streams.hpp"
#include "lessons/terminal/keyboard.hpp"
#include "lessons/terminal/screen.hpp"

namespace {

namespace fs = std::filesystem;
using namespace byhand::desk;
using byhand::course::Style;
using byhand::course::Tone;
using byhand::course::toned;
using Outcome = Check::Outcome;

enum ExitStatus { all_right = 0, a_line_is_wrong = 1, unreadable = 2, no_environment = 3 };

struct Options {
  std::string file, scene;
  int task = 0, hints = 1;
  bool tasks = false, code = false, errors = false;
};

/// At most so much of a stream is read: a derivation has some lines, a device has no end.
constexpr std::size_t longest_file = 1'000'000, longest_line = 2000;

std::string read_all(std::istream& stream, const std::string& name) {
  std::string text(longest_file + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (stream.bad() || !(stream || stream.eof())) throw std::invalid_argument(name + " cannot be read");
  if (text.size() > longest_file)
    throw std::invalid_argument(name + " has more than a million characters: a derivation has some lines");
  return text;
}

std::string read_file(const fs::path& path) {
  if (fs::is_directory(path)) throw std::invalid_argument(path.string() + " is a folder, not a file of lines");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::invalid_argument(path.string() + " cannot be read");
  return read_all(stream, path.string());
}

std::vector<Task> tasks() { return read_tasks(fs::path(BYHAND_DESK_FOLDER) / "tasks"); }

/// The columns of a text in UTF-8 before a byte.
int columns(const std::string& text, int bytes) {
  return byhand::course::display_width(std::string_view(text).substr(
      0, static_cast<std::size_t>(std::clamp(bytes, 0, static_cast<int>(text.size())))));
}

std::string spoken(const Check& check, int hints, const Style& style) {
  std::string text;
  const bool bad = check.outcome == Outcome::wrong || check.outcome == Outcome::unreadable;
  if (bad) {
    const int begin = columns(check.typed, check.where.begin),
              end = std::max(begin + 1, columns(check.typed, check.where.end));
    text += "  " + std::string(static_cast<std::size_t>(begin), ' ') +
            toned(std::string(static_cast<std::size_t>(end - begin), '^'), Tone::bad, style) + "\n";
  }
  const char* mark = bad ? "✗ " : check.outcome == Outcome::right ? "✓ " : "  ";
  std::string said = check.sentence;
  if (bad && !check.finding.name.empty()) said += " (" + check.finding.name + ")";
  text += toned(mark, bad ? Tone::bad : Tone::good, style) +
          byhand::course::wrapped(byhand::course::printable(said), style, 2).substr(2);
  if (!check.numbers.empty()) text += byhand::course::wrapped(check.numbers, style, 2);
  for (int i = 0; i < hints && bad; ++i)
    if (!check.finding.hints[static_cast<std::size_t>(i)].empty())
      text += byhand::course::wrapped("Hint: " + check.finding.hints[static_cast<std::size_t>(i)], style, 2);
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    all.push_back(line);
    if (line.size() > longest_line)
      throw std::invalid_argument(
          fmt::format("line {} has {} characters; a line may have {}", all.size(), line.size(), longest_line));
  }
  return all;
}

int check_file(const Options& options) {
  const Style style{.width = 100, .colours = isatty(STDOUT_FILENO) != 0};
  Sheet sheet;
  const bool typed = options.file == "-";
  const std::string text = typed ? read_all(std::cin, "standard input") : read_file(options.file);
  bool empty = true;
  for (const std::string& line : lines_of(text)) {
    const auto checks = sheet.add(line);
    empty = empty && checks.empty();
    if (options.code) continue;
    if (!checks.empty() || line.starts_with("#")) std::cout << "  " << byhand::course::printable(line) << "\n";
    for (const Check& check : checks) std::cout << spoken(check, options.hints, style);
  }
  if (empty) throw std::invalid_argument((typed ? "standard input" : options.file) + " has no line to judge");
  if (options.code) {
    const std::string code = cpp_struct(sheet);
    if (sheet.status() != 0 || code.empty())
      throw std::invalid_argument(options.file +
                                  " has no derivation from C to J that is right, so there is no code to print");
    std::cout << "#include \"solver/byhand.hpp\"\n\n" << code;
  } else if (sheet.complete()) {
    std::cout << "\n" << text_of(report(sheet));
  }
  if (!options.scene.empty()) std::cout << "\n" << run_scene(sheet, options.scene);
  return sheet.status();
}

constexpr const char* words_of_the_dialogue =
    "Type a line: C = …, dC = …, = …, J = [l1, a1, l2, a2]; \"in space\" or \"a: unit vector on body 1\" before "
    "it.\n"
    "Besides: hint, report, run (pendulum, chain, box), code, task N, tasks, names, undo, new, q.\n";

class Dialogue {
 public:
  explicit Dialogue(const Options& options) : screen_(keyboard_, false) {
    std::cout << "\n" << toned("The derivation desk", Tone::title, style()) << "\n" << words_of_the_dialogue;
    if (options.task > 0) begin_task(options.task);
  }

  int run() {
    while (true) {
      std::cout << std::flush;
      const auto line = keyboard_.line(toned("▸ ", Tone::question, Style{}));
      if (!line || *line == "q" || *line == "quit") break;
      answer(*line);
    }
    return sheet_->status();
  }

 private:
  Style style() const { return screen_.style(); }

  void answer(const std::string& line) {
    std::istringstream stream(line);
    std::string word, behind;
    stream >> word >> behind;
    if (word.empty()) return;
    if (word == "?" || word == "help") {
      std::cout << words_of_the_dialogue;
    } else if (line == "hint") {
      hint();
    } else if (line == "report") {
      std::cout << (sheet_->complete() ? text_of(report(*sheet_)) : "The report follows once J stands.\n");
    } else if (word == "run") {
      std::cout << run_scene(*sheet_, behind.empty() ? "pendulum" : behind);
    } else if (line == "code") {
      const std::string code = cpp_struct(*sheet_);
      std::cout << (code.empty() ? "Code follows once J stands, for rows that all have a C or all have none.\n"
                                 : code);
    } else if (line == "tasks") {
      int i = 0;
      for (const Task& task : tasks()) std::cout << "  " << ++i << "  " << task.title << "\n";
    } else if (word == "task" && !behind.empty()) {
      begin_task(std::atoi(behind.c_str()));
    } else if (line == "names") {
      names();
    } else if (line == "new") {
      lines_.clear();
      sheet_ = std::make_unique<Sheet>();
    } else if (line == "undo") {
      if (!lines_.empty()) lines_.pop_back();
      replay();
    } else {
      type(line);
    }
  }

  void type(const std::string& line) {
    const bool before = sheet_->complete();
    lines_.push_back(line);
    for (Check& check : sheet_->add(line)) {
      // The prompt stands before the line.
      std::cout << spoken(check, 0, style());
      if (check.outcome == Outcome::wrong) last_ = check.finding, hints_ = 0;
    }
    if (!before && sheet_->complete())
      std::cout << text_of(report(*sheet_)) << "It runs: run pendulum, run chain, run box. Its code: code.\n";
  }

  void hint() {
    if (!last_ || hints_ == 3 || last_->hints[static_cast<std::size_t>(hints_)].empty()) {
      std::cout << (last_ ? "There are no more hints for that line.\n" : "No line is wrong yet.\n");
      return;
    }
    std::cout << byhand::course::wrapped(last_->hints[static_cast<std::size_t>(hints_++)], style(), 2);
  }

  void names() const {
    std::string all;
    for (const Symbol& s : sheet_->words().all())
      all += s.name + " " +
             (s.is == Symbol::Is::defined ? "= " + characters(s.definition) : "[" + text_of(s.unit) + "]") + ", ";
    std::cout << byhand::course::wrapped(all.substr(0, all.size() - 2) + ".", style(), 2);
  }

  void begin_task(int number) {
    const auto all = tasks();
    if (number < 1 || number > static_cast<int>(all.size())) {
      std::cout << "There are tasks 1 to " << all.size() << ".\n";
      return;
    }
    const Task& task = all[static_cast<std::size_t>(number - 1)];
    lines_ = task.before;
    lines_.insert(lines_.end(), task.start.begin(), task.start.end());
    std::cout << "\n"
              << toned(std::to_string(number) + " " + task.title, Tone::title, style()) << "\n"
              << byhand::course::wrapped(task.text, style());
    replay();
    for (const std::string& line : lines_) std::cout << "  " << line << "\n";
    std::cout << "Go on from here to J.\n";
  }

  void replay() {
    sheet_ = std::make_unique<Sheet>();
    for (const std::string& line : lines_) sheet_->add(line);
    last_.reset();
  }

  byhand::course::Keyboard keyboard_;
  byhand::course::Screen screen_;
  std::unique_ptr<Sheet> sheet_ = std::make_unique<Sheet>();
  std::vector<std::string> lines_;
  std::optional<Finding> last_;
  int hints_ = 0;
};

int run(const Options& options) {
  if (options.tasks) {
    int i = 0;
    for (const Task& task : tasks()) std::cout << ++i << "  " << task.title << "\n   " << task.text << "\n";
    return all_right;
  }
  if (options.errors) {
    for (const Error& error : errors()) std::cout << error.name << ": " << error.sentence << "\n";
    return all_right;
  }
  if (!options.file.empty()) return check_file(options);
  if (options.code) throw std::invalid_argument("--code prints the code of a derivation in a FILE");
  if (!isatty(STDIN_FILENO)) {
    Options from_input = options;
    from_input.file = "-";
    return check_file(from_input);
  }
  return Dialogue(options).run();
}

}  // namespace

int main(int argc, char** argv) {
  byhand::course::open_standard_streams();
  Options options;
  CLI::App app("Type C, differentiate by hand, and be told which line is wrong and why.", "./lessons/run desk");
  app.footer(
      "A line is C = …, dC = …, = … or J = [l1, a1, l2, a2], typed plainly or as LaTeX; each is held against the "
      "one\n"
      "before. Vectors are multiplied by . and x, |d| is a length, ' a rate. Before the first formula may stand\n"
      "\"in space\" or \"particles in the plane\"; \"a: unit vector on body 1\" says what a name of your own "
      "is.\n\n"
      "Exit status: 0 every line is right, 1 one is wrong, 2 one cannot be read, or bad usage, 3 the "
      "environment.");
  app.set_help_flag("--help", "this page");
  app.add_option("FILE", options.file, "lines to be checked; - reads standard input; without it: a dialogue");
  app.add_option("--task", options.task, "begin with a worked task")->check(CLI::Range(1, 12));
  app.add_flag("--tasks", options.tasks, "list the tasks");
  app.add_option("--hints", options.hints, "hints for each wrong line of a FILE")->check(CLI::Range(0, 3));
  app.add_option("--run", options.scene, "run what FILE derives in a scene: pendulum, chain or box");
  app.add_flag("--code", options.code, "print what FILE derives as a struct for the solver");
  app.add_flag("--errors", options.errors, "list the errors that have names");
  try {
    app.parse(argc, argv);
    const int status = run(options);
    std::cout.flush();
    return std::cout ? status : static_cast<int>(no_environment);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return all_right;
  } catch (const CLI::ParseError& bad) {
    byhand::course::complain(std::string(bad.what()) + "; --help shows the options\n");
    return unreadable;
  } catch (const std::invalid_argument& bad) {
    byhand::course::complain(byhand::course::printable(bad.what()) + "\n");
    return unreadable;
  } catch (const std::exception& bad) {
    byhand::course::complain(byhand::course::printable(bad.what()) + "\n");
    return no_environment;
  }
}
