#include "changeover/search/cardinality.hpp"

#include <algorithm>

namespace changeover {
namespace {

/// Which directions of "at least j hold ⟺ output j" are wanted.
struct Directions {
  bool up = true;    // enough inputs make the output hold
  bool down = true;  // too few make it fail
};

// Σ = i + j with i counted by a, j by b: both are unary, place j − 1 says "at least j".
std::vector<Literal> sum(Cnf& cnf, const std::vector<Literal>& a, const std::vector<Literal>& b,
                         std::size_t limit, Directions directions) {
  const std::size_t size = std::min(limit, a.size() + b.size());
  std::vector<Literal> total(size);
  std::generate(total.begin(), total.end(), [&] { return cnf.new_variable(); });
  std::vector<Literal> clause;
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
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

}  // namespace changeover
