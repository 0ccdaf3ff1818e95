#include "lessons/desk/vocabulary.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "lessons/desk/lexer.hpp"
#include "lessons/desk/print.hpp"

namespace byhand::desk {
namespace {

using Is = Symbol::Is;

int distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int before = row[0];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = before + (a[i - 1] == b[j - 1] ? 0 : 1);
      before = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

/// "omega1" of "ω1".
std::string canonical_letters(const std::string& name) {
  std::string text;
  for (const char c : latex_name(name))
    if (std::isalnum(static_cast<unsigned char>(c))) text += c;
  return text;
}

std::string trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
  return begin == std::string_view::npos ? "" : std::string(text.substr(begin, end - begin + 1));
}

/// "m²/s" as a unit.
Unit unit_from(const std::string& text, Span where) {
  Unit unit;
  double sign = 1;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == ' ' || c == '*' || c == '1') {
      ++i;
    } else if (c == '/') {
      sign = -1;
      ++i;
    } else if (text.compare(i, 3, "rad") == 0) {
      i += 3;
    } else if (c == 'm' || c == 's') {
      ++i;
      double power = 1;
      if (text.compare(i, 2, "²") == 0)
        power = 2, i += 2;
      else if (text.compare(i, 2, "³") == 0)
        power = 3, i += 2;
      else if (i + 1 < text.size() && text[i] == '^' && text[i + 1] >= '0' && text[i + 1] <= '9')
        power = text[i + 1] - '0', i += 2;
      (c == 'm' ? unit.m : unit.s) += sign * power;
    } else {
      throw Complaint(where, "\"" + text + "\" is not a unit: use m, s and rad, as in [m/s].");
    }
  }
  return unit;
}

}  // namespace

Vocabulary::Vocabulary(World world) : world_(world) {
  const Shape vector{world.dimension, 1}, matrix{world.dimension, world.dimension};
  for (int body = 0; body < 2; ++body) {
    const std::string of = std::to_string(body + 1);
    add({.name = "x" + of, .is = Is::centre, .body = body, .shape = vector, .unit = metre});
    add({.name = "v" + of, .is = Is::velocity, .body = body, .shape = vector, .unit = metre_per_second});
    if (world.turning) {
      add({.name = "ω" + of,
           .is = Is::spin,
           .body = body,
           .shape = world.dimension == 2 ? Shape{} : vector,
           .unit = per_second});
      if (world.dimension == 2) add({.name = "θ" + of, .is = Is::angle, .body = body, .unit = unitless});
      add({.name = "R" + of, .is = Is::orientation, .body = body, .shape = matrix, .unit = unitless});
      add({.name = "r" + of, .is = Is::turning, .body = body, .shape = vector, .unit = metre, .arm = true});
    }
    const Expression x = symbol(at("x" + of));
    add({.name = "p" + of,
         .is = Is::defined,
         .shape = vector,
         .unit = metre,
         .definition = world.turning ? plus(x, symbol(at("r" + of))) : x});
  }
  add({.name = "d",
       .is = Is::defined,
       .shape = vector,
       .unit = metre,
       .definition = minus(symbol(at("p2")), symbol(at("p1")))});
  add({.name = "L", .unit = metre});
  add({.name = "n", .shape = vector, .unit = unitless, .unit_length = true, .axis = 0});
  add({.name = "t", .shape = vector, .unit = unitless, .unit_length = true, .axis = 1});
  if (world.dimension == 3) add({.name = "t2", .shape = vector, .unit = unitless, .unit_length = true, .axis = 2});
  if (world.turning)
    add({.name = "u", .is = Is::turning, .body = 0, .shape = vector, .unit = unitless, .unit_length = true});
  add({.name = "k", .unit = unitless});
  static const char* const axes[] = {"ex", "ey", "ez"};
  for (int i = 0; i < world.dimension; ++i)
    add({.name = axes[i], .shape = vector, .unit = unitless, .unit_length = true, .axis = 3 + i});
}

Symbol& Vocabulary::add(Symbol symbol) {
  symbol.id = static_cast<int>(all_.size());
  all_.push_back(std::move(symbol));
  return all_.back();
}

const Symbol* Vocabulary::find(std::string_view name) const {
  // The last of a name is the one that was defined last.
  for (auto it = all_.rbegin(); it != all_.rend(); ++it)
    if (it->name == name) return &*it;
  return nullptr;
}

const Symbol& Vocabulary::at(std::string_view name) const { return *find(name); }

