#include "search/exact/exact_encoding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "search/sat/cardinality.hpp"

namespace changeover {

Design DesignFormula::decode(const std::function<bool(Literal)>& is_true) const {
  Design design(parameters_);
  Block block;
  for (std::uint64_t i = 0; i < b_; ++i) {
    block.clear();
    for (std::uint64_t e = 0; e < parameters_.v; ++e) {
      if (is_true(holds(i, e))) {
        block.push_back(static_cast<Element>(e));
      }
    }
    design.append(block);
  }
  return design;
}

std::vector<std::size_t> DesignFormula::chosen_positions(
    const std::function<bool(Literal)>& is_true) const {
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < wanted_.chosen.size(); ++i) {
    if (is_true(wanted_.chosen[i])) {
      positions.push_back(i + 1);
    }
  }
  return positions;
}

namespace {

using Number = std::int64_t;
using Literals = std::vector<Literal>;

Number floor_div(Number a, Number n) { return a >= 0 ? a / n : -((-a + n - 1) / n); }
Number ceil_div_signed(Number a, Number n) { return -floor_div(-a, n); }

// Whether counting allows f ≥ 1 elements in every block: without them there must be a circular
// design with blocks of k − f elements, in which every pair is newly covered.
bool may_have_fixed(const Parameters& p, std::uint64_t b, std::uint64_t f) {
  if (p.kind != Kind::circular || f + p.change > p.k || f >= p.v || p.change * b < p.v - f) {
    return false;
  }
  const std::uint64_t k = p.k - f;
  const std::uint64_t a_block = binomial(k, 2) - binomial(k - p.change, 2);
  return binomial(p.v - f, 2) <= checked_multiply(b, a_block);
}

bool may_have_two_fixed(const Parameters& p, std::uint64_t b) {
  for (std::uint64_t f = 2; f + p.change <= p.k; ++f) {
    if (may_have_fixed(p, b, f)) {
      return true;
    }
  }
  return false;
}

// Newly covered t-subsets less C(v,t): the number of repetitions, with fewer than t fixed elements.
Number repetitions(const Parameters& p, std::uint64_t b) {
  const std::uint64_t a_block = newly_covered_at_most(p);
  const std::uint64_t covered =
      p.kind == Kind::circular
          ? checked_multiply(b, a_block)
          : checked_add(binomial(p.k, p.strength), checked_multiply(b - 1, a_block));
  const std::uint64_t wanted = binomial(p.v, p.strength);
  constexpr std::uint64_t most = std::numeric_limits<Number>::max();
  if (covered > most || wanted > most) {
    throw ImpossibleParameters(
        "these parameters are too large, a count exceeds 63 bits; give smaller ones");
  }
  return static_cast<Number>(covered) - static_cast<Number>(wanted);
}

/// The numbers that decide which clauses exist. The encoder and the count of clauses both use them.
struct EncodingPlan {
  EncodingPlan(const Parameters& parameters, std::uint64_t blocks, const EncodingOptions& options,
               const Wanted& besides)
      : p(parameters),
        b(blocks),
        wanted(besides),
        order(options.order),
        alike(order && wanted.any() ? next_alike(p, wanted) : std::vector<std::uint64_t>{}),
        wraps(p.kind == Kind::circular && b > 1),
        two_fixed(may_have_two_fixed(p, b)),
        repetitions(changeover::repetitions(p, b)),
        degrees(options.degrees && b > 1 && p.change < p.k),
        counted(p.strength == 2 && !two_fixed && b > 1 &&
                repetitions <= static_cast<Number>(options.budget)) {}

  /// Number of blocks with a predecessor.
  [[nodiscard]] std::uint64_t steps() const { return wraps ? b : b - 1; }

  /// The next element that is alike, p.v if there is none.
  [[nodiscard]] std::uint64_t next_of(std::uint64_t e) const {
    return alike.empty() ? e + 1 : alike[e];
  }

