#pragma once

#include <map>
#include <memory>

#include "lessons/desk/errors.hpp"
#include "lessons/desk/parse.hpp"

namespace byhand::desk {

/// What the desk says about one line, or one side of it.
struct Check {
  enum class Outcome { told, right, wrong, unreadable };

  Outcome outcome = Outcome::told;
  int line = 0;       // from 1
  std::string typed;  // the whole line
  Span where;         // of the side, or of what is wrong in it
  std::string head;   // "C", "dC2", "J", …
  std::string characters, latex;
  std::string sentence;
  std::string numbers;  // at one state, of a wrong line
  Finding finding;      // of a wrong line
};

/// One row of a constraint, as far as it is derived; several if C is a vector.
struct Row {
  Expression C, rate, right_rate;
  std::vector<Expression> J;  // right parts as they were typed
  bool inequality = false;
  bool astray = false;  // the last rate follows from a wrong one
};

/// A learner's lines, each checked against the one before.
class Sheet {
 public:
  explicit Sheet(World world = {});

  /// Reads a line and says what is right or wrong; a chain a = b = c gives a check for each side.
  std::vector<Check> add(const std::string& line);
  /// A task's C, which a typed C is held against.
  void set_goal(const std::string& C) { goal_ = C; }

  /// 0 all is right, 1 a line is wrong, 2 a line cannot be read.
  int status() const { return status_; }
  const Vocabulary& words() const { return *words_; }
  const std::map<std::string, Row>& rows() const { return rows_; }
  /// Rows whose J is right.
  bool complete() const;

 private:
  bool told(const std::string& line, std::vector<Check>& checks);
  Check check(const Line& line, std::size_t side, bool first);
  void check_constraint(Row& row, const Expression& e, bool first, Check& check);
  void check_rate(Row& row, const Expression& e, bool first, Check& check);
  void check_parts(Row& row, const Side& side, bool first, Check& check);
  void judged(Check& check, const Verdict& verdict, const char* against) const;
  void wrong(Check& check, const Expression& typed, const Expression& right, Finding finding) const;

  std::unique_ptr<Vocabulary> words_;
  std::map<std::string, Row> rows_;  // by what stands behind C, dC, J: "", "1", …
  std::string head_, goal_;
  Expression last_J_rate_;  // JV of the last J, which another J goes on from
  int lines_ = 0, status_ = 0;
};

/// Values of both sides and of the symbols in them, at a simple state at which they differ.
std::string numbers_at_one_state(const Vocabulary& words, const Expression& typed, const Expression& right);

}  // namespace byhand::desk
