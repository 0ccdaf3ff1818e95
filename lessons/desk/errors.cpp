#include "lessons/desk/errors.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "lessons/desk/print.hpp"

namespace byhand::desk {

const std::vector<Error>& errors() {
  static const std::vector<Error> all = {
      // Derivatives.
      {"half a product rule", "Only one factor of {of} was differentiated: the product rule has two terms.",
       "How many factors of {of} change with time?", "(ab)' = a'b + ab', for · and × too."},
      {"product of the rates", "The rate of a product is not the product of the rates: {of} gives two terms.",
       "What is the derivative of t·t?", "(ab)' = a'b + ab'."},
      {"2 of a square", "The 2 of the square is missing: {of} has the rate {right}.", "What is d/dt of a square?",
       "(a·a)' = 2 a·a', and (aⁿ)' = n aⁿ⁻¹ a'."},
      {"ω × r forgotten", "The anchor of {body} turns with it: its rate is v + ω × r, and you left ω × r out.",
       "Turn {body} about its centre: does its anchor stay where it is?",
       "An arm fixed to a body has the rate ṙ = ω × r."},
      {"r × ω", "The velocity of a turning arm is ω × r; you wrote r × ω, which points the other way.",
       "Turn a body anticlockwise: which way does a point to the right of its centre go?",
       "ṙ = ω × r, and a × b = −b × a."},
      {"arm of the other body", "{body} turns its own arm, and you took the other's.",
       "Which arm ends at the anchor of {body}?", "p_i = x_i + r_i: each body moves its own arm."},
      {"spin of the other body", "The arm of {body} turns with {body}, and you took the other's ω.",
       "Turn the other body alone: does this arm move?", "ṙ_i = ω_i × r_i."},
      {"ω × the whole position",
       "ω turns the arm from the body's own centre, not the position from the origin of the world.",
       "Turn a body that is far from the origin about its centre: how fast does its anchor move?",
       "ẋ = v and ṙ = ω × r, so ṗ = v + ω × r."},
      {"v forgotten", "The centre of {body} moves with v, and you left that out.",
       "Push {body} without turning it: what changes?", "ẋ = v."},
      {"sign of a body", "All terms of {body} have the wrong sign.",
       "Move both bodies together with one velocity: what should the rate be?", "d = p2 − p1 changes by ṗ2 − ṗ1."},
      {"sign of a turn", "The term of {body} with ω has the wrong sign: the minus belongs to v and to ω × r.",
       "Which terms does the minus before the bracket reach?", "−(v + ω × r) = −v − ω × r."},
      {"frame held", "{of} is fixed to {body} and turns with it; you took it for a constant.",
       "Turn {body}: does {of} keep its direction?", "A vector fixed to a body has the rate ω × u."},
      {"frame the wrong way", "{of} turns with {body}: its rate is ω × u, and you wrote u × ω.",
       "Which way does an axis of the body turn when ω is positive?", "u̇ = ω × u."},
      {"frame of the other body", "{of} is fixed to {body}; you turned it with the other body's ω.",
       "On which body is {of} painted?", "u̇ = ω × u with the ω of the body that it belongs to."},
      {"world turned", "{of} is fixed to the world and does not turn with a body.", "Turn a body: does {of} turn?",
       "Vectors of the world are constants."},
      {"length of the rate", "The rate of a length is not the length of the rate: |d|' = d·d'/|d|.",
       "A point on a circle moves: does its distance from the centre change?",
       "|a|² = a·a, so 2|a||a|' = 2 a·a'."},
      {"length not divided", "The rate of {of} is that of half its square divided by the length: /|…| is missing.",
       "What is the unit of the rate of a length?",
       "|a|' = (a/|a|)·a': the gradient of a length is a unit vector."},
      {"length counted twice", "The rate of a length has no 2: the 2 of the square is halved by the root.",
       "Differentiate |a|² = a·a on both sides: what cancels?", "|a|' = a·a'/|a|."},
      {"divisor held", "The divisor changes too: (a/b)' = a'/b − a b'/b².",
       "What in {of} depends on the bodies, above and below?", "(a/b)' = (a'b − ab')/b²."},
      {"numerator held", "What is divided changes too: (a/b)' = a'/b − a b'/b².",
       "What in {of} depends on the bodies, above and below?", "(a/b)' = (a'b − ab')/b²."},
      {"sign of a quotient", "The second term of a quotient's rate has a minus.",
       "Let the divisor grow: does the quotient grow?", "(a/b)' = (a'b − ab')/b²."},
      {"half of a root", "√ has the rate 1/(2√): the 2 is missing.", "What is the derivative of √t?",
       "(√a)' = a'/(2√a)."},
      {"sign of a sine", "The rate of a sine is +cos.", "At angle 0, does the sine grow?",
       "(sin a)' = cos a · a'."},
      {"sign of a cosine", "The rate of a cosine is −sin.", "Between 0 and π/2, does the cosine grow?",
       "(cos a)' = −sin a · a'."},
      {"sine kept", "Sine and cosine take turns: sin' = cos, cos' = −sin.",
       "At angle 0 the sine is 0; is its slope 0?", "(sin a)' = cos a · a', (cos a)' = −sin a · a'."},
      {"sign of an angle's rate",
       "atan2(y, x) grows anticlockwise: its rate is (xẏ − yẋ)/(x² + y²), and you have the sign of the other "
       "turn.",
       "At (1, 0) moving up, does the angle grow?", "atan2(y, x)' = (x y' − y x')/(x² + y²)."},
      {"angle's rate not divided", "The rate of atan2 is divided by x² + y²: far away the same speed turns less.",
       "What is the unit of the rate of an angle?", "atan2(y, x)' = (x y' − y x')/(x² + y²)."},
      {"exponent lost", "A power n has the rate n aⁿ⁻¹ a'; the n is missing.", "What is d/dt of t³?",
       "(aⁿ)' = n aⁿ⁻¹ a'."},
      // From line to line.
      {"order of a triple product", "d·(ω × r) = ω·(r × d): you have d × r, which is its opposite.",
       "Go round in the order d, ω, r: what follows ω?",
       "a·(b × c) = b·(c × a) = c·(a × b): cyclic exchange keeps the value."},
      {"triple product exchanged", "d·(ω × r) = −r·(ω × d): exchanging two of the three changes the sign.",
       "How many exchanges lead from d, ω, r to r, ω, d?",
       "a·(b × c) keeps its value under cyclic exchange and changes sign when two are exchanged."},
      {"cross product commuted", "a × b = −b × a: {of} was turned round and kept its sign.",
       "Point your fingers along the first factor and curl to the second: where is your thumb when you begin with "
       "the other?",
       "a × b = −b × a."},
      {"sign of the whole", "The whole line has changed its sign.",
       "Push body 2 outward: should this grow or shrink?", "Both sides of = have one sign."},
      {"factor", "This is {factor} times what it should be.", "Which factor, ½ or 2, came or went?",
       "Differentiate the factor in front as a constant: it stays."},
      {"divided by a length", "This is divided by {of}: it belongs to another C.",
       "What is the unit of the line before, and of yours?", "Divide both sides of a whole derivation, or none."},
      {"multiplied by a length", "This is multiplied by {of}: it belongs to another C.",
       "What is the unit of the line before, and of yours?",
       "The rate of a length is that of half its square, divided by the length."},
      {"branch of an angle", "The two sides are one angle at some states and differ by a whole turn at others.",
       "At which angle does atan2 jump?", "atan2 lies in (−π, π]; a sum of angles does not."},
      {"sign of a term", "The term {right} has changed its sign.", "Which minus reaches {right}?",
       "−(a − b) = −a + b."},
      {"terms of a body lost", "The terms of {body} are missing.", "Move {body} alone: what should change?",
       "Every velocity in the line before has to be in this one."},
      {"turning lost", "The terms with ω are missing: this is right for particles.",
       "Turn a body without moving its centre: what should change?", "p = x + r: an anchor moves by v + ω × r."},
      {"sign of the turns", "All terms with ω have the wrong sign.", "What is the order of the triple product?",
       "d·(ω × r) = ω·(r × d)."},
      {"term lost", "The term {right} is missing.",
       "How many terms does each product have when the brackets are gone?", "(a + b)·c = a·c + b·c."},
      {"term twice", "The term {right} is there twice.",
       "How often does {right} come up when the brackets are gone?", "(a + b)·c = a·c + b·c."},
      {"half a term", "The term {right} was halved.", "Where is the 2 of {right}?",
       "A factor ½ before a bracket reaches every term."},
      {"square of a sum", "(a + b)² is a² + 2 a·b + b²: the mixed term is missing.", "What is (1 + 1)²?",
       "(a + b)·(a + b) = a·a + 2 a·b + b·b."},
      {"length of a sum", "|a + b| is not |a| + |b|: two sides of a triangle are longer than the third.",
       "How long is the third side of a triangle?", "|a + b|² = a·a + 2 a·b + b·b."},
      {"cross product regrouped", "a × (b × c) is not (a × b) × c.", "Take b = c: what is each side?",
       "a × (b × c) = b (a·c) − c (a·b)."},
      {"transposed product", "(AB)ᵀ = BᵀAᵀ: the order turns round.", "Which of the two acts first?",
       "(AB)ᵀ = BᵀAᵀ."},
      {"turned back", "R leads from the body to the world and Rᵀ back; you have one for the other.",
       "In which frame are the numbers of this vector given?", "u = R u_body, u_body = Rᵀ u."},
      {"not normalised", "You have {wrong} where the unit vector {right} belongs.",
       "What is the length of {wrong}?", "A direction is d/|d|, of length 1."},
      {"one body twice", "You have {wrong} where {right} belongs: one index was copied.",
       "Which body does this term belong to?", "Each body has its own x, r, v and ω."},
      {"another symbol", "You have {wrong} where {right} belongs.",
       "What does {wrong} point to, and what should this term use?", "A symbol means one thing throughout."},
      {"only where C = 0", "The two lines agree only where C = 0.", "Did you use C = 0 on the way?",
       "A derivation holds at every state: C = 0 may be used only after the derivative was taken."},
      {"spin times the arm",
       "In the plane ω × r is the arm turned by a quarter, ω (−r_y, r_x); ω r would point along the arm.",
       "Which way does the tip of a turning arm move?", "ω × r = ω perp(r)."},
      // J.
      {"bodies swapped", "J is read off with the bodies swapped: l1, a1 belong to v1, ω1.",
       "Which part stands before v1?", "JV = l1·v1 + a1·ω1 + l2·v2 + a2·ω2, in this order."},
      {"parts in another order", "These are the parts of J in another order: (6) has l1, a1, l2, a2.",
       "Which part stands before ω1?", "J = [l1, a1, l2, a2]."},
      {"sign of J", "All of J has the wrong sign.", "Push body 2 along l2: does C grow?", "JV is dC/dt."},
      {"J of another scale", "This J is {factor} times the one of your C.",
       "Compare ½(d² − L²) and d² − L²: what is the derivative of each?", "A factor in C is a factor in J."},
      {"J of the length", "This J belongs to a length and your C to half its square: together β acts as β·L.",
       "What is the unit of JV for your C?", "½ d·d has the gradient d, |d| has d/|d|."},
      {"J of the square",
       "This J belongs to half a square and your C to the length: the gradient of a length is a unit vector, "
       "d/|d|.",
       "What is the unit of JV for your C?", "½ d·d has the gradient d, |d| has d/|d|."},
      {"equal ends", "l1 has lost its minus: move both bodies together, and JV should not change.",
       "Which sign does v1 have in dC/dt?", "l1 is what stands before v1, with its sign."},
      {"sign of a part", "{of} has the wrong sign.", "Which sign stands before the velocity of {of}?",
       "Each part of J keeps the sign of its term."},
      {"signs of the turns", "a1 and a2 have the wrong sign: d·(ω × r) = ω·(r × d), and you have d × r.",
       "What follows ω when you go round d, ω, r?", "a·(b × c) = b·(c × a)."},
      {"signs of a rod", "Here l1 is not −l2: the parts of {body} have the sign of another constraint.",
       "Move {body} alone in the direction of its l: does C grow?", "Read each part off its own term."},
      {"no turning", "The parts a are 0: this J is right for particles, but an anchor moves by ω × r.",
       "Turn a body without moving its centre: does C change?", "a = r × l."},
      {"part forgotten", "{of} is 0, but the line before has a term with its velocity.",
       "Which velocity is missing in your JV?", "Every velocity of dC/dt has a part in J."},
      {"arm copied", "{of} has the arm of the other body.", "Which arm ends at this body's anchor?",
       "a1 has r1, a2 has r2."},
      {"lever from the anchor",
       "The lever of {of} reaches from the body's centre to where l acts, and yours ends at its anchor.",
       "Where does the force along l act, seen from the centre of this body?",
       "a = (p − x) × l at the point p at which l acts: an axis of body 1 acts on it at p2, (r1 + d) × u."},
      {"part in the body's frame", "{of} is given in the frame of the body; ω and J are those of the world.",
       "In which frame is ω?", "The world's vector is R times the body's."},
      {"ratio left out", "The parts of {body} lack the factor {wrong}.",
       "Pull {body} by 1 cm: by how much does C change?", "A factor in C is a factor in the parts of its body."},
  };
  return all;
}

const Error& error(std::string_view name) {
  for (const Error& error : errors())
    if (error.name == name) return error;
  throw std::logic_error("no error of the desk is called " + std::string(name));
}

namespace {

using Is = Symbol::Is;
using Filled = std::vector<std::pair<const char*, std::string>>;

std::string filled(std::string text, const Filled& with_words) {
  for (const auto& [hole, words] : with_words)
    for (std::size_t at; (at = text.find(hole)) != std::string::npos;)
      text.replace(at, std::string(hole).size(), words);
  // A sentence begins with a capital.
  if (!text.empty() && text[0] == 'b' && text.starts_with("body ")) text[0] = 'B';
  return text;
}

std::string body_name(int body) { return "body " + std::to_string(body + 1); }

Finding finding(const char* name, const Expression& of, const Expression& right, const Expression& wrong,
                int body = -1, const std::string& factor = "", const std::string& of_name = "",
                bool derived = false) {
  const Error& one = byhand::desk::error(name);
  const Filled words = {{"{of}", !of_name.empty() ? of_name
                                 : of             ? characters(of)
                                                  : ""},
                        {"{right}", right ? characters(right) : ""},
                        {"{wrong}", wrong ? characters(wrong) : ""},
                        {"{body}", body < 0 ? "the body" : body_name(body)},
                        {"{factor}", factor}};
  Finding result{name,  filled(one.sentence, words),
                 of,    right,
                 wrong, {filled(one.question, words), filled(one.rule, words), ""}};
  if (right)
    result.hints[2] = (!of_name.empty() ? of_name + " = "
                       : derived        ? "The rate of " + characters(of) + " is "
                                        : "Here belongs ") +
                      characters(right) + ".";
  return result;
}

/// A wrong derivation: the name of its error and how the rate goes wrong.
struct Rule {
  Slip slip;
  const char* name;
  bool by_body;
};
constexpr Rule rules[] = {
    {Slip::square_without_two, "2 of a square", false},
    {Slip::arm_held, "ω × r forgotten", true},
    {Slip::arm_reversed, "r × ω", true},
    {Slip::other_arm, "arm of the other body", true},
    {Slip::other_spin, "spin of the other body", true},
    {Slip::whole_position, "ω × the whole position", true},
    {Slip::velocity_held, "v forgotten", true},
    {Slip::frame_held, "frame held", true},
    {Slip::frame_reversed, "frame the wrong way", true},
    {Slip::frame_of_other_body, "frame of the other body", true},
    {Slip::turn_sign, "sign of a turn", true},
    {Slip::body_sign, "sign of a body", true},
    {Slip::world_turned, "world turned", true},
    {Slip::first_rate_only, "half a product rule", false},
    {Slip::second_rate_only, "half a product rule", false},
    {Slip::product_of_rates, "product of the rates", false},
    {Slip::length_of_rate, "length of the rate", false},
    {Slip::length_unnormalised, "length not divided", false},
    {Slip::length_twice, "length counted twice", false},
    {Slip::divisor_held, "divisor held", false},
    {Slip::numerator_held, "numerator held", false},
    {Slip::quotient_sign, "sign of a quotient", false},
    {Slip::root_without_half, "half of a root", false},
    {Slip::sine_sign, "sign of a sine", false},
    {Slip::cosine_sign, "sign of a cosine", false},
    {Slip::sine_kept, "sine kept", false},
    {Slip::arctangent_sign, "sign of an angle's rate", false},
    {Slip::arctangent_undivided, "angle's rate not divided", false},
    {Slip::exponent_lost, "exponent lost", false},
};
constexpr int most_occurrences = 60;

bool in_terms_of(const Expression& e, const std::function<bool(const Symbol&)>& test) {
  return contains(e, [&](const Node& node) { return node.symbol && test(*node.symbol); });
}

/// Whether some part of a line is a cross product whose factors are so.
bool crosses(const Expression& e, const std::function<bool(const Expression&, const Expression&)>& test) {
  return contains(e, [&](const Node& node) { return node.op == Op::cross && test(node.of[0], node.of[1]); });
}
bool is_spin(const Expression& e) {
  return in_terms_of(e, [](const Symbol& s) { return s.is == Is::spin; });
}
bool is_arm(const Expression& e) { return e->symbol && e->symbol->is == Is::turning; }

/// Tries spoiled versions of a right line against the typed one.
class Search {
 public:
  Search(const Judge& judge, const Expression& right, const Expression& typed, const Expression& C)
      : judge_(judge), right_(right), typed_(typed), C_(C), wanted_(judge.samples(typed)) {}