  /// For how many elements there is one.
  [[nodiscard]] std::uint64_t ordered() const {
    return alike.empty() ? p.v - 1
                         : static_cast<std::uint64_t>(std::ranges::count_if(
                               alike, [this](std::uint64_t next) { return next < p.v; }));
  }

  /// Newly covered t-subsets at an introduced element, and at one that stays.
  [[nodiscard]] Number met() const {
    return static_cast<Number>(binomial(p.k - 1, p.strength - 1));
  }
  [[nodiscard]] Number met_staying() const {
    return met() - static_cast<Number>(binomial(p.k - 1 - p.change, p.strength - 1));
  }

  /// The limit for repetitions at one element, if there is one: all e_x together are twice the
  /// repetitions, and each is at least the least residue of −(v−1) modulo gcd(k−1, m).
  [[nodiscard]] std::optional<Number> most_excess() const {
    if (two_fixed || p.strength > 2) {
      return std::nullopt;
    }
    const auto modulus = static_cast<Number>(std::gcd(p.k - 1, p.change));
    const auto others = static_cast<Number>(p.v) - 1;
    const Number each = (modulus - others % modulus) % modulus;
    return 2 * repetitions - others * each;
  }

  Parameters p;
  std::uint64_t b;
  const Wanted& wanted;  // of the caller
  bool order;
  std::vector<std::uint64_t> alike;  // see next_of(); empty if all elements are alike
  bool wraps;
  bool two_fixed;      // there may be two or more elements that are in every block
  Number repetitions;  // possible ones, with fewer than t fixed elements
  bool degrees;
  bool counted;  // whether repetitions are counted (the budget)
};

// Calls each(i, least, largest) for i = 0 … b introductions of an element, which must then be in at
// least `least` blocks (if that is positive) and at most `largest` (if that is below b).
template <typename Each>
void for_each_degree(const EncodingPlan& plan, const Each& each) {
  const Number met = plan.met();
  const Number met_staying = plan.met_staying();
  if (met_staying == 0) {
    return;
  }
  const auto b = static_cast<Number>(plan.b);
  const auto wanted = static_cast<Number>(binomial(plan.p.v - 1, plan.p.strength - 1));
  const std::optional<Number> most = plan.most_excess();
  for (Number i = 0; i <= b; ++i) {
    const Number rest = wanted - i * (met - met_staying);
    const Number largest = most ? floor_div(rest + *most, met_staying) : b;
    each(i, ceil_div_signed(rest, met_staying), largest);
  }
}

class Encoder {
 public:
  Encoder(const EncodingPlan& plan, const CnfSize& size)
      : plan_(plan), p_(plan.p), b_(plan.b), formula_(p_, b_), cnf_(formula_.cnf()) {
    cnf_.reserve(size);
    for (std::uint64_t i = 0; i < checked_multiply(b_, p_.v); ++i) {
      (void)cnf_.new_variable();
    }
  }

  DesignFormula take() {
    blocks();
    steps();
    if (plan_.order) {
      order();
    }
    if (plan_.degrees) {
      degrees();
    }
    coverage();
    formula_.wanted() = add_wanted(cnf_, p_, b_, plan_.wanted,
                                   [this](std::uint64_t i, std::uint64_t e) { return x(i, e); });
    return std::move(formula_);
  }

 private:
  [[nodiscard]] Literal x(std::uint64_t i, std::uint64_t e) const { return formula_.holds(i, e); }
  [[nodiscard]] bool has_previous(std::uint64_t i) const { return i > 0 || plan_.wraps; }
  [[nodiscard]] std::uint64_t previous(std::uint64_t i) const { return i > 0 ? i - 1 : b_ - 1; }
  // Element e is introduced in block i; every element of the first block of a linear design is.
  [[nodiscard]] Literal introduced(std::uint64_t i, std::uint64_t e) const {
    return has_previous(i) ? introduced_[i * p_.v + e] : x(i, e);
  }

  // A new literal that is equivalent to both.
  Literal both(Literal a, Literal b) {
    const Literal c = cnf_.new_variable();
    cnf_.add({-c, a});
    cnf_.add({-c, b});
    cnf_.add({c, -a, -b});
    return c;
  }

