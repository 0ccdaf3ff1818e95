#include "lessons/desk/derivative.hpp"

#include <cmath>

namespace byhand::desk {
namespace {

using Is = Symbol::Is;

class Differentiator {
 public:
  Differentiator(const Vocabulary& words, Slipping how) : words_(words), how_(how) {}

  Expression of(const Expression& e) {
    const auto& part = e->of;
    switch (e->op) {
      case Op::number: return zero(e->shape);
      case Op::symbol: return of_symbol(e);
      case Op::negate: return negative(of(part[0]));
      case Op::add:
      case Op::subtract: {
        const Expression first = of(part[0]), second = of(part[1]);
        return e->op == Op::add ? plus(first, second) : minus(first, second);
      }
      case Op::multiply: return product(e, times);
      case Op::dot:
        if (same(part[0], part[1])) return square(e);
        return product(e, dotted);
      case Op::cross: return product(e, crossed);
      case Op::divide: return quotient(e);
      case Op::length: return length(e);
      case Op::power: return of_power(e);
      case Op::root: {
        const Expression rate = of(part[0]);
        return unless(Slip::root_without_half, e, divided(rate, times(number(2), e)),
                      [&] { return divided(rate, e); });
      }
      case Op::sine: {
        const Expression rate = of(part[0]), right = times(make(Op::cosine, {part[0]}), rate);
        return unless(Slip::sine_sign, e, unless(Slip::sine_kept, e, right, [&] { return times(e, rate); }),
                      [&] { return negative(right); });
      }
      case Op::cosine: {
        const Expression rate = of(part[0]), right = negative(times(make(Op::sine, {part[0]}), rate));
        return unless(Slip::cosine_sign, e,
                      unless(Slip::sine_kept, e, right, [&] { return negative(times(e, rate)); }),
                      [&] { return negative(right); });
      }
      case Op::arctangent: {
        const Expression &y = part[0], &x = part[1];
        const Expression dy = of(y), dx = of(x), top = minus(times(x, dy), times(y, dx));
        const Expression right = divided(top, make(Op::add, {power(x, 2), power(y, 2)}));
        return unless(Slip::arctangent_sign, e, unless(Slip::arctangent_undivided, e, right, [&] { return top; }),
                      [&] { return negative(right); });
      }
      case Op::transpose: return linear(Op::transpose, part[0]);
      case Op::perp: return linear(Op::perp, part[0]);
      case Op::skew: return linear(Op::skew, part[0]);
      case Op::rate: break;
    }
    throw Complaint(e->where, "Accelerations do not belong here: the derivative is taken of positions alone.");
  }

  Differentiated result;

 private:
  /// The right rate, or where the slip is made another.
  template <class Wrong>
  Expression unless(Slip slip, const Expression& e, const Expression& right, Wrong&& wrong, int body = -1) {
    if (how_.slip != slip || (how_.body >= 0 && body != how_.body) || is_number(right, 0)) return right;
    const int occurrence = result.occurrences++;
    if (how_.occurrence >= 0 && how_.occurrence != occurrence) return right;
    const Expression slipped = wrong();
    if (!result.of) {
      result.of = e;
      result.right = right;
      result.slipped = slipped;
    }
    return slipped;
  }

  Expression linear(Op op, const Expression& of_what) {
    const Expression rate = of(of_what);
    if (is_number(rate, 0))
      return zero(op == Op::transpose ? Shape{rate->shape.cols, rate->shape.rows}
                  : op == Op::skew    ? Shape{3, 3}
                                      : rate->shape);
    return make(op, {rate});
  }

  template <class Times>
  Expression product(const Expression& e, Times&& by) {
    const Expression &a = e->of[0], &b = e->of[1], da = of(a), db = of(b);
    const Expression first = by(da, b), second = by(a, db), right = plus(first, second);
    if (is_number(da, 0) || is_number(db, 0)) return right;
    if (how_.slip == Slip::first_rate_only) return unless(how_.slip, e, right, [&] { return first; });
    if (how_.slip == Slip::second_rate_only) return unless(how_.slip, e, right, [&] { return second; });
    return unless(Slip::product_of_rates, e, right, [&] { return by(da, db); });
  }

  /// (a·a)' = 2 a·a'.
  Expression square(const Expression& e) {
    const Expression &a = e->of[0], half = dotted(a, of(a));
    return unless(Slip::square_without_two, e, times(number(2), half), [&] { return half; });
  }

