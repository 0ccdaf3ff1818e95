#include "lessons/desk/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "lessons/desk/print.hpp"

namespace byhand::desk {
namespace {

using Outcome = Check::Outcome;

std::string trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r\n"), end = text.find_last_not_of(" \t\r\n");
  return begin == std::string_view::npos ? "" : std::string(text.substr(begin, end - begin + 1));
}

std::string shown(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", std::fabs(x) < 1e-12 ? 0 : x);
  return text[0] == '-' ? "−" + std::string(text + 1) : text;
}

template <class T>
std::string shown(const Value<T>& value) {
  if (value.shape.scalar()) return shown(value_of(value[0]));
  std::string text = "(";
  for (int i = 0; i < value.shape.rows; ++i) {
    if (i) text += value.shape.cols > 1 ? "; " : ", ";
    for (int j = 0; j < value.shape.cols; ++j) text += (j ? ", " : "") + shown(value_of(value(i, j)));
  }
  return text + ")";
}

std::string counted(int n, const char* what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); }

bool world_of(const std::string& line, World& world) {
  std::string text = line;
  if (text.ends_with('.')) text.pop_back();
  const bool particles = text.starts_with("particles ");
  if (particles) text = text.substr(10);
  if (text != "in the plane" && text != "in space") return false;
  world = {text == "in space" ? 3 : 2, !particles};
  return true;
}

/// Whether a rate is linear in v and ω: the sum of its coefficients times them.
bool linear(const Vocabulary& words, const Expression& rate) {
  Random random(11);
  for (int i = 0; i < 4; ++i) {
    const State<double> state = random_state(words, random);
    const auto J = coefficients(words, state, rate);
    const auto value = evaluate(*rate, environment<Tracked>(words, state));
    std::vector<double> V;
    for (const Symbol* w : velocities(words))
      for (int k = 0; k < w->shape.size(); ++k) V.push_back(state[static_cast<std::size_t>(w->id)][k]);
    for (std::size_t r = 0; r < J.size(); ++r) {
      double sum = 0, size = 1;
      for (std::size_t k = 0; k < V.size(); ++k) {
        sum += J[r][k] * V[k];
        size += std::fabs(J[r][k] * V[k]);
      }
      if (std::isfinite(sum) && std::fabs(sum - value[static_cast<int>(r)].at) > 1e-9 * size) return false;
    }
  }
  return true;
}

/// Whether the parts are right once the two in the middle are exchanged.
bool in_another_order(const Judge& judge, const std::vector<Expression>& parts, const Expression& rate) {
  if (parts.size() != 4) return false;
  try {
    return judge.compare(rate_by(judge.words(), {parts[0], parts[2], parts[1], parts[3]}, rate->shape, {}), rate)
        .equal;
  } catch (const Misfit&) {
    return false;
  }
}

}  // namespace

std::string numbers_at_one_state(const Vocabulary& words, const Expression& typed, const Expression& right) {
  Random random(3);
  for (int i = 0; i < 60; ++i) {
    const auto values = environment<Tracked>(words, simple_state(words, random));
    const auto mine = evaluate(*typed, values), theirs = evaluate(*right, values);
    if (!(mine.shape == theirs.shape) || agree(mine, theirs) != std::optional(false)) continue;
    std::string text;
    std::set<const Symbol*> said;
    for (const Expression& side : {right, typed})
      visit(side, [&](const Expression& e) {
        if (e->symbol && e->symbol->axis < 3 && said.insert(e->symbol).second)
          text += (text.empty() ? "At " : ", ") + e->symbol->name + " = " +
                  shown(values[static_cast<std::size_t>(e->symbol->id)]);
      });
    return text + (text.empty() ? "Yours" : ": yours") + " is " + shown(mine) + ", right is " + shown(theirs) +
           ".";
  }
  return "";
}

Sheet::Sheet(World world) : words_(std::make_unique<Vocabulary>(world)) {}

bool Sheet::complete() const {
  return !rows_.empty() &&
         std::all_of(rows_.begin(), rows_.end(), [](const auto& row) { return !row.second.J.empty(); });
}