  std::optional<Finding> as_derivative() const {
    for (const Rule& rule : rules)
      for (int body = rule.by_body ? 0 : -1; body < (rule.by_body ? 2 : 0); ++body)
        if (auto found = of_rule(rule, body)) return found;
    // Of both bodies at once.
    for (const Rule& rule : rules)
      if (rule.by_body && rule.slip != Slip::body_sign && rule.slip != Slip::world_turned)
        if (auto found = of_rule(rule, -1)) return found;
    return std::nullopt;
  }

  std::optional<Finding> as_rewriting() const {
    if (auto found = whole()) return found;
    if (auto found = of_terms()) return found;
    if (auto found = of_a_length()) return found;
    if (auto found = of_a_part()) return found;
    return where_constraint_vanishes();
  }

  /// The terms that one side has and the other has not.
  Finding unnamed() const {
    std::vector<Expression> mine = addends(typed_), theirs = addends(right_);
    std::erase_if(mine, [&](const Expression& term) {
      const Samples of = judge_.samples(term);
      const auto other = std::find_if(theirs.begin(), theirs.end(),
                                      [&](const Expression& one) { return judge_.matches(one, of); });
      if (other == theirs.end()) return false;
      theirs.erase(other);
      return true;
    });
    const Expression much = sum(mine, typed_), little = sum(theirs, right_);
    std::string sentence = "The two sides differ";
    if (!mine.empty() && !theirs.empty())
      sentence += ": you have " + characters(much) + " where " + characters(little) + " belongs.";
    else if (!mine.empty())
      sentence += " by " + characters(much) + ", which does not belong here.";
    else
      sentence += " by " + characters(little) + ", which is missing.";
    return {"",
            sentence,
            right_,
            little,
            much,
            {"Put numbers in: which term makes the difference?",
             "Multiply the brackets out on both sides and compare term by term.",
             theirs.empty() ? "Leave " + characters(much) + " out." : "Here belongs " + characters(little) + "."}};
  }