  void blocks() {
    Literals row(p_.v);
    for (std::uint64_t i = 0; i < b_; ++i) {
      for (std::uint64_t e = 0; e < p_.v; ++e) {
        row[e] = x(i, e);
      }
      require_exactly(cnf_, row, p_.k);
    }
  }

  // That m elements leave is implied, but the clauses allow unit propagation to use it: without
  // them, solving took ten times as long.
  void steps() {
    introduced_.assign(b_ * p_.v, 0);
    Literals in(p_.v);
    Literals out(p_.v);
    for (std::uint64_t i = 0; i < b_; ++i) {
      if (has_previous(i)) {
        for (std::uint64_t e = 0; e < p_.v; ++e) {
          introduced_[i * p_.v + e] = in[e] = both(x(i, e), -x(previous(i), e));
          out[e] = both(-x(i, e), x(previous(i), e));
        }
        require_exactly(cnf_, in, p_.change);
        require_exactly(cnf_, out, p_.change);
      }
    }
  }

  // Column e is not below the next one that is alike. `same` holds if they agree in the blocks
  // before i; only the implications that the order needs are encoded.
  void order() {
    for (std::uint64_t e = 0; e < p_.v; ++e) {
      stop_if_asked();
      const std::uint64_t next = plan_.next_of(e);
      if (next == p_.v) {
        continue;
      }
      Literals unless;  // −same, if there are blocks before i
      for (std::uint64_t i = 0; i < b_; ++i) {
        const auto add = [&](std::initializer_list<Literal> literals) {
          Literals clause = unless;
          clause.insert(clause.end(), literals);
          cnf_.add(clause);
        };
        add({x(i, e), -x(i, next)});
        if (i + 1 < b_) {
          const Literal same = cnf_.new_variable();
          add({same, -x(i, next)});  // both blocks have the element
          add({same, x(i, e)});      // neither has it
          unless.assign(1, -same);
        }
      }
    }
  }

  void degrees() {
    Literals in(b_);
    Literals at(b_);
    for (std::uint64_t e = 0; e < p_.v; ++e) {
      stop_if_asked();
      for (std::uint64_t i = 0; i < b_; ++i) {
        in[i] = introduced(i, e);
        at[i] = x(i, e);
      }
      Literals unless;
      if (plan_.two_fixed) {
        unless.push_back(cnf_.new_variable());  // it may hold only if the element is in every block
        for (const Literal there : at) {
          cnf_.add({-unless.front(), there});
        }
      }
      degree(unary_count(cnf_, in, b_), unary_count(cnf_, at, b_), unless);
    }
  }

  // i·met + (r − i)·met_staying is at least C(v−1,t−1), and at most that and most_excess().
  // `in` and `at` are the counts i and r in unary.
  void degree(const Literals& in, const Literals& at, const Literals& unless) {
    const auto b = static_cast<Number>(b_);
    // "count ≥ number" in a clause that may have literals already.
    const auto add_at_least = [&](Literals& clause, const Literals& count, Number number) {
      if (number <= b) {
        clause.push_back(count[static_cast<std::size_t>(number - 1)]);
      }
    };
    for_each_degree(plan_, [&](Number i, Number least, Number largest) {
      if (least >= 1) {  // i introductions or fewer
        Literals clause = unless;
        add_at_least(clause, in, i + 1);
        add_at_least(clause, at, least);
        cnf_.add(clause);
      }
      if (largest < b) {  // i introductions or more
        Literals clause = unless;
        if (i > 0) {
          clause.push_back(-in[static_cast<std::size_t>(i - 1)]);
        }
        if (largest >= 0) {
          clause.push_back(-at[static_cast<std::size_t>(largest)]);
        }
        cnf_.add(clause);
      }
    });
  }

