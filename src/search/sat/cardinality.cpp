#include "search/sat/cardinality.hpp"

#include <algorithm>
#include <map>

#include "changeover/run/control.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

/// The directions of "at least j hold ⟺ output j" that are encoded.
struct Directions {
  bool up = true;    // enough inputs imply the output
  bool down = true;  // too few inputs imply its negation
};

// Σ = i + j, where a counts i and b counts j; both are unary: place j − 1 stands for "at least j".
std::vector<Literal> sum(Cnf& cnf, const std::vector<Literal>& a, const std::vector<Literal>& b,
                         std::size_t limit, Directions directions) {
  const std::size_t size = std::min(limit, a.size() + b.size());
  std::vector<Literal> total(size);
  std::ranges::generate(total, [&] { return cnf.new_variable(); });
  std::vector<Literal> clause;
  for (std::size_t i = 0; i <= a.size(); ++i) {
    stop_if_asked();
    // Beyond size, no clause: i + j stays at most that.
    for (std::size_t j = 0; j <= b.size() && i + j <= size; ++j) {
      if (directions.up && i + j >= 1 && i + j <= size) {  // a ≥ i and b ≥ j: total ≥ i + j
        clause.assign(1, total[i + j - 1]);
        if (i > 0) {
          clause.push_back(-a[i - 1]);
        }
        if (j > 0) {
          clause.push_back(-b[j - 1]);
        }
        cnf.add(clause);
      }
      if (directions.down && i + j < size) {  // a ≤ i and b ≤ j: total ≤ i + j
        clause.assign(1, -total[i + j]);
        if (i < a.size()) {
          clause.push_back(a[i]);
        }
        if (j < b.size()) {
          clause.push_back(b[j]);
        }
        cnf.add(clause);
      }
    }
  }
  return total;
}

std::vector<Literal> counted(Cnf& cnf, std::span<const Literal> literals, std::size_t limit,
                             Directions directions) {
  if (limit == 0) {
    return {};
  }
  if (literals.size() <= 1) {
    return {literals.begin(), literals.end()};
  }
  const std::size_t half = literals.size() / 2;
  return sum(cnf, counted(cnf, literals.first(half), limit, directions),
             counted(cnf, literals.subspan(half), limit, directions), limit, directions);
}

// Pairs i ≤ a, j ≤ b with i + j ≤ most.
std::uint64_t pairs_below(std::uint64_t a, std::uint64_t b, std::uint64_t most) {
  const std::uint64_t top = std::min(most, a + b);
  const auto triangle = [](std::uint64_t n) {  // pairs with i + j < n
    return n % 2 == 0 ? checked_multiply(n / 2, n + 1) : checked_multiply(n, (n + 1) / 2);
  };
  std::uint64_t beyond = 0;  // of the triangle i + j ≤ top, the corners i > a and j > b
  beyond += top > a ? triangle(top - a) : 0;
  beyond += top > b ? triangle(top - b) : 0;
  return triangle(top + 1) - beyond;  // top ≤ a + b: the corners do not meet
}

// The size of sum() with a.size() = a, b.size() = b.
CnfSize sum_size(std::uint64_t a, std::uint64_t b, std::uint64_t limit, Directions directions) {
  CnfSize size{.variables = std::min(limit, a + b), .clauses = 0, .literals = 0};
  const std::uint64_t total = size.variables;
  if (directions.up) {  // all but i = j = 0; i and j have a literal each where they are not 0
    const std::uint64_t all = pairs_below(a, b, total);
    CnfSize up = clauses_of(all - 1, 1);
    up.literals = checked_add(up.literals, all - std::min(b, total) - 1);
    up.literals = checked_add(up.literals, all - std::min(a, total) - 1);
    size += up;
  }
  if (directions.down) {  // i and j have a literal each where they are not a and b
    CnfSize down = clauses_of(pairs_below(a, b, total - 1), 1);
    down.literals = checked_add(down.literals, pairs_below(a - 1, b, total - 1));
    down.literals = checked_add(down.literals, pairs_below(a, b - 1, total - 1));
    size += down;
  }
  return size;
}