 private:
  bool is(const Expression& spoiled) const { return judge_.matches(spoiled, wanted_); }

  /// Where a spoiled version cannot be made its kinds or units do not fit, and nobody typed it.
  template <class F>
  std::optional<Expression> made(F&& make_it) const {
    try {
      return make_it();
    } catch (const Complaint&) {
      return std::nullopt;
    }
  }

  std::optional<Finding> of_rule(const Rule& rule, int body) const {
    int occurrences = 1;
    for (int at = -1; at < std::min(occurrences, most_occurrences); ++at) {
      Differentiated spoiled;
      const auto rate = made([&] {
        spoiled = derivative(C_, judge_.words(), {rule.slip, body, at});
        return spoiled.rate;
      });
      // A rate that all slips together leave without meaning may be one of them alone.
      occurrences = rate ? spoiled.occurrences : std::max(occurrences, 8);
      if (!rate) continue;
      if (occurrences == 0) return std::nullopt;
      if (at >= 0 && occurrences == 1) break;
      if (!is(*rate)) continue;
      // A turn of the wrong sign is r × ω only where that was written.
      const bool reversed = rule.slip == Slip::arm_reversed || rule.slip == Slip::frame_reversed;
      if (reversed &&
          !crosses(typed_, [](const Expression& a, const Expression& b) { return is_spin(b) && !is_spin(a); }))
        continue;
      if (rule.slip == Slip::turn_sign || reversed) {
        Finding found = of_turns(rule.name, spoiled.right, body);
        if (reversed) found = finding(rule.name, spoiled.of, spoiled.right, spoiled.slipped, body, "", "", true);
        return found;
      }
      return finding(rule.name, spoiled.of, spoiled.right, spoiled.slipped, body, "", "", true);
    }
    return std::nullopt;
  }