  void coverage() {
    if (plan_.counted && plan_.repetitions < 0) {
      cnf_.add({});
      return;
    }
    Block subset(p_.strength);
    std::iota(subset.begin(), subset.end(), 0U);
    Literals repeated;
    do {
      stop_if_asked();
      plan_.counted ? newly_covered(subset[0], subset[1], repeated) : covered(subset);
    } while (next(subset));
    if (plan_.counted) {
      require_at_most(cnf_, repeated, static_cast<std::size_t>(plan_.repetitions));
    }
  }

  // The next subset in lexicographic order; false at the end.
  [[nodiscard]] bool next(Block& subset) const {
    std::size_t j = subset.size();
    while (j > 0 && subset[j - 1] + (subset.size() - j) + 1 == p_.v) {
      --j;
    }
    if (j == 0) {
      return false;
    }
    ++subset[j - 1];
    for (; j < subset.size(); ++j) {
      subset[j] = subset[j - 1] + 1;
    }
    return true;
  }

  void covered(const Block& subset) {
    Literals somewhere;
    for (std::uint64_t i = 0; i < b_; ++i) {
      const Literal here = cnf_.new_variable();
      somewhere.push_back(here);
      for (const Element e : subset) {
        cnf_.add({-here, x(i, e)});
      }
    }
    cnf_.add(somewhere);
  }

  // A literal for each block, which holds if and only if the pair is newly covered there. Literals
  // for "a second time", "a third time", … are added to `repeated`.
  void newly_covered(std::uint64_t e, std::uint64_t f, Literals& repeated) {
    Literals newly;
    for (std::uint64_t i = 0; i < b_; ++i) {
      const Literal here = cnf_.new_variable();
      newly.push_back(here);
      cnf_.add({-here, x(i, e)});
      cnf_.add({-here, x(i, f)});
      if (has_previous(i)) {
        cnf_.add({-here, introduced(i, e), introduced(i, f)});
        cnf_.add({here, -introduced(i, e), -x(i, f)});
        cnf_.add({here, -introduced(i, f), -x(i, e)});
      } else {
        cnf_.add({here, -x(i, e), -x(i, f)});
      }
    }
    cnf_.add(newly);
    if (plan_.repetitions == 0) {
      at_most_one(newly);
    } else {
      const Literals times =
          unary_count(cnf_, newly, static_cast<std::size_t>(plan_.repetitions) + 2);
      repeated.insert(repeated.end(), times.begin() + 1, times.end());
    }
  }

  // In the order of the blocks, so that "before" is meaningful to the solver.
  void at_most_one(const Literals& newly) {
    Literal before = newly.front();
    for (std::size_t i = 1; i < newly.size(); ++i) {
      cnf_.add({-before, -newly[i]});
      const Literal by_now = cnf_.new_variable();
      cnf_.add({by_now, -newly[i]});
      cnf_.add({by_now, -before});
      before = by_now;
    }
  }