  Expression quotient(const Expression& e) {
    const Expression &a = e->of[0], &b = e->of[1], da = of(a), db = of(b);
    const Expression first = divided(da, b);
    if (is_number(db, 0)) return first;
    const Expression second = times(divided(db, power(b, 2)), a), right = minus(first, second);
    switch (how_.slip) {
      case Slip::divisor_held: return unless(how_.slip, e, right, [&] { return first; });
      case Slip::numerator_held:
        return is_number(da, 0) ? right : unless(how_.slip, e, right, [&] { return negative(second); });
      default: return unless(Slip::quotient_sign, e, right, [&] { return plus(first, second); });
    }
  }

  Expression length(const Expression& e) {
    const Expression &a = e->of[0], da = of(a);
    if (is_number(da, 0)) return zero({});
    const Expression top = a->shape.scalar() ? times(a, da) : dotted(a, da), right = divided(top, e);
    switch (how_.slip) {
      case Slip::length_of_rate: return unless(how_.slip, e, right, [&] { return make(Op::length, {da}); });
      case Slip::length_twice: return unless(how_.slip, e, right, [&] { return times(number(2), right); });
      default: return unless(Slip::length_unnormalised, e, right, [&] { return top; });
    }
  }

  Expression of_power(const Expression& e) {
    const Expression& a = e->of[0];
    const int n = static_cast<int>(e->number);
    if (n == 0) return zero({});
    // |a|² is a·a, which has a derivative at a = 0 too.
    if (a->op == Op::length && n == 2 && a->of[0]->shape.vector())
      return square(make(Op::dot, {a->of[0], a->of[0]}));
    const Expression da = of(a), without = times(n == 1 ? number(1) : n == 2 ? a : power(a, n - 1), da);
    return unless(n == 2 ? Slip::square_without_two : Slip::exponent_lost, e, times(number(n), without),
                  [&] { return without; });
  }

  Expression named(const char* name, int body) const { return symbol(words_.at(name + std::to_string(body + 1))); }

  Expression of_symbol(const Expression& e) {
    const Symbol& s = *e->symbol;
    const int body = s.body;
    switch (s.is) {
      case Is::centre: {
        const Expression right = named("v", body);
        return unless(
            Slip::body_sign, e,
            unless(
                Slip::velocity_held, e, right, [&] { return zero(right->shape); }, body),
            [&] { return negative(right); }, body);
      }
      case Is::angle: {
        const Expression right = named("ω", body);
        return unless(
            Slip::body_sign, e,
            unless(
                Slip::velocity_held, e, right, [&] { return zero(right->shape); }, body),
            [&] { return negative(right); }, body);
      }
      case Is::orientation: {
        const Expression spin = named("ω", body);
        if (words_.world().dimension == 3) return make(Op::multiply, {make(Op::skew, {spin}), e});
        return make(Op::multiply, {spin, make(Op::perp, {e})});
      }
      case Is::turning: return of_turning(e, s);
      case Is::fixed: {
        const Expression still = zero(e->shape);
        if (how_.slip != Slip::world_turned || !s.shape.vector() || !words_.world().turning || s.axis >= 3)
          return still;
        const int occurrence = result.occurrences++;
        if (how_.occurrence >= 0 && how_.occurrence != occurrence) return still;
        const Expression turned = crossed(named("ω", how_.body), e);
        if (!result.of) result.of = e, result.right = still, result.slipped = turned;
        return turned;
      }
      case Is::defined: return of(s.definition);
      case Is::velocity:
      case Is::spin:
        throw Complaint(e->where, "Accelerations do not belong here: C holds positions alone, and " + s.name +
                                      " is a velocity.");
    }
    return e;
  }