  std::optional<Finding> whole() const {
    const Samples right = judge_.samples(right_);
    if (const auto factor = judge_.factor(wanted_, right); factor && *factor != 0) {
      if (std::fabs(*factor + 1) < 1e-12) return finding("sign of the whole", right_, right_, typed_);
      for (const auto& [value, text] : {std::pair{2.0, "2"},
                                        {0.5, "½"},
                                        {-2.0, "−2"},
                                        {-0.5, "−½"},
                                        {4.0, "4"},
                                        {0.25, "¼"},
                                        {3.0, "3"},
                                        {1.0 / 3, "⅓"},
                                        {1.5, "1½"}})
        if (std::fabs(*factor - value) < 1e-12 * std::fabs(value))
          return finding("factor", right_, right_, typed_, -1, text);
      char text[40];
      std::snprintf(text, sizeof text, "%.6g", *factor);
      if (std::fabs(*factor) > 1e-6 && std::fabs(*factor) < 1e6)
        return finding("factor", right_, right_, typed_, -1, text);
    }
    if (judge_.differ_by_turns(wanted_, right)) return finding("branch of an angle", right_, right_, typed_);
    return std::nullopt;
  }

  /// Terms of the right line that have another sign, are missing, or come twice.
  std::optional<Finding> of_terms() const {
    const std::vector<Expression> terms = addends(right_);
    if (terms.size() < 2 || terms.size() > 60) return std::nullopt;
    const auto of_body = [&](const Expression& term, int body, bool turning, bool linear) {
      return in_terms_of(term, [&](const Symbol& s) {
        return (turning && s.is == Is::spin && (body < 0 || s.body == body)) ||
               (linear && s.is == Is::velocity && (body < 0 || s.body == body));
      });
    };
    struct Group {
      std::function<bool(const Expression&)> has;
      const char *flipped, *lost;
      int body;
    };
    std::vector<Group> groups;
    for (const Expression& term : terms)
      groups.push_back({[term](const Expression& one) { return one == term; }, "sign of a term", "term lost", -1});
    groups.push_back({[&](const Expression& e) { return of_body(e, -1, true, false); }, "sign of the turns",
                      "turning lost", -1});
    for (int body = 0; body < 2; ++body) {
      groups.push_back({[=](const Expression& e) { return of_body(e, body, true, true); }, "sign of a body",
                        "terms of a body lost", body});
      groups.push_back({[=](const Expression& e) { return of_body(e, body, true, false); }, "sign of a turn",
                        "ω × r forgotten", body});
      groups.push_back({[=](const Expression& e) { return of_body(e, body, false, true); }, "sign of a term",
                        "v forgotten", body});
    }
    for (const Group& group : groups) {
      std::vector<Expression> chosen;
      std::copy_if(terms.begin(), terms.end(), std::back_inserter(chosen), group.has);
      if (chosen.empty() || (chosen.size() == terms.size())) continue;
      const Expression part = sum(chosen, right_);
      if (is(minus(right_, part))) return finding(group.lost, nullptr, part, nullptr, group.body);
      if (is(minus(minus(right_, part), part))) {
        const bool turns = std::all_of(chosen.begin(), chosen.end(), is_spin);
        return turns ? of_turns(group.flipped, part, group.body)
                     : finding(group.flipped, nullptr, part, negative(part), group.body);
      }
      if (chosen.size() == 1 && is(plus(right_, part))) return finding("term twice", nullptr, part, nullptr);
      if (chosen.size() == 1 && is(minus(right_, divided(part, number(2)))))
        return finding("half a term", nullptr, part, nullptr);
    }
    return std::nullopt;
  }