  const EncodingPlan& plan_;
  const Parameters& p_;
  const std::uint64_t b_;
  DesignFormula formula_;
  Cnf& cnf_;
  Literals introduced_;
};

// The clauses of Encoder::degrees().
CnfSize degrees_size(const EncodingPlan& plan) {
  CnfSize size = 2 * unary_count_size(plan.b, plan.b);
  const std::uint64_t unless = plan.two_fixed ? 1 : 0;
  if (plan.two_fixed) {
    size += CnfSize{.variables = 1, .clauses = 0, .literals = 0} + clauses_of(plan.b, 2);
  }
  const auto b = static_cast<Number>(plan.b);
  for_each_degree(plan, [&](Number i, Number least, Number largest) {
    constexpr Number often = 1 << 16;
    if (i % often == 0) {
      stop_if_asked();
    }
    if (least >= 1) {
      size += clauses_of(1, unless + (i < b ? 1 : 0) + (least <= b ? 1 : 0));
    }
    if (largest < b) {
      size += clauses_of(1, unless + (i > 0 ? 1 : 0) + (largest >= 0 ? 1 : 0));
    }
  });
  return plan.p.v * size;
}

// The number of variables and clauses that Encoder::order() adds.
CnfSize order_size(const EncodingPlan& plan) {
  const std::uint64_t others = plan.b - 1;
  CnfSize size = clauses_of(1, 2) + clauses_of(others, 3);
  if (others > 0) {
    size += CnfSize{.variables = others, .clauses = 0, .literals = 0};
    size += clauses_of(2, 2) + clauses_of(2 * (others - 1), 3);
  }
  return plan.ordered() * size;
}

// The size of what Encoder::coverage() adds.
CnfSize coverage_size(const EncodingPlan& plan) {
  if (plan.counted && plan.repetitions < 0) {
    return clauses_of(1, 0);
  }
  const std::uint64_t b = plan.b;
  const std::uint64_t subsets = binomial(plan.p.v, plan.p.strength);
  CnfSize each = clauses_of(1, b);
  each.variables = b;
  if (!plan.counted) {
    return subsets * (each + clauses_of(checked_multiply(b, plan.p.strength), 2));
  }
  each += clauses_of(2 * b, 2) + clauses_of(3 * plan.steps() + (plan.wraps ? 0 : 1), 3);
  if (plan.repetitions == 0) {
    each += clauses_of(3 * (b - 1), 2) + CnfSize{.variables = b - 1, .clauses = 0, .literals = 0};
    return subsets * each;
  }
  const auto repetitions = static_cast<std::uint64_t>(plan.repetitions);
  const std::uint64_t times = std::min(repetitions + 2, b);
  each += unary_count_size(b, repetitions + 2);
  return subsets * each + at_most_size(checked_multiply(subsets, times - 1), repetitions);
}

CnfSize size_of(const EncodingPlan& plan) {
  const Parameters& p = plan.p;
  const std::uint64_t places = checked_multiply(plan.b, p.v);
  CnfSize both{.variables = 1, .clauses = 0, .literals = 0};
  both += clauses_of(2, 2) + clauses_of(1, 3);
  CnfSize size{.variables = places, .clauses = 0, .literals = 0};
  size += plan.b * exactly_size(p.v, p.k);
  size += plan.steps() * (checked_multiply(2, p.v) * both + 2 * exactly_size(p.v, p.change));
  if (plan.order) {
    size += order_size(plan);
  }
  size += coverage_size(plan);
  size += wanted_size(p, plan.b, plan.wanted);
  // Only now, because it takes O(b).
  require_representable(size, formula_name(p, plan.b));
  if (plan.degrees) {
    size += degrees_size(plan);
  }
  return size;
}

[[noreturn]] void too_large(const Parameters& p, std::uint64_t b) {
  throw MissingResource(formula_name(p, b) +
                        " would have more variables than a formula holds (10^8); ask for something "
                        "smaller");
}

/// The numbers of a question and the size of its formula.
struct Counted {
  EncodingPlan plan;
  CnfSize size;
};

Counted count(const Parameters& p, std::uint64_t b, const EncodingOptions& options,
              const Wanted& wanted) {
  check(p);
  if (b > most_variables / p.v) {  // below that, products of b with parameters fit
    too_large(p, b);
  }
  try {
    const EncodingPlan plan(p, b, options, wanted);
    Counted counted{plan, size_of(plan)};
    require_representable(counted.size, formula_name(p, b));
    return counted;
  } catch (const ImpossibleParameters&) {  // 64 bits do not hold it
    too_large(p, b);
  }
}

}  // namespace

std::string formula_name(const Parameters& p, std::uint64_t b) {
  return fmt::format("the formula of {} with {}", name(p), count_of(b, "block"));
}

CnfSize design_formula_size(const Parameters& p, std::uint64_t b, const EncodingOptions& options,
                            const Wanted& wanted) {
  return count(p, b, options, wanted).size;
}

DesignFormula encode_design(const Parameters& p, std::uint64_t b, const EncodingOptions& options,
                            const Wanted& wanted) {
  const Counted counted = count(p, b, options, wanted);
  return Encoder(counted.plan, counted.size).take();
}

}  // namespace changeover
