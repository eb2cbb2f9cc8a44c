// The store of clauses against unit propagation by definition: clauses are looked at again and
// again until none has anything to say. What a store answers must not depend on what it was asked
// before.
#include "proof/clause_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace changeover::clause_store_test {
namespace {

using Clause = std::vector<std::int32_t>;

class NaiveStore {
 public:
  std::vector<Clause> clauses;  // sorted

  /// Whether unit propagation meets a contradiction once all of `literals` are false.
  [[nodiscard]] bool contradicts(const Clause& literals) const {
    std::map<std::int32_t, bool> value;
    for (const std::int32_t x : literals) {
      if (value.count(x) != 0 && value[x]) {
        return true;
      }
      value[x] = false;
      value[-x] = true;
    }
    return !propagate(value);
  }

  [[nodiscard]] bool resolvents_contradict(const Clause& clause, std::int32_t pivot) const {
    return std::all_of(clauses.begin(), clauses.end(), [&](const Clause& other) {
      if (std::count(other.begin(), other.end(), -pivot) == 0) {
        return true;
      }
      Clause both = clause;
      std::copy_if(other.begin(), other.end(), std::back_inserter(both),
                   [&](std::int32_t x) { return x != -pivot; });
      return contradicts(both);
    });
  }

  /// Whether the clause may be what says that one of its literals is true.
  [[nodiscard]] bool fixes(const Clause& clause) const {
    std::map<std::int32_t, bool> value;
    (void)propagate(value);
    std::size_t open = 0;
    for (const std::int32_t x : clause) {
      open += value.count(x) == 0 || value[x] ? 1U : 0U;
    }
    return open <= 1;
  }

 private:
  // False if a clause has no literal left.
  bool propagate(std::map<std::int32_t, bool>& value) const {
    for (bool more = true; more;) {
      more = false;
      for (const Clause& clause : clauses) {
        std::vector<std::int32_t> open;
        bool holds = false;
        for (const std::int32_t x : clause) {
          if (value.count(x) == 0) {
            open.push_back(x);
          } else {
            holds = holds || value[x];
          }
        }
        if (!holds && open.empty()) {
          return false;
        }
        if (!holds && open.size() == 1) {
          value[open[0]] = true;
          value[-open[0]] = false;
          more = true;
        }
      }
    }
    return true;
  }
};

Clause random_clause(std::mt19937& random, std::int32_t variables) {
  Clause clause;
  // A unit is rare: it would settle too much.
  const std::size_t length = random() % 12 == 0 ? 1 : 2 + random() % 3;
  while (clause.size() < length) {
    const auto x = 1 + static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(variables));
    if (std::none_of(clause.begin(), clause.end(),
                     [&](std::int32_t y) { return y == x || y == -x; })) {
      clause.push_back(random() % 2 == 0 ? x : -x);
    }
  }
  std::sort(clause.begin(), clause.end());
  return clause;
}

TEST(ClauseStore, AnswersAsUnitPropagationByDefinitionWhateverWasAskedBefore) {
  std::mt19937 random(5);
  int implied = 0;
  int by_resolvents = 0;
  int removed = 0;
  int kept = 0;
  int contradictions = 0;
  for (int round = 0; round < 300; ++round) {
    const auto variables = static_cast<std::int32_t>(5 + random() % 6);
    ClauseStore store(1 << 20);
    store.reserve(static_cast<std::uint64_t>(variables));
    NaiveStore naive;
    for (int i = 0; i < 120 && !store.contradictory(); ++i) {
      const Clause clause = random_clause(random, variables);
      const auto what = random() % 8;
      if (what < 2) {
        store.add(clause);
        naive.clauses.push_back(clause);
        ASSERT_EQ(store.contradictory(), naive.contradicts({})) << "round " << round;
        contradictions += store.contradictory() ? 1 : 0;
      } else if (what == 2 && !naive.clauses.empty()) {
        const Clause old =
            random() % 4 == 0 ? clause : naive.clauses[random() % naive.clauses.size()];
        const auto place = std::find(naive.clauses.begin(), naive.clauses.end(), old);
        const bool free = place != naive.clauses.end() && !naive.fixes(old);
        const bool gone = store.remove(old);
        ASSERT_TRUE(gone || !free) << "round " << round;
        if (gone) {
          ASSERT_TRUE(place != naive.clauses.end() && old.size() > 1) << "round " << round;
          naive.clauses.erase(place);
        }
        (gone ? removed : kept) += 1;
      } else if (what < 6) {
        ASSERT_EQ(store.implies(clause), naive.contradicts(clause)) << "round " << round;
        implied += naive.contradicts(clause) ? 1 : 0;
      } else {
        const bool follows = naive.resolvents_contradict(clause, clause[0]);
        ASSERT_EQ(store.implies_resolvents(clause, clause[0]), follows) << "round " << round;
        by_resolvents += follows ? 1 : 0;
      }
    }
  }
  EXPECT_GT(implied, 500);
  EXPECT_GT(by_resolvents, 500);
  EXPECT_GT(removed, 200);
  EXPECT_GT(kept, 50);
  EXPECT_GT(contradictions, 20);
}