  /// Terms with ω of the wrong sign: the form of the typed line says how that came.
  Finding of_turns(const char* otherwise, const Expression& part, int body) const {
    const auto typed = [&](auto&& test) { return crosses(typed_, test) && !crosses(right_, test); };
    if (typed([](const Expression& a, const Expression& b) { return is_spin(b) && !is_spin(a); })) {
      Expression of;
      visit(right_, [&](const Expression& e) {
        if (!of && e->op == Op::cross && is_spin(e->of[0])) of = e;
      });
      return finding("cross product commuted", of ? of : part, part, negative(part), body);
    }
    if (typed([](const Expression& a, const Expression& b) { return is_arm(b) && !is_arm(a) && !is_spin(a); }))
      return finding("order of a triple product", part, part, negative(part), body);
    if (typed([](const Expression& a, const Expression& b) { return is_spin(a) && !is_arm(b); }))
      return finding("triple product exchanged", part, part, negative(part), body);
    return finding(otherwise, nullptr, part, negative(part), body);
  }

  std::optional<Finding> of_a_length() const {
    std::vector<Expression> lengths;
    const auto collect = [&](const Expression& e) {
      visit(e, [&](const Expression& part) {
        if (lengths.size() > 12) return;
        if (part->op == Op::length) lengths.push_back(part);
        if (part->shape.vector() && part->unit.m == 1 && part->unit.s == 0 && part->op != Op::rate)
          lengths.push_back(make(Op::length, {part}));
        if (part->op == Op::symbol && part->shape.scalar() && part->symbol->is == Is::fixed)
          lengths.push_back(part);
      });
    };
    collect(right_);
    collect(typed_);
    for (const Expression& length : lengths) {
      if (length->moving) continue;
      if (is(divided(right_, length))) return finding("divided by a length", length, right_, typed_);
      if (is(times(length, right_))) return finding("multiplied by a length", length, right_, typed_);
      if (const auto factor = judge_.factor(wanted_, judge_.samples(divided(right_, length)));
          factor && std::fabs(*factor) <= 4)
        return finding("divided by a length", length, right_, typed_);
      if (const auto factor = judge_.factor(wanted_, judge_.samples(times(length, right_)));
          factor && std::fabs(*factor) <= 4)
        return finding("multiplied by a length", length, right_, typed_);
    }
    return std::nullopt;
  }

  /// The right line with one part, or all parts like it, changed by `change`, which returns nothing where it does
  /// not apply.
  template <class Change>
  std::optional<Finding> changed(const char* name, Change&& change) const {
    int found = 0;
    std::optional<Finding> result;
    for (int at = -1; at < std::min(found, most_occurrences); ++at) {
      int seen = 0;
      Expression of, wrong;
      const std::function<Expression(const Expression&)> copy = [&](const Expression& e) -> Expression {
        const Expression other = change(e);
        if (other && (seen++ == at || at < 0)) {
          if (!of) of = e, wrong = other;
          return other;
        }
        if (e->op == Op::symbol && e->symbol->definition) {
          const Expression inside = copy(e->symbol->definition);
          return inside == e->symbol->definition ? e : inside;
        }
        if (e->of.empty()) return e;
        std::vector<Expression> parts;
        bool other_parts = false;
        for (const Expression& part : e->of) {
          parts.push_back(copy(part));
          other_parts = other_parts || parts.back() != part;
        }
        return other_parts ? with(e, std::move(parts)) : e;
      };
      const auto spoiled = made([&] { return copy(right_); });
      found = std::max(found, seen);
      if (spoiled && *spoiled != right_ && is(*spoiled)) return finding(name, of, of, wrong);
      if (found == 0) return std::nullopt;
    }
    return std::nullopt;
  }