bool Sheet::told(const std::string& line, std::vector<Check>& checks) {
  Check check;
  check.line = lines_;
  check.typed = line;
  const std::string text = trimmed(line);
  if (text.empty() || text[0] == '#') return true;
  World world;
  if (world_of(text, world)) {
    if (!rows_.empty())
      throw Complaint({0, static_cast<int>(line.size())},
                      "Where the bodies are is said before the first formula.");
    words_ = std::make_unique<Vocabulary>(world);
    check.sentence = std::string(world.turning ? "Two bodies " : "Two particles ") +
                     (world.dimension == 2 ? "in the plane." : "in space.");
    checks.push_back(check);
    return true;
  }
  if (line.find('=') == std::string::npos && line.find(':') != std::string::npos) {
    const std::size_t before = words_->all().size();
    words_->declare(line);
    for (std::size_t i = before; i < words_->all().size(); ++i) {
      const Symbol& s = words_->all()[i];
      check.sentence += (check.sentence.empty() ? "" : " ") + s.name + " is " +
                        (s.unit_length      ? "a unit vector"
                         : s.shape.vector() ? "a vector"
                                            : "a number") +
                        (s.unit_length  ? ""
                         : s.unit.known ? " [" + text_of(s.unit) + "]"
                                        : "") +
                        (s.is == Symbol::Is::turning ? " fixed to body " + std::to_string(s.body + 1)
                         : s.shape.vector()          ? " of the world"
                                                     : "") +
                        ".";
    }
    checks.push_back(check);
    return true;
  }
  return false;
}

std::vector<Check> Sheet::add(const std::string& typed) {
  ++lines_;
  std::vector<Check> checks;
  try {
    if (told(typed, checks)) return checks;
    const Line line = parse(typed, *words_);
    if (!line.head.empty()) head_ = line.head;
    if (head_.empty())
      throw Complaint({0, 1}, "A line that begins with = goes on with the one before, and there is none.");
    if (line.sides.empty()) throw Complaint(line.head_where, "Behind = nothing follows.");
    for (std::size_t i = 0; i < line.sides.size(); ++i) {
      Check one = check(line, i, i == 0 && !line.head.empty());
      one.line = lines_;
      one.typed = typed;
      if (one.outcome == Outcome::wrong) status_ = std::max(status_, 1);
      checks.push_back(std::move(one));
    }
  } catch (const Complaint& complaint) {
    Check check;
    const bool misfit = dynamic_cast<const Misfit*>(&complaint) != nullptr;
    check.outcome = misfit ? Outcome::wrong : Outcome::unreadable;
    check.line = lines_;
    check.typed = typed;
    check.where = complaint.where;
    check.sentence = complaint.what();
    if (misfit) {
      check.finding.name = "kinds and units";
      check.finding.sentence = complaint.what();
      check.finding.hints = {"Which kind and which unit has each term?",
                             "Only like is added to like: numbers to numbers, vectors to vectors, m/s to m/s.",
                             complaint.what()};
    }
    status_ = std::max(status_, misfit ? 1 : 2);
    checks.push_back(std::move(check));
  }
  return checks;
}

Check Sheet::check(const Line& line, std::size_t index, bool first) {
  const Side& side = line.sides[index];
  Check check;
  check.where = side.where;
  check.head = head_;
  const bool rate = head_.starts_with("dC") && head_.find_first_not_of("0123456789", 2) == std::string::npos;
  const bool C = head_[0] == 'C' && head_.find_first_not_of("0123456789", 1) == std::string::npos;
  const bool J = head_[0] == 'J' && head_.find_first_not_of("0123456789", 1) == std::string::npos;
  if (side.row && !J) throw Complaint(side.where, "[ ] holds the parts of J.");
  if (!C && !rate && !J) {
    if (index > 0) throw Complaint(side.where, "A name is defined by one formula.");
    if (!first) throw Complaint(side.where, "A definition has one line.");
    words_->define(head_, side.parts[0], line.head_where);
    check.characters = characters(side.parts[0]);
    check.latex = latex(side.parts[0]);
    check.sentence = head_ + " is " +
                     (side.parts[0]->shape.scalar()   ? ""
                      : side.parts[0]->shape.vector() ? "a vector, "
                                                      : "a matrix, ") +
                     described(side.parts[0]->unit) + ".";
    head_.clear();
    return check;
  }
  for (const Expression& part : side.parts) {
    check.characters += (check.characters.empty() ? "" : ", ") + characters(part);
    check.latex += (check.latex.empty() ? "" : " & ") + latex(part);
  }
  if (J) {
    check.characters = "[" + check.characters + "]";
    check.latex = "\\begin{bmatrix} " + check.latex + " \\end{bmatrix}";
  }
  Row& row = rows_[head_.substr(rate ? 2 : 1)];
  if (C) {
    check_constraint(row, side.parts[0], first, check);
    row.inequality = row.inequality || line.inequality;
    if (line.inequality) check.sentence += " An inequality: its λ is kept ≥ 0, and J is the same.";
  } else {
    if (line.inequality) throw Complaint(side.where, "Only C is written with ≥ 0.");
    if (rate)
      check_rate(row, side.parts[0], first, check);
    else
      check_parts(row, side, first, check);
  }
  return check;
}