// A clause whose watched literal was seen false beside a true one is looked at again later.
TEST(ClauseStore, StillWatchesAClauseThatWasTrueForAWhile) {
  ClauseStore store(1000);
  store.reserve(4);
  for (const Clause& clause : {Clause{1, 2, 3}, Clause{-3, 4}, Clause{-3, -4}}) {
    store.add(clause);
  }
  EXPECT_TRUE(store.implies(Clause{1, 2, -3}));
  EXPECT_TRUE(store.implies(Clause{1, 2}));
  EXPECT_TRUE(store.implies(Clause{2, 1}));
  EXPECT_FALSE(store.implies(Clause{1}));
}

// Its literal would be true for no reason. Many, since a hash decides where each is looked for.
TEST(ClauseStore, KeepsEachClauseThatFixedALiteral) {
  constexpr std::int32_t many = 64;
  ClauseStore store(10'000);
  store.reserve(2 * many);
  for (std::int32_t x = 1; x <= many; ++x) {
    store.add(Clause{-x, many + x});
  }
  for (std::int32_t x = 1; x <= many; x += 2) {
    store.add(Clause{x});
  }
  for (std::int32_t x = 1; x <= many; ++x) {
    EXPECT_EQ(store.remove(Clause{-x, many + x}), x % 2 == 0) << x;
  }
}

// Dead clauses are swept away once they are half of what is stored; those that moved are found
// where they are.
TEST(ClauseStore, FindsWhatIsLeftAfterDeadClausesWereSweptAway) {
  constexpr std::int32_t many = 30'000;
  const auto clause = [](std::int32_t i) { return Clause{i, -(many + i % 97 + 1), many + 100}; };
  ClauseStore store(1'000'000);
  store.reserve(many + 100);
  for (std::int32_t i = 1; i <= many; ++i) {
    store.add(clause(i));
  }
  for (std::int32_t i = 1; i <= many; ++i) {
    ASSERT_TRUE(i % 3 == 0 || store.remove(clause(i))) << i;
  }
  for (std::int32_t i = 1; i <= many; ++i) {
    ASSERT_EQ(store.remove(clause(i)), i % 3 == 0) << i;
  }
}

// What was true for one resolvent only fixed nothing, and may be deleted.
TEST(ClauseStore, ForgetsWhatAResolventAssumed) {
  ClauseStore store(1000);
  store.reserve(5);
  for (const Clause& clause : {Clause{-1, 2}, Clause{2, 3}, Clause{-3, 4}, Clause{-4, 2}}) {
    store.add(clause);
  }
  // −1 2 asks for 2 false: then 3, then 4, then not 4.
  EXPECT_FALSE(store.implies(Clause{1, 5}));
  EXPECT_TRUE(store.implies_resolvents(Clause{1, 5}, 1));
  EXPECT_TRUE(store.remove(Clause{-3, 4}));
  EXPECT_TRUE(store.remove(Clause{2, 3}));
  EXPECT_FALSE(store.implies_resolvents(Clause{1, 5}, 1));
}

// Dead clauses are swept away now and then. At each removal, this would take a minute.
TEST(ClauseStore, IsEmptiedOfManyClauses) {
  constexpr int many = 60'000;
  ClauseStore store(std::uint64_t{1} << 26);
  store.reserve(many + 5);
  const auto clause = [](int i) { return Clause{i, i + 1, -(i + 2), i + 3, -(i + 4)}; };
  for (int i = 1; i <= many; ++i) {
    store.add(clause(i));
  }
  EXPECT_TRUE(store.implies(clause(7)));
  for (int i = 1; i <= many; ++i) {
    ASSERT_TRUE(store.remove(clause(i))) << i;
    ASSERT_FALSE(store.remove(clause(i))) << i;
  }
  EXPECT_FALSE(store.implies(clause(7)));
  EXPECT_FALSE(store.contradictory());
}

}  // namespace
}  // namespace changeover::clause_store_test
