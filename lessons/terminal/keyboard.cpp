#include "lessons/terminal/keyboard.hpp"

#include <fmt/format.h>
#include <glib.h>
#include <histedit.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "lessons/files/atomic_file.hpp"
#include "lessons/terminal/typeset.hpp"

namespace byhand::course {
namespace {

constexpr wchar_t redisplay = L'\x1f';  // bound to libedit's command; nobody types it

constexpr size_t longest = 4096;  // bytes of a line that are kept, as a terminal does

volatile std::sig_atomic_t interrupted = 0, resized = 0;
constexpr std::array handled = {SIGINT, SIGWINCH, SIGCONT, SIGTERM, SIGHUP, SIGQUIT};
std::array<struct sigaction, handled.size()> former;  // what else handles them

termios found;  // the terminal as it was
bool changed = false;

void put_back_terminal() {
  if (changed) tcsetattr(STDIN_FILENO, TCSANOW, &found);
}

/// The next prompt ends the dialogue. Whatever takes longer than a second to reach it is aborted by the alarm.
extern "C" void on_interrupt(int) {
  interrupted = 1;
  alarm(1);
}

extern "C" void on_alarm(int) {
  constexpr char reset[] = "\033[0m\n";
  [[maybe_unused]] const auto written = write(STDOUT_FILENO, reset, sizeof reset - 1);
  put_back_terminal();
  remove_unfinished();
  _exit(128 + SIGINT);
}

/// The size has changed, or a stopped program goes on in a terminal that others have written on.
extern "C" void on_new_size(int) { resized = 1; }

/// Takes the terminal back as it was and ends as the signal asks.
extern "C" void on_end(int signal) {
  put_back_terminal();
  remove_unfinished();
  std::signal(signal, SIG_DFL);
  raise(signal);
}

/// Whether libedit can draw a terminal of this size: it keeps every cell of it.
bool can_be_edited() {
  constexpr int most_cells = 1'000'000;
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col * size.ws_row <= most_cells;
}

bool has_cursor() {
  const char* const terminal = std::getenv("TERM");
  return isatty(STDIN_FILENO) && isatty(STDOUT_FILENO) && terminal && *terminal &&
         std::string_view(terminal) != "dumb" && can_be_edited();
}

/// Keys are not echoed, and come one by one. Ctrl-S is a key like others: a lesson that it stopped would notice no
/// Ctrl-C. libedit undoes this at the end of each line.
void take_keys() {
  termios keys = found;
  keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  keys.c_iflag &= ~static_cast<tcflag_t>(IXON);
  tcsetattr(STDIN_FILENO, TCSADRAIN, &keys);
  changed = true;
}

std::string_view last_word(std::string_view line) {
  const auto blank = line.find_last_of(' ');
  return blank == std::string_view::npos ? line : line.substr(blank + 1);
}

}  // namespace

/// libedit, with a history of this session.
struct Keyboard::Editor {
  explicit Editor(Keyboard& owner)
      : keyboard(owner), line(el_init("byhand", stdin, stdout, stderr)), past(history_init()) {
    HistEvent event;
    history(past, &event, H_SETSIZE, 200);
    history(past, &event, H_SETUNIQUE, 1);
    el_set(line, EL_CLIENTDATA, this);
    el_set(line, EL_EDITOR, "emacs");
    el_set(line, EL_SIGNAL, 0);
    el_set(line, EL_SETTY, "-d", "-ixon", nullptr);
    el_set(line, EL_HIST, history, past);
    el_set(line, EL_PROMPT_ESC, &Editor::prompt_of, '\1');
    el_set(line, EL_GETCFN, &Editor::next_character);
    el_set(line, EL_ADDFN, "complete-word", "completes commands and parameters", &Editor::complete);
    el_set(line, EL_BIND, "^I", "complete-word", nullptr);
    el_set(line, EL_BIND, "^R", "em-inc-search-prev", nullptr);
    el_set(line, EL_BIND, "^_", "ed-redisplay", nullptr);
  }
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;
  ~Editor() {
    history_end(past);
    el_end(line);
  }

  static Editor& of(EditLine* line) {
    void* self = nullptr;
    el_get(line, EL_CLIENTDATA, &self);
    return *static_cast<Editor*>(self);
  }

  static char* prompt_of(EditLine* line) { return of(line).prompt.data(); }

  static int next_character(EditLine* line, wchar_t* character) {
    Editor& self = of(line);
    std::string& waiting = self.keyboard.waiting_;
    while (true) {
      if (std::exchange(resized, 0)) {
        if (can_be_edited()) el_resize(line);
        if (self.redraw) self.redraw();
        *character = redisplay;
        return 1;
      }
      const gunichar next = g_utf8_get_char_validated(waiting.data(), static_cast<gssize>(waiting.size()));
      const bool incomplete = waiting.empty() || next == static_cast<gunichar>(-2);
      if (!incomplete) {
        const bool valid = next != static_cast<gunichar>(-1);
        *character = valid ? static_cast<wchar_t>(next) : L'?';
        waiting.erase(0, valid ? static_cast<size_t>(g_unichar_to_utf8(next, nullptr)) : 1);
        return 1;
      }
      if (!self.keyboard.wait(-1, true)) return 0;
    }
  }