  Expression of_turning(const Expression& e, const Symbol& s) {
    const int body = s.body, other = 1 - body;
    const Expression spin = named("ω", body), right = crossed(spin, e);
    if (!s.arm) {
      switch (how_.slip) {
        case Slip::frame_held:
          return unless(
              how_.slip, e, right, [&] { return zero(e->shape); }, body);
        case Slip::frame_reversed:
          return unless(
              how_.slip, e, right, [&] { return crossed(e, spin); }, body);
        case Slip::frame_of_other_body:
          return unless(
              how_.slip, e, right, [&] { return crossed(named("ω", other), e); }, body);
        case Slip::body_sign:
          return unless(
              how_.slip, e, right, [&] { return negative(right); }, body);
        default: return right;
      }
    }
    switch (how_.slip) {
      case Slip::arm_held:
        return unless(
            how_.slip, e, right, [&] { return zero(e->shape); }, body);
      case Slip::arm_reversed:
        return unless(
            how_.slip, e, right, [&] { return crossed(e, spin); }, body);
      case Slip::other_spin:
        return unless(
            how_.slip, e, right, [&] { return crossed(named("ω", other), e); }, body);
      case Slip::other_arm:
        return unless(
            how_.slip, e, right, [&] { return crossed(spin, named("r", other)); }, body);
      case Slip::whole_position:
        return unless(
            how_.slip, e, right,
            [&] {
              return crossed(spin, make(Op::add, {named("x", body), e}));
            },
            body);
      case Slip::body_sign:
      case Slip::turn_sign:
        return unless(
            how_.slip, e, right, [&] { return negative(right); }, body);
      default: return right;
    }
  }

  const Vocabulary& words_;
  Slipping how_;
};

}  // namespace

Expression derivative(const Expression& e, const Vocabulary& words) { return derivative(e, words, {}).rate; }

Differentiated derivative(const Expression& e, const Vocabulary& words, Slipping how) {
  Differentiator differentiator(words, how);
  Expression rate = differentiator.of(e);
  differentiator.result.rate = std::move(rate);
  return std::move(differentiator.result);
}

namespace {

bool has(const Expression& e, const Symbol& w) {
  return contains(e, [&](const Node& node) { return node.symbol == &w; });
}

/// c with a ∘ b = c·w, where ∘ is a product of scalars or the dot product, and b is linear in w.
Expression isolated(const Expression& a, const Expression& b, const Symbol& w);

Expression isolated_sum(const Expression& a, const Expression& first, const Expression& second, bool subtract,
                        const Symbol& w) {
  const Expression x = isolated(a, first, w), y = isolated(a, second, w);
  return !x || !y ? nullptr : subtract ? minus(x, y) : plus(x, y);
}

Expression isolated(const Expression& a, const Expression& b, const Symbol& w) {
  if (!has(b, w)) return zero(w.shape);
  const auto& part = b->of;
  switch (b->op) {
    case Op::symbol:
      if (b->symbol == &w) return a;
      return b->symbol->definition ? isolated(a, b->symbol->definition, w) : nullptr;
    case Op::negate: {
      const Expression of = isolated(a, part[0], w);
      return of ? negative(of) : nullptr;
    }
    case Op::rate: return isolated(a, part[1], w);
    case Op::add: return isolated_sum(a, part[0], part[1], false, w);
    case Op::subtract: return isolated_sum(a, part[0], part[1], true, w);
    case Op::divide: return isolated(divided(a, part[1]), part[0], w);
    case Op::multiply: {
      const Expression &x = part[0], &y = part[1];
      if (x->shape.scalar() && y->shape.scalar())
        return has(x, w) ? isolated(times(y, a), x, w) : isolated(times(x, a), y, w);
      if (x->shape.scalar()) return has(x, w) ? isolated(dotted(a, y), x, w) : isolated(times(x, a), y, w);
      if (y->shape.scalar()) return has(y, w) ? isolated(dotted(a, x), y, w) : isolated(times(y, a), x, w);
      return has(y, w) && y->shape.vector() ? isolated(times(make(Op::transpose, {x}), a), y, w) : nullptr;
    }
    case Op::dot:
      return has(part[1], w) ? isolated(times(a, part[0]), part[1], w) : isolated(times(a, part[1]), part[0], w);
    case Op::cross: {
      const Expression &x = part[0], &y = part[1];
      if (b->shape.scalar()) {  // in the plane x × y = perp(x)·y
        return has(y, w) ? isolated(times(a, make(Op::perp, {x})), y, w)
                         : isolated(negative(times(a, make(Op::perp, {y}))), x, w);
      }
      // The triple product: a·(x × y) = x·(y × a) = y·(a × x).
      return has(x, w) ? isolated(crossed(y, a), x, w) : isolated(crossed(a, x), y, w);
    }
    case Op::perp: return isolated(negative(make(Op::perp, {a})), part[0], w);
    default: return nullptr;
  }
}

}  // namespace

Expression coefficient(const Expression& e, const Symbol& w) { return isolated(number(1), e, w); }

}  // namespace byhand::desk