  std::optional<Finding> of_a_part() const {
    using E = Expression;
    const Vocabulary& words = judge_.words();
    const auto make_or_none = [](Op op, std::vector<E> of) -> E {
      try {
        return make(op, std::move(of));
      } catch (const Complaint&) {
        return nullptr;
      }
    };
    const auto is_sum = [](const E& e) { return e->op == Op::add || e->op == Op::subtract; };
    const auto opened = [](E e) {
      while (e->symbol && e->symbol->definition) e = e->symbol->definition;
      return e;
    };
    if (auto f = changed("cross product commuted", [&](const E& e) {
          return e->op == Op::cross ? make_or_none(Op::cross, {e->of[1], e->of[0]}) : nullptr;
        }))
      return f;
    if (auto f = changed("spin times the arm", [&](const E& e) {
          return e->op == Op::cross && !e->shape.scalar() && words.world().dimension == 2
                     ? make_or_none(Op::multiply, e->of)
                     : nullptr;
        }))
      return f;
    for (const bool keeps_sign : {true, false})
      if (auto f = changed("square of a sum", [&](const E& e) -> E {
            E base;
            if (e->op == Op::dot && same(e->of[0], e->of[1])) base = e->of[0];
            if (e->op == Op::power && e->number == 2)
              base = e->of[0]->op == Op::length ? e->of[0]->of[0] : e->of[0];
            if (!base) return nullptr;
            base = opened(base);
            if (!is_sum(base)) return nullptr;
            return make_or_none(keeps_sign ? base->op : Op::add, {power(base->of[0], 2), power(base->of[1], 2)});
          }))
        return f;
    for (const Op op : {Op::add, Op::subtract})
      if (auto f = changed("length of a sum", [&](const E& e) -> E {
            if (e->op != Op::length) return nullptr;
            const E base = opened(e->of[0]);
            return is_sum(base)
                       ? make_or_none(op, {make(Op::length, {base->of[0]}), make(Op::length, {base->of[1]})})
                       : nullptr;
          }))
        return f;
    if (auto f = changed("cross product regrouped", [&](const E& e) -> E {
          if (e->op != Op::cross) return nullptr;
          if (e->of[1]->op == Op::cross) {
            const E inner_product = make_or_none(Op::cross, {e->of[0], e->of[1]->of[0]});
            return inner_product ? make_or_none(Op::cross, {inner_product, e->of[1]->of[1]}) : nullptr;
          }
          if (e->of[0]->op == Op::cross) {
            const E inner_product = make_or_none(Op::cross, {e->of[0]->of[1], e->of[1]});
            return inner_product ? make_or_none(Op::cross, {e->of[0]->of[0], inner_product}) : nullptr;
          }
          return nullptr;
        }))
      return f;
    if (auto f = changed("transposed product", [&](const E& e) -> E {
          if (e->op != Op::transpose || e->of[0]->op != Op::multiply) return nullptr;
          const auto& of = e->of[0]->of;
          return make_or_none(Op::multiply, {make(Op::transpose, {of[0]}), make(Op::transpose, {of[1]})});
        }))
      return f;
    if (auto f = changed("turned back", [&](const E& e) -> E {
          if (e->op == Op::transpose && e->of[0]->symbol && e->of[0]->symbol->is == Is::orientation)
            return e->of[0];
          return e->symbol && e->symbol->is == Is::orientation ? make(Op::transpose, {e}) : nullptr;
        }))
      return f;
    if (auto f = changed("not normalised", [&](const E& e) -> E {
          return e->op == Op::divide && e->of[1]->op == Op::length && same(e->of[1]->of[0], e->of[0]) ? e->of[0]
                                                                                                      : nullptr;
        }))
      return f;
    for (const Symbol& from : words.all())
      if (const Symbol* to = counterpart(words, from))
        if (auto f =
                changed("one body twice", [&](const E& e) { return e->symbol == &from ? symbol(*to) : nullptr; }))
          return f;
    for (const Symbol& from : words.all()) {
      if (!in_terms_of(right_, [&](const Symbol& s) { return &s == &from; })) continue;
      for (const Symbol& to : words.all())
        if (&to != &from && to.shape == from.shape && to.name != from.name &&
            in_terms_of(typed_, [&](const Symbol& s) { return &s == &to; }))
          if (auto f =
                  changed("another symbol", [&](const E& e) { return e->symbol == &from ? symbol(to) : nullptr; }))
            return f;
    }
    return std::nullopt;
  }

  /// Whether the lines agree at states that fulfil C = 0, reached by changing a constant or a place.
  std::optional<Finding> where_constraint_vanishes() const {
    if (!C_ || !C_->shape.scalar()) return std::nullopt;
    const Vocabulary& words = judge_.words();
    const Symbol* knob = nullptr;
    for (const Symbol& s : words.all())
      if (s.is == Is::fixed && s.shape.scalar() && in_terms_of(C_, [&](const Symbol& one) { return &one == &s; }))
        knob = &s;
    if (!knob) knob = &words.at("x2");
    Random random(7);
    int agreed = 0;
    for (int i = 0; i < 12; ++i) {
      State<double> state = random_state(words, random);
      double& x = state[static_cast<std::size_t>(knob->id)][0];
      const auto C = [&] { return evaluate(*C_, environment<Tracked>(words, state))[0].at; };
      double before = x, C_before = C();
      x += 0.1;
      for (int k = 0; k < 60; ++k) {
        const double now = C(), slope = (now - C_before) / (x - before);
        if (std::fabs(now) < 1e-13 || slope == 0 || !std::isfinite(slope)) break;
        before = x;
        C_before = now;
        x -= now / slope;
      }
      if (!(std::fabs(C()) < 1e-11)) continue;
      const auto values = environment<Tracked>(words, state);
      const auto a = evaluate(*right_, values), b = evaluate(*typed_, values);
      for (int k = 0; k < a.shape.size(); ++k)
        if (!(std::fabs(a[k].at - b[k].at) < 1e-6 * std::fabs(a[k].at))) return std::nullopt;
      ++agreed;
    }
    if (agreed < 4) return std::nullopt;
    return finding("only where C = 0", right_, right_, typed_);
  }