  static unsigned char complete(EditLine* line, int) {
    Editor& self = of(line);
    const LineInfo* const info = el_line(line);
    const std::string_view typed(info->buffer, static_cast<size_t>(info->cursor - info->buffer));
    const std::string_view begun = last_word(typed);
    std::vector<std::string> fitting;
    if (self.completion)
      for (std::string& word : self.completion(typed.substr(0, typed.size() - begun.size())))
        if (word.starts_with(begun)) fitting.push_back(std::move(word));
    if (fitting.empty()) return CC_REFRESH_BEEP;
    std::string common = fitting.front();
    for (const std::string& word : fitting)
      common.resize(static_cast<size_t>(
          std::mismatch(common.begin(), common.end(), word.begin(), word.end()).first - common.begin()));
    if (fitting.size() == 1) common += ' ';
    if (common.size() > begun.size()) {
      el_insertstr(line, common.substr(begun.size()).c_str());
      return CC_REFRESH;
    }
    std::string words;
    for (const std::string& word : fitting) words += "  " + word;
    fmt::print("\n{}\n", words);
    return CC_REDISPLAY;
  }

  Keyboard& keyboard;
  EditLine* line;
  History* past;
  std::string prompt;
  Completion completion;
  std::function<void()> redraw;
};

Keyboard::Keyboard() {
  // The lessons are written in UTF-8, whatever LANG says.
  std::setlocale(LC_CTYPE, "C.UTF-8");
  for (size_t i = 0; i < handled.size(); ++i) sigaction(handled[i], nullptr, &former[i]);
  struct sigaction action {};
  action.sa_handler = on_interrupt;  // without SA_RESTART: the signal interrupts poll()
  sigaction(SIGINT, &action, nullptr);
  std::signal(SIGALRM, on_alarm);
  if (!has_cursor() || tcgetattr(STDIN_FILENO, &found) != 0) return;
  action.sa_handler = on_new_size;
  sigaction(SIGWINCH, &action, nullptr);
  sigaction(SIGCONT, &action, nullptr);
  std::signal(SIGTERM, on_end);
  std::signal(SIGHUP, on_end);
  std::signal(SIGQUIT, on_end);
  editor_ = std::make_unique<Editor>(*this);
  take_keys();
}

Keyboard::~Keyboard() {
  editor_.reset();
  put_back_terminal();
  changed = false;
  for (size_t i = 0; i < handled.size(); ++i) sigaction(handled[i], &former[i], nullptr);
}

void Keyboard::on_tab(Completion completion) {
  if (editor_) editor_->completion = std::move(completion);
}

void Keyboard::on_resize(std::function<void()> redraw) {
  if (editor_) editor_->redraw = std::move(redraw);
}

bool Keyboard::wait(int milliseconds, bool or_resized) {
  using namespace std::chrono;
  const auto until = steady_clock::now() + milliseconds * 1ms;
  while (!interrupted) {
    // A signal may come just before poll(): it is noticed after a quarter of a second.
    int slice = 250;
    if (milliseconds >= 0)
      slice = static_cast<int>(
          std::clamp<long>(duration_cast<std::chrono::milliseconds>(until - steady_clock::now()).count(), 0, 250));
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (poll(&input, 1, slice) > 0) {
      std::array<char, 512> buffer{};
      const ssize_t count = read(STDIN_FILENO, buffer.data(), buffer.size());
      if (count <= 0) return false;
      waiting_.append(buffer.data(), static_cast<size_t>(count));
      return true;
    }
    if ((or_resized && resized) || (milliseconds >= 0 && steady_clock::now() >= until)) return true;
  }
  return false;
}

std::optional<std::string> Keyboard::line(const std::string& prompt) {
  const auto typed = read_line(prompt);
  // What follows was pasted, and is for the next prompts.
  kept_ = waiting_.size();
  return typed;
}

std::optional<std::string> Keyboard::read_line(const std::string& prompt) {
  if (!editor_) {
    std::string visible = prompt;
    std::erase(visible, '\1');
    fmt::print("{}", visible);
    std::fflush(stdout);
    return plain_line();
  }
  std::fflush(stdout);
  editor_->prompt = prompt;
  int count = 0;
  const char* const typed = interrupted ? nullptr : el_gets(editor_->line, &count);
  take_keys();
  if (!typed || count <= 0 || interrupted) return std::nullopt;
  std::string words(typed, static_cast<size_t>(count));
  words.erase(words.find_last_not_of("\r\n") + 1);
  HistEvent event;
  if (!words.empty()) history(editor_->past, &event, H_ENTER, words.c_str());
  return words;
}

std::optional<std::string> Keyboard::plain_line() {
  constexpr size_t endless = 1 << 20;  // /dev/zero has no lines
  std::string line;
  size_t passed = 0;
  const auto keep = [&](size_t end) { line.append(waiting_, 0, std::min(end, longest - line.size())); };
  while (waiting_.find('\n') == std::string::npos) {
    keep(waiting_.size());
    passed += waiting_.size();
    waiting_.clear();
    if (passed > endless || !wait(-1)) return std::nullopt;
  }
  const auto end = waiting_.find('\n');
  keep(end);
  waiting_.erase(0, end + 1);
  return line;
}

Key Keyboard::key_within(int milliseconds) {
  if (kept_ == waiting_.size() && !wait(milliseconds)) return Key::ended;
  if (kept_ == waiting_.size()) return Key::none;
  const char key = waiting_[kept_];
  const bool enter = key == '\n' || key == '\r', space = key == ' ' && editor_;
  if (!enter && !space) return ++kept_, Key::other;
  waiting_.erase(kept_, 1);
  return enter ? Key::enter : Key::space;
}

}  // namespace byhand::course