/// The sizes of counted(): halving gives at most two different numbers on each level.
class CountSizes {
 public:
  CountSizes(std::uint64_t limit, Directions directions) : limit_(limit), directions_(directions) {}

  CnfSize of(std::uint64_t literals) {
    if (limit_ == 0 || literals <= 1) {
      return {};
    }
    if (const auto known = known_.find(literals); known != known_.end()) {
      return known->second;
    }
    const std::uint64_t half = literals / 2;
    const CnfSize size =
        of(half) + of(literals - half) +
        sum_size(std::min(limit_, half), std::min(limit_, literals - half), limit_, directions_);
    known_.emplace(literals, size);
    return size;
  }

 private:
  std::uint64_t limit_;
  Directions directions_;
  std::map<std::uint64_t, CnfSize> known_;
};

CnfSize counted_size(std::uint64_t literals, std::uint64_t limit, Directions directions) {
  return CountSizes(limit, directions).of(literals);
}

}  // namespace

std::vector<Literal> unary_count(Cnf& cnf, std::span<const Literal> literals, std::size_t limit) {
  return counted(cnf, literals, limit, {});
}

void require_exactly(Cnf& cnf, std::span<const Literal> literals, std::size_t number) {
  if (number > literals.size()) {
    cnf.add({});
    return;
  }
  const std::vector<Literal> at_least = counted(cnf, literals, number + 1, {});
  if (number > 0) {
    cnf.add({at_least[number - 1]});
  }
  if (number < at_least.size()) {
    cnf.add({-at_least[number]});
  }
}

void require_at_most(Cnf& cnf, std::span<const Literal> literals, std::size_t number) {
  if (number < literals.size()) {
    const std::vector<Literal> at_least =
        counted(cnf, literals, number + 1, {.up = true, .down = false});
    cnf.add({-at_least[number]});
  }
}

void at_most_one(Cnf& cnf, std::span<const Literal> literals) {
  if (literals.size() <= 6) {
    for (std::size_t i = 0; i < literals.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        cnf.add({-literals[i], -literals[j]});
      }
    }
    return;
  }
  Literal before = literals[0];  // at least one of the literals so far holds
  for (std::size_t i = 1; i < literals.size(); ++i) {
    cnf.add({-before, -literals[i]});
    if (i + 1 < literals.size()) {
      const Literal next = cnf.new_variable();
      cnf.add({-before, next});
      cnf.add({-literals[i], next});
      before = next;
    }
  }
}

void require_not_less(Cnf& cnf, std::span<const Literal> a, std::span<const Literal> b) {
  std::vector<Literal> same;  // negated: no difference so far
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::vector<Literal> clause = same;
    clause.insert(clause.end(), {a[i], -b[i]});
    cnf.add(clause);
    if (i + 1 == a.size()) {
      break;
    }
    // As a ≥ b at this digit if all before are the same, it is the same unless a has 1 and b has 0.
    const Literal still = cnf.new_variable();
    for (const Literal reason : {-a[i], b[i]}) {
      clause = same;
      clause.insert(clause.end(), {still, -reason});
      cnf.add(clause);
    }
    same = {-still};
  }
}

CnfSize unary_count_size(std::uint64_t literals, std::uint64_t limit) {
  return counted_size(literals, limit, {});
}

CnfSize exactly_size(std::uint64_t literals, std::uint64_t number) {
  if (number > literals) {
    return clauses_of(1, 0);
  }
  const std::uint64_t bounds = (number > 0 ? 1U : 0U) + (number < literals ? 1U : 0U);
  return counted_size(literals, number + 1, {}) + clauses_of(bounds, 1);
}

CnfSize at_most_size(std::uint64_t literals, std::uint64_t number) {
  if (number >= literals) {
    return {};
  }
  return counted_size(literals, number + 1, {.up = true, .down = false}) + clauses_of(1, 1);
}

}  // namespace changeover
