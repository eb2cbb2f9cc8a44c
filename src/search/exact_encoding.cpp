#include "changeover/search/exact_encoding.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "changeover/core/checked.hpp"
#include "changeover/search/cardinality.hpp"

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

namespace {

using Number = std::int64_t;
using Literals = std::vector<Literal>;

Number floor_div(Number a, Number n) { return a >= 0 ? a / n : -((-a + n - 1) / n); }
Number ceil_div_signed(Number a, Number n) { return -floor_div(-a, n); }

// Whether counting leaves room for f ≥ 1 elements in every block: without them there must be a
// circular design with blocks of k − f elements, in which every pair is newly covered.
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

// Newly covered t-subsets less C(v,t): the repetitions, if there are less than t fixed elements.
Number repetitions(const Parameters& p, std::uint64_t b) {
  const std::uint64_t a_block = newly_covered_at_most(p);
  const std::uint64_t covered =
      p.kind == Kind::circular
          ? checked_multiply(b, a_block)
          : checked_add(binomial(p.k, p.strength), checked_multiply(b - 1, a_block));
  return static_cast<Number>(covered) - static_cast<Number>(binomial(p.v, p.strength));
}

class Encoder {
 public:
  Encoder(const Parameters& p, std::uint64_t b, const EncodingOptions& options)
      : p_(p),
        b_(b),
        options_(options),
        wraps_(p.kind == Kind::circular && b > 1),
        two_fixed_(may_have_two_fixed(p, b)),
        repetitions_(repetitions(p, b)),
        formula_(p, b),
        cnf_(formula_.cnf()) {
    for (std::uint64_t i = 0; i < checked_multiply(b, p.v); ++i) {
      (void)cnf_.new_variable();
    }
  }

  DesignFormula take() {
    blocks();
    steps();
    if (options_.order) {
      order();
    }
    if (options_.degrees && b_ > 1 && p_.change < p_.k) {
      degrees();
    }
    coverage();
    return std::move(formula_);
  }

 private:
  [[nodiscard]] Literal x(std::uint64_t i, std::uint64_t e) const { return formula_.holds(i, e); }
  [[nodiscard]] bool has_previous(std::uint64_t i) const { return i > 0 || wraps_; }
  [[nodiscard]] std::uint64_t previous(std::uint64_t i) const { return i > 0 ? i - 1 : b_ - 1; }
  // Element e is introduced in block i; every element of the first block of a linear design is.
  [[nodiscard]] Literal introduced(std::uint64_t i, std::uint64_t e) const {
    return has_previous(i) ? introduced_[i * p_.v + e] : x(i, e);
  }

  // A new literal that holds if and only if both do.
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

  // That m leave follows, but saying so lets unit propagation see it: without, it was ten times slower.
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

  // Column e is not below column e + 1. `same` holds if they agree in the blocks before i; of the two
  // ways to agree it needs only what the order leaves open.
  void order() {
    for (std::uint64_t e = 0; e + 1 < p_.v; ++e) {
      Literals unless;  // −same, if there are blocks before i
      for (std::uint64_t i = 0; i < b_; ++i) {
        const auto add = [&](std::initializer_list<Literal> literals) {
          Literals clause = unless;
          clause.insert(clause.end(), literals);
          cnf_.add(clause);
        };
        add({x(i, e), -x(i, e + 1)});
        if (i + 1 < b_) {
          const Literal same = cnf_.new_variable();
          add({same, -x(i, e + 1)});  // both are there
          add({same, x(i, e)});       // neither is
          unless.assign(1, -same);
        }
      }
    }
  }