void Vocabulary::declare(std::string_view line) {
  const auto colon = line.find(':');
  const Span what{static_cast<int>(colon) + 1, static_cast<int>(line.size())};
  std::string words = trimmed(line.substr(colon + 1));
  Symbol symbol;
  symbol.unit = any_unit;
  bool vector = false, point = false;
  if (const auto open = words.find('['); open != std::string::npos) {
    const auto close = words.find(']', open);
    if (close == std::string::npos) throw Complaint(what, "The unit is not closed by ].");
    symbol.unit = unit_from(words.substr(open + 1, close - open - 1), what);
    words.erase(open, close - open + 1);
  }
  std::istringstream stream(words);
  bool body_next = false, understood = symbol.unit.known;
  for (std::string word; stream >> word;) {
    while (!word.empty() && (word.back() == ',' || word.back() == '.')) word.pop_back();
    if (word.size() > 1 && word.back() == 's' && word != "axis") word.pop_back();
    if (body_next && (word == "1" || word == "2")) {
      symbol.body = word[0] - '1';
      symbol.is = Is::turning;
      body_next = false;
    } else if (word == "body") {
      body_next = true;
    } else if (word == "number" || word == "ratio" || word == "angle") {
      symbol.unit = unitless, understood = true;
    } else if (word == "length" || word == "radiu" || word == "radius") {
      symbol.unit = metre, understood = true;
    } else if (word == "rate") {
      symbol.unit = per_second, understood = true;
    } else if (word == "speed") {
      symbol.unit = metre_per_second, understood = true;
    } else if (word == "constant") {
      understood = true;
    } else if (word == "vector" || word == "arm") {
      vector = understood = true;
      if (word == "arm") symbol.unit = metre;
    } else if (word == "unit" || word == "direction" || word == "axe" || word == "axis" || word == "normal") {
      vector = symbol.unit_length = understood = true;
      symbol.unit = unitless;
    } else if (word == "point") {
      vector = point = understood = true;
      symbol.unit = metre;
    } else if (word != "a" && word != "an" && word != "the" && word != "on" && word != "of" && word != "in" &&
               word != "world" && word != "fixed" && word != "to" && word != "and") {
      throw Complaint(what, "\"" + word +
                                "\" is not understood here: say number, length, angle, vector, unit vector or "
                                "point, a unit in [ ], and on body 1, on body 2 or in the world.");
    }
  }
  if (!understood)
    throw Complaint(
        what,
        "This does not say what it is: number, length, angle, vector, unit vector, point, or a unit in [ ].");
  if (body_next) throw Complaint(what, "Which body? Say body 1 or body 2.");
  if (point && symbol.body >= 0)
    throw Complaint(what, "A point of a body is its centre and an arm: declare the arm, a vector on the body.");
  if (symbol.body >= 0 && !vector)
    throw Complaint(what, "A number belongs to no body: only vectors turn with one.");
  if (symbol.body >= 0 && !world_.turning)
    throw Complaint(what, "Particles do not turn, so nothing is fixed to one.");
  if (vector) symbol.shape = {world_.dimension, 1};
  if (vector && !symbol.unit_length && !symbol.unit.known) symbol.unit = metre;
  if (all_.size() > 200) throw Complaint(what, "There are more than 200 names.");

  std::string_view names = line.substr(0, colon);
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t end = std::min(names.find(',', begin), names.size());
    const Span where{static_cast<int>(begin), static_cast<int>(end)};
    const auto read = tokens(names.substr(begin, end - begin));
    if (read.size() != 2 || read[0].is != Token::Is::name)
      throw Complaint(where, "A name is a letter, with digits behind it.");
    const std::string& name = read[0].text;
    static const std::set<std::string> taken = {"C",    "J",   "dC",   "E",    "sin",  "cos", "atan2",
                                                "sqrt", "abs", "norm", "perp", "skew", "T"};
    const Symbol* known = find(name);
    const bool own = !known || known->is == Is::fixed || (known->is == Is::turning && !known->arm) ||
                     (known->is == Is::turning && symbol.is == Is::turning) || known->is == Is::defined;
    if (taken.count(name) || !own ||
        (name.size() > 1 && (name.starts_with("dC") || (name[0] == 'C' && name[1] >= '0' && name[1] <= '9'))))
      throw Complaint(where, name + " has a meaning already: choose another name.");
    Symbol one_more = symbol;
    one_more.name = name;
    one_more.arm = known && known->arm && known->body == symbol.body;
    add(std::move(one_more));
    begin = end + 1;
  }
}

void Vocabulary::define(const std::string& name, const Expression& definition, Span where) {
  const Symbol* known = find(name);
  const bool own = !known || known->is == Is::defined || (known->is == Is::fixed && known->axis < 3) ||
                   (known->is == Is::turning && !known->arm);
  if (!own)
    throw Complaint(where,
                    name + " is a quantity of the bodies and is not defined by a formula: choose another name.");
  if (all_.size() > 200) throw Complaint(where, "There are more than 200 names.");
  add({.name = name,
       .is = Is::defined,
       .shape = definition->shape,
       .unit = definition->unit,
       .definition = definition});
}

std::string Vocabulary::unknown(std::string_view name) const {
  const Symbol* best = nullptr;
  int least = 2;
  for (const Symbol& symbol : all_)
    for (const std::string& spelled : {symbol.name, canonical_letters(symbol.name)})
      if (const int far = distance(name, spelled); far < least && spelled.size() > 1) {
        least = far;
        best = &symbol;
      }
  if (!world_.turning &&
      (name.starts_with("r") || name.starts_with("ω") || name.starts_with("R") || name.starts_with("θ")))
    return std::string(name) +
           " is not known: particles do not turn. For bodies begin with \"in the plane\" or \"in space\".";
  if (world_.dimension == 3 && name.starts_with("θ"))
    return std::string(name) +
           " is not known: in space no single angle says how a body is turned; use R or vectors on the body.";
  return std::string(name) + " is not known" + (best ? "; did you mean " + best->name + "?" : ".") +
         " A line such as \"" + std::string(name) + ": number\" or \"" + std::string(name) +
         ": unit vector on body 1\" says what it is.";
}

const Symbol* counterpart(const Vocabulary& words, const Symbol& symbol) {
  std::string name = symbol.name;
  if (name.back() == '1')
    name.back() = '2';
  else if (name.back() == '2')
    name.back() = '1';
  else
    return nullptr;
  const Symbol* other = words.find(name);
  return other && other->shape == symbol.shape && other != &symbol ? other : nullptr;
}

}  // namespace byhand::desk