void Sheet::judged(Check& check, const Verdict& verdict, const char* against) const {
  if (verdict.states == 0) {
    check.outcome = Outcome::wrong;
    check.sentence = "At none of the states tried is this a finite number, so it cannot be judged.";
    check.finding.sentence = check.sentence;
    return;
  }
  check.outcome = Outcome::right;
  check.sentence = std::string("Right: ") + against +
                   (verdict.exact ? ", exactly (modulo a prime of 19 digits, twice)."
                                  : ", to rounding at " + counted(verdict.states, "random state") + ".");
}

void Sheet::wrong(Check& check, const Expression& typed, const Expression& right, Finding finding) const {
  check.outcome = Outcome::wrong;
  check.sentence = finding.sentence;
  check.numbers = numbers_at_one_state(*words_, typed, right);
  check.finding = std::move(finding);
}

void Sheet::check_constraint(Row& row, const Expression& e, bool first, Check& check) {
  if (e->moving)
    throw Misfit(e->where, "C holds positions alone: a constraint on velocities has no C and begins with dC.");
  if (e->shape.cols > 1) throw Misfit(e->where, "C is a number or a vector of numbers, not a matrix.");
  derivative(e, *words_);  // complains of what has none
  const Judge judge(*words_);
  if (!first) {
    if (!row.C) throw Complaint(e->where, "This line goes on with C, and there is none yet.");
    const Verdict verdict = judge.compare(e, row.C);
    if (verdict.equal || verdict.states == 0)
      judged(check, verdict, "equal to the line before");
    else
      wrong(check, e, row.C, why_not_equal(judge, row.C, e));
  } else {
    row = Row{};
    const bool moves = !is_number(derivative(e, *words_), 0);
    check.sentence = std::string("C is ") + (e->shape.scalar() ? described(e->unit) + "."
                                                               : "a vector: " + counted(e->shape.rows, "row") +
                                                                     " [" + text_of(e->unit) + "].");
    if (!moves) {
      check.outcome = Outcome::wrong;
      check.sentence = check.finding.sentence =
          "This does not depend on where the bodies are, so it constrains nothing.";
    } else if (!goal_.empty()) {
      const Expression goal = parse_expression(goal_, *words_);
      const Samples mine = judge.samples(e), theirs = judge.samples(goal);
      const Verdict verdict = judge.compare(mine, theirs);
      const auto factor = e->shape == goal->shape ? judge.factor(mine, theirs) : std::nullopt;
      if (verdict.equal) {
        judged(check, verdict, "the C of the task");
      } else if (factor && *factor != 0) {
        check.outcome = Outcome::right;
        check.sentence = "This is " + shown(*factor) + " times the C of the task: the same constraint, with a J " +
                         shown(*factor) + " times as large.";
      } else if (e->shape == goal->shape) {
        wrong(check, e, goal, why_not_equal(judge, goal, e));
      } else {
        throw Misfit(e->where, "The C of the task has " + counted(goal->shape.rows, "row") + ", and yours has " +
                                   std::to_string(e->shape.rows) + ".");
      }
    }
  }
  row.C = e;
  row.rate = row.right_rate = nullptr;
  row.J.clear();
}