  void degrees() {
    const std::uint64_t t = p_.strength;
    const auto met = static_cast<Number>(binomial(p_.k - 1, t - 1));
    const Number met_staying = met - static_cast<Number>(binomial(p_.k - 1 - p_.change, t - 1));
    Literals in(b_);
    Literals at(b_);
    for (std::uint64_t e = 0; e < p_.v; ++e) {
      for (std::uint64_t i = 0; i < b_; ++i) {
        in[i] = introduced(i, e);
        at[i] = x(i, e);
      }
      Literals unless;
      if (two_fixed_) {
        unless.push_back(cnf_.new_variable());  // it may hold only if the element is in every block
        for (const Literal there : at) {
          cnf_.add({-unless.front(), there});
        }
      }
      degree(unary_count(cnf_, in, b_), unary_count(cnf_, at, b_), unless, met, met_staying);
    }
  }

  // i·met + (r − i)·met_staying is at least C(v−1,t−1), and at most that and most_excess().
  // in and at are the counts i and r in unary.
  void degree(const Literals& in, const Literals& at, const Literals& unless, Number met,
              Number met_staying) {
    if (met_staying == 0) {
      return;
    }
    const auto b = static_cast<Number>(b_);
    const auto wanted = static_cast<Number>(binomial(p_.v - 1, p_.strength - 1));
    const std::optional<Number> most = most_excess();
    // "count ≥ number" in a clause that may have literals already.
    const auto add_at_least = [&](Literals& clause, const Literals& count, Number number) {
      if (number <= b) {
        clause.push_back(count[static_cast<std::size_t>(number - 1)]);
      }
    };
    for (Number i = 0; i <= b; ++i) {
      const Number rest = wanted - i * (met - met_staying);
      const Number least = ceil_div_signed(rest, met_staying);
      if (least >= 1) {  // i introductions or fewer
        Literals clause = unless;
        add_at_least(clause, in, i + 1);
        add_at_least(clause, at, least);
        cnf_.add(clause);
      }
      const Number largest = most ? floor_div(rest + *most, met_staying) : b;
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
    }
  }

  // All e_x together are twice the repetitions, and each is at least the least residue of −(v−1) modulo
  // gcd(k−1, m).
  [[nodiscard]] std::optional<Number> most_excess() const {
    if (two_fixed_ || p_.strength > 2) {
      return std::nullopt;
    }
    const auto modulus = static_cast<Number>(std::gcd(p_.k - 1, p_.change));
    const auto others = static_cast<Number>(p_.v) - 1;
    const Number each = (modulus - others % modulus) % modulus;
    return 2 * repetitions_ - others * each;
  }

  void coverage() {
    const bool counted = p_.strength == 2 && !two_fixed_ && b_ > 1 &&
                         repetitions_ <= static_cast<Number>(options_.budget);
    if (counted && repetitions_ < 0) {
      cnf_.add({});
      return;
    }
    Block subset(p_.strength);
    std::iota(subset.begin(), subset.end(), 0U);
    Literals repeated;
    do {
      counted ? newly_covered(subset[0], subset[1], repeated) : covered(subset);
    } while (next(subset));
    if (counted) {
      require_at_most(cnf_, repeated, static_cast<std::size_t>(repetitions_));
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

  // A literal for each block, which holds if and only if the pair is newly covered there. Those
  // that say "a second time", "a third time" … are added to `repeated`.
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
    if (repetitions_ == 0) {
      at_most_one(newly);
    } else {
      const Literals times = unary_count(cnf_, newly, static_cast<std::size_t>(repetitions_) + 2);
      repeated.insert(repeated.end(), times.begin() + 1, times.end());
    }
  }

  // In order of time, so that "before" means something to the solver.
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

  Parameters p_;
  std::uint64_t b_;
  EncodingOptions options_;
  bool wraps_;
  bool two_fixed_;  // there may be two or more elements that are in every block
  Number repetitions_;
  DesignFormula formula_;
  Cnf& cnf_;
  Literals introduced_;
};

}  // namespace

DesignFormula encode_design(const Parameters& p, std::uint64_t b, const EncodingOptions& options) {
  check(p);
  return Encoder(p, b, options).take();
}

}  // namespace changeover