  const Judge& judge_;
  const Expression right_, typed_, C_;
  const Samples wanted_;
};

}  // namespace

Finding why_not_the_rate(const Judge& judge, const Expression& C, const Expression& typed) {
  const Search search(judge, derivative(C, judge.words()), typed, C);
  if (auto found = search.as_derivative()) return *found;
  if (auto found = search.as_rewriting()) return *found;
  return search.unnamed();
}

Finding why_not_equal(const Judge& judge, const Expression& before, const Expression& typed, const Expression& C) {
  const Search search(judge, before, typed, C);
  if (auto found = search.as_rewriting()) return *found;
  return search.unnamed();
}

std::vector<const Symbol*> velocities(const Vocabulary& words) {
  std::vector<const Symbol*> all;
  for (const char* name : {"v1", "ω1", "v2", "ω2"})
    if (const Symbol* symbol = words.find(name)) all.push_back(symbol);
  return all;
}

std::string part_name(const Vocabulary& words, std::size_t part) {
  const Symbol& w = *velocities(words)[part];
  return std::string(w.is == Is::spin ? "a" : "l") + std::to_string(w.body + 1);
}

Expression rate_by(const Vocabulary& words, const std::vector<Expression>& parts, Shape C, Span where) {
  const auto all = velocities(words);
  if (parts.size() != all.size())
    throw Misfit(where,
                 "J has " + std::to_string(parts.size()) + (parts.size() == 1 ? " part" : " parts") +
                     " here and needs " +
                     (all.size() == 4 ? "four: l1, a1, l2, a2." : "two: l1 and l2, as particles do not turn."));
  Expression total;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Expression w = symbol(*all[i]), &part = parts[i];
    const std::string name = part_name(words, i);
    if (part->moving)
      throw Misfit(part->where, name + " still holds a velocity: J is what stands before the velocities.");
    const Shape wanted{C.rows, w->shape.rows};
    Expression term;
    if (is_number(part, 0)) {
      term = zero(C);
    } else if (C.scalar() && part->shape == w->shape) {
      term = make(w->shape.scalar() ? Op::multiply : Op::dot, {part, w});
    } else if (part->shape == wanted) {
      term = make(Op::multiply, {part, w});
    } else {
      const auto shape = [](Shape s) {
        return s.scalar()   ? std::string("a number")
               : s.vector() ? "a vector"
                            : "a matrix of " + std::to_string(s.rows) + " by " + std::to_string(s.cols);
      };
      throw Misfit(part->where, name + " stands before " + all[i]->name + " and has to be " +
                                    shape(C.scalar() ? w->shape : wanted) + "; " + characters(part) + " is " +
                                    shape(part->shape) + ".");
    }
    try {
      total = total ? plus(total, term) : term;
    } catch (const Misfit& misfit) {
      throw Misfit(part->where, "The terms of JV have one unit, and " + name + " " + all[i]->name + " is " +
                                    described(term->unit) + ", the parts before it give " +
                                    described(total->unit) + ".");
    }
  }
  return total;
}