void Sheet::check_rate(Row& row, const Expression& e, bool first, Check& check) {
  if (e->shape.cols > 1) throw Misfit(e->where, "dC is a number or a vector of numbers, not a matrix.");
  const Judge judge(*words_);
  const Expression by_rule = row.C ? derivative(row.C, *words_) : nullptr;
  if (row.C && !(row.C->shape == e->shape))
    throw Misfit(e->where, "dC has as many rows as C: " + std::to_string(row.C->shape.rows) + ", not " +
                               std::to_string(e->shape.rows) + ".");
  if (row.C && first) {
    row.rate = nullptr;
    row.astray = false;
  }
  if (!row.C && first) {
    if (!e->moving) throw Misfit(e->where, "There is no velocity in this rate.");
    if (!linear(*words_, e)) {
      check.outcome = Outcome::wrong;
      check.sentence = check.finding.sentence = "This is not linear in v and ω, so that it has no J.";
    } else {
      check.sentence =
          "A constraint on rates alone, " + described(e->unit) + ": it has no C, so there is no drift to correct.";
    }
    row = Row{};
    row.rate = row.right_rate = e;
    return;
  }
  const Expression before = row.rate ? row.rate : by_rule;
  if (!before) throw Complaint(e->where, "This line goes on with dC, and there is none yet.");
  const Samples mine = judge.samples(e);
  const Verdict verdict = judge.compare(mine, row.rate ? judge.samples(row.rate) : judge.rates(row.C));
  const char* against = row.rate ? "equal to the line before" : "dC/dt along the motion of both bodies";
  if (verdict.equal || verdict.states == 0) {
    judged(check, verdict, against);
  } else if (row.right_rate && judge.matches(e, judge.samples(row.right_rate))) {
    check.outcome = Outcome::right;
    check.sentence = "Right again: equal to the last right line, though not to the one before.";
    row.astray = false;
  } else if (row.rate) {
    wrong(check, e, row.rate, why_not_equal(judge, row.rate, e, row.C));
  } else {
    Finding finding = why_not_the_rate(judge, row.C, e);
    const Unit wanted = row.C->unit * per_second;
    if (finding.name.empty() && !e->unit.fits(wanted))
      finding.sentence = "dC is " + described(e->unit) + ", but C is " + described(row.C->unit) +
                         " and its rate has the unit " + text_of(wanted) + ". " + finding.sentence;
    wrong(check, e, by_rule, std::move(finding));
  }
  row.astray = row.astray || check.outcome == Outcome::wrong;
  row.rate = e;
  if (!row.astray)
    row.right_rate = e;
  else if (!row.right_rate)
    row.right_rate = by_rule;
}

void Sheet::check_parts(Row& row, const Side& side, bool first, Check& check) {
  if (!row.C && !row.rate)
    throw Complaint(side.where, "There is neither C nor dC yet from which this J could be read off.");
  const Judge judge(*words_);
  if (first) last_J_rate_ = nullptr;
  // J of a wrong dC is read off that line; J of C is judged by dual numbers.
  const Expression before = last_J_rate_ ? last_J_rate_ : row.rate ? row.rate : derivative(row.C, *words_);
  Expression typed;
  try {
    typed = rate_by(*words_, side.parts, before->shape, side.where);
  } catch (const Misfit&) {
    if (!in_another_order(judge, side.parts, before)) throw;
    const Error& order = error("parts in another order");
    check.outcome = Outcome::wrong;
    check.sentence = order.sentence;
    check.finding = {
        order.name, order.sentence,
        nullptr,    nullptr,
        nullptr,    {order.question, order.rule, "J = [l1, a1, l2, a2]: exchange the two in the middle."}};
    return;
  }
  const bool from_C = !last_J_rate_ && !row.rate;
  const Verdict verdict = judge.compare(judge.samples(typed), from_C ? judge.rates(row.C) : judge.samples(before));
  if (verdict.equal || verdict.states == 0) {
    judged(check, verdict,
           from_C         ? "JV is dC/dt"
           : last_J_rate_ ? "equal to the line before"
                          : "JV is the line before");
    // Only of a right rate is it the constraint's J.
    if (check.outcome == Outcome::right &&
        (!row.C || judge.compare(judge.samples(typed), judge.rates(row.C)).equal))
      row.J = side.parts;
  } else if (row.C && judge.compare(judge.samples(typed), judge.rates(row.C)).equal) {
    check.outcome = Outcome::right;
    check.sentence = "Right: the J of your C, though not of the line before, which is wrong.";
    row.J = side.parts;
  } else {
    // Where the line before is wrong too, J is named against the right one.
    const Expression& right = !last_J_rate_ && row.rate && row.right_rate ? row.right_rate : before;
    wrong(check, typed, right, why_not_the_parts(judge, right, side.parts, row.C));
  }
  last_J_rate_ = typed;
}

}  // namespace byhand::desk