namespace {

/// The error of J that some of its parts show; right parts by rule.
std::optional<Finding> of_parts(const Judge& judge, const std::vector<Expression>& right,
                                const std::vector<Expression>& typed) {
  const Vocabulary& words = judge.words();
  const std::size_t n = right.size(), half = n / 2;
  std::vector<Samples> mine;
  for (const Expression& part : typed) mine.push_back(judge.samples(part));
  const auto is = [&](std::size_t i, const Expression& spoiled) {
    if (is_number(typed[i], 0) || is_number(spoiled, 0))
      return is_number(spoiled, 0) && (is_number(typed[i], 0) || judge.matches(zero(typed[i]->shape), mine[i]));
    return judge.matches(spoiled, mine[i]);
  };
  std::vector<bool> ok(n), flipped(n), gone(n);
  for (std::size_t i = 0; i < n; ++i) {
    ok[i] = is(i, right[i]);
    flipped[i] = !ok[i] && is(i, negative(right[i]));
    gone[i] = !ok[i] && is(i, zero(right[i]->shape));
  }
  const auto only = [&](const std::vector<bool>& which, auto&&... indices) {
    std::vector<bool> wanted(n);
    ((wanted[indices] = true), ...);
    for (std::size_t i = 0; i < n; ++i)
      if (wanted[i] ? !which[i] : !ok[i]) return false;
    return true;
  };
  const auto all = [&](auto&& test) {
    for (std::size_t i = 0; i < n; ++i)
      if (!test(i)) return false;
    return true;
  };
  const auto of = [&](const char* name, std::size_t i, int body = -1) {
    return finding(name, nullptr, right[i], typed[i], body < 0 ? static_cast<int>(i / half) : body, "",
                   part_name(words, i));
  };

  const bool antisymmetric = all([&](std::size_t i) { return !ok[i]; });
  if (antisymmetric && all([&](std::size_t i) { return is(i, negative(right[i])); }))
    return finding("sign of J", nullptr, nullptr, nullptr);
  if (all([&](std::size_t i) {
        return typed[i]->shape == right[(i + half) % n]->shape && is(i, right[(i + half) % n]);
      }))
    return of("bodies swapped", 0);
  if (n == 4 && words.world().dimension == 3 && is(0, right[0]) && is(1, right[2]) && is(2, right[1]) &&
      is(3, right[3]))
    return of("parts in another order", 1);
  for (const auto& [value, text] :
       {std::pair{2.0, "2"}, {0.5, "½"}, {-2.0, "−2"}, {-0.5, "−½"}, {3.0, "3"}, {4.0, "4"}}) {
    const Expression factor = number(value, static_cast<std::int64_t>(2 * value), 2);
    if (all([&](std::size_t i) { return is(i, times(factor, right[i])); }))
      return finding("J of another scale", nullptr, nullptr, nullptr, -1, text);
  }
  if (n == 4) {
    if (only(gone, 1u, 3u)) return of("no turning", 3);
    if (only(flipped, 1u, 3u)) return of("signs of the turns", 3);
    if (only(flipped, 0u, 1u)) return of("signs of a rod", 0);
    if (only(flipped, 2u, 3u)) return of("signs of a rod", 2);
  }
  if (only(flipped, std::size_t{0}) && judge.matches(right[half], mine[0])) return of("equal ends", 0);
  for (std::size_t i = 0; i < n; ++i) {
    if (only(flipped, i)) return of("sign of a part", i);
    if (only(gone, i)) return of("part forgotten", i);
  }
  // A factor that the parts of one body lack.
  for (const Symbol& s : words.all()) {
    if (s.is != Is::fixed || !s.shape.scalar()) continue;
    const Expression factor = symbol(s);
    for (std::size_t body = 0; body < 2; ++body) {
      const auto lacks = [&](std::size_t i) {
        return i / half == body ? is(i, divided(right[i], factor)) : ok[i];
      };
      if (all(lacks))
        return finding("ratio left out", nullptr, right[body * half], factor, static_cast<int>(body), "",
                       part_name(words, body * half));
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (n != 4 || i % 2 == 0 || ok[i]) continue;
    const int body = static_cast<int>(i / half);
    const Symbol &own = words.at("r" + std::to_string(body + 1)),
                 &other = words.at("r" + std::to_string(2 - body));
    const std::function<Expression(const Expression&)> copied = [&](const Expression& e) -> Expression {
      if (e->symbol == &own) return symbol(other);
      if (e->of.empty()) return e;
      std::vector<Expression> parts;
      for (const Expression& part : e->of) parts.push_back(copied(part));
      return with(e, std::move(parts));
    };
    const auto rest_right = [&](std::size_t k) { return k == i || ok[k]; };
    if (!all(rest_right)) continue;
    if (is(i, copied(right[i]))) return of("arm copied", i);
    if (typed[i - 1]->shape.vector()) {
      const Expression lever = crossed(symbol(own), typed[i - 1]);
      if (is(i, lever) || is(i, negative(lever))) return of("lever from the anchor", i);
    }
    if (!right[i]->shape.scalar() &&
        is(i, times(make(Op::transpose, {symbol(words.at("R" + std::to_string(body + 1)))}), right[i])))
      return of("part in the body's frame", i);
  }
  // Divided by a length, or multiplied: J of the length or of half its square.
  std::vector<Expression> lengths;
  for (const auto& side : {right, typed})
    for (const Expression& part : side)
      visit(part, [&](const Expression& e) {
        if (lengths.size() > 12) return;
        if (e->op == Op::length) lengths.push_back(e);
        if (e->shape.vector() && e->unit.m == 1 && e->unit.s == 0) lengths.push_back(make(Op::length, {e}));
      });
  for (const Expression& length : lengths) {
    if (all([&](std::size_t i) { return is(i, divided(right[i], length)); }))
      return finding("J of the length", length, nullptr, nullptr);
    if (all([&](std::size_t i) { return is(i, times(length, right[i])); }))
      return finding("J of the square", length, nullptr, nullptr);
  }
  // Each body with a length of its own, as a pulley.
  const auto each_body = [&](auto&& spoil) {
    for (std::size_t body = 0; body < 2; ++body) {
      bool found = false;
      for (const Expression& length : lengths) {
        bool fits = true;
        for (std::size_t i = body * half; i < (body + 1) * half; ++i)
          fits = fits && is(i, spoil(right[i], length));
        found = found || fits;
      }
      if (!found) return false;
    }
    return true;
  };
  if (each_body([](const Expression& e, const Expression& by) { return times(by, e); }))
    return finding("J of the square", nullptr, nullptr, nullptr);
  if (each_body([](const Expression& e, const Expression& by) { return divided(e, by); }))
    return finding("J of the length", nullptr, nullptr, nullptr);
  return std::nullopt;
}

}  // namespace

Finding why_not_the_parts(const Judge& judge, const Expression& rate, const std::vector<Expression>& parts,
                          const Expression& C) {
  const Vocabulary& words = judge.words();
  const Expression typed = rate_by(words, parts, rate->shape, {});
  if (rate->shape.scalar()) {
    std::vector<Expression> right;
    for (const Symbol* w : velocities(words)) right.push_back(coefficient(rate, *w));
    if (std::all_of(right.begin(), right.end(), [](const Expression& part) { return part != nullptr; })) {
      if (auto found = of_parts(judge, right, parts)) return *found;
      const Search search(judge, rate, typed, C);
      if (auto found = search.as_rewriting()) return *found;
      // Without a name: the parts that differ.
      for (std::size_t i = 0; i < parts.size(); ++i)
        if (!judge.matches(right[i], judge.samples(parts[i])) &&
            !(is_number(right[i], 0) && is_number(parts[i], 0))) {
          const std::string name = part_name(words, i);
          return {"",
                  name + " is " + characters(parts[i]) + ", but before " + velocities(words)[i]->name +
                      " stands " + characters(right[i]) + ".",
                  nullptr,
                  right[i],
                  parts[i],
                  {"What stands before " + velocities(words)[i]->name + " in the line before?",
                   "JV = l1·v1 + a1·ω1 + l2·v2 + a2·ω2.", name + " = " + characters(right[i]) + "."}};
        }
    }
  }
  const Search search(judge, rate, typed, C);
  if (auto found = search.as_rewriting()) return *found;
  return search.unnamed();
}

}  // namespace byhand::desk
