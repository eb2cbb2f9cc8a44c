// Designs with wanted cells, by SAT: every outcome against a search that looks at all lists.
#include "search/exact/exact_wanted.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <bitset>
#include <filesystem>
#include <optional>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/search/exact.hpp"
#include "message_of.hpp"
#include "naive_verdict.hpp"
#include "run/random.hpp"
#include "run_program.hpp"
#include "search/exact/exact_encoding.hpp"
#include "search/sat/sat_solver.hpp"

namespace changeover::exact_wanted_test {
namespace {

using testing::HasSubstr;
using testing::Not;

unsigned mask_of(const Block& block) {
  unsigned mask = 0;
  for (const Element x : block) {
    mask |= 1U << x;
  }
  return mask;
}

// What is wanted, by its definition, of blocks as sets of bits. Shares nothing with the library.
class WantedCheck {
 public:
  WantedCheck(const Parameters& p, const Wanted& wanted)
      : circular_(p.kind == Kind::circular),
        first_(mask_of(wanted.first)),
        last_(mask_of(wanted.last)),
        expansion_set_(wanted.expansion_set),
        rest_(((1U << p.v) - 1) & ~(first_ | last_)) {
    for (const Block& block : wanted.contained) {
      contained_.push_back(mask_of(block));
    }
  }

  [[nodiscard]] unsigned first() const { return first_; }

  [[nodiscard]] bool holds(const std::vector<unsigned>& list) const {
    return (first_ & ~list.front()) == 0 && (last_ & ~list.back()) == 0 && contains(list) &&
           (!expansion_set_ || parted(steps(list), 0, rest_));
  }

  // Whether the steps at these positions, from 1, are the parts.
  [[nodiscard]] bool are_parts(const std::vector<unsigned>& list,
                               const std::vector<std::size_t>& positions) const {
    unsigned left = rest_;
    const std::vector<unsigned> all = steps(list);
    for (const std::size_t position : positions) {
      const unsigned part = all.at(position - 1);
      if ((part & ~left) != 0) {
        return false;
      }
      left &= ~part;
    }
    return left == 0;
  }

 private:
  [[nodiscard]] std::vector<unsigned> steps(const std::vector<unsigned>& list) const {
    std::vector<unsigned> all;
    const std::size_t b = list.size();
    for (std::size_t i = 0; i + 1 < b; ++i) {
      all.push_back(list[i] & list[i + 1]);
    }
    if (circular_ && b > 1) {
      all.push_back(list[b - 1] & list[0]);
    }
    return all;
  }

  [[nodiscard]] bool contains(const std::vector<unsigned>& list) const {
    const std::size_t b = list.size();
    for (std::size_t at = 0; at < b; ++at) {
      bool here = circular_ || at + contained_.size() <= b;
      for (std::size_t i = 0; here && i < contained_.size(); ++i) {
        here = list[(at + i) % b] == contained_[i];
      }
      if (here) {
        return true;
      }
    }
    return false;
  }

  static bool parted(const std::vector<unsigned>& steps, std::size_t from, unsigned left) {
    if (left == 0) {
      return true;
    }
    for (std::size_t i = from; i < steps.size(); ++i) {
      if ((steps[i] & ~left) == 0 && parted(steps, i + 1, left & ~steps[i])) {
        return true;
      }
    }
    return false;
  }

  bool circular_;
  unsigned first_, last_;
  bool expansion_set_;
  unsigned rest_;
  std::vector<unsigned> contained_;
};

// Looks at all lists of b blocks, with every first block.
class WantedOracle {
 public:
  WantedOracle(const Parameters& p, const Wanted& wanted) : p_(p), check_(p, wanted) {
    for (unsigned set = 0; set < (1U << p.v); ++set) {
      if (static_cast<std::uint64_t>(std::popcount(set)) == p.k) {
        blocks_.push_back(set);
      } else if (static_cast<std::uint64_t>(std::popcount(set)) == p.strength) {
        subsets_.push_back(set);
      }
    }
    for (const unsigned subset : subsets_) {
      const unsigned first = (1U << p.k) - 1;  // and m of its elements change
      const unsigned held = (1U << (p.k - p.change)) - 1;
      step_ += (subset & ~first) == 0 && (subset & ~held) != 0 ? 1U : 0U;
    }
  }

  /// Nothing if the search takes more than `nodes` steps.
  std::optional<bool> exists(std::uint64_t b, std::uint64_t nodes) {
    b_ = b;
    left_ = nodes;
    list_.clear();
    bool found = false;
    for (const unsigned block : blocks_) {
      if ((check_.first() & ~block) == 0 && extend(block, {})) {
        found = true;
        break;
      }
    }
    return left_ == 0 ? std::nullopt : std::optional(found);
  }

 private:
  using Covered = std::bitset<32>;

  bool extend(unsigned block, Covered covered) {
    if (left_ == 0 || --left_ == 0) {
      return false;
    }
    list_.push_back(block);
    for (std::size_t i = 0; i < subsets_.size(); ++i) {
      if ((subsets_[i] & ~block) == 0) {
        covered.set(i);
      }
    }
    bool found = false;
    const std::size_t missing = subsets_.size() - covered.count();
    if (list_.size() == b_) {
      found = missing == 0 && closes() && check_.holds(list_);
    } else if (missing <= step_ * (b_ - list_.size())) {
      for (const unsigned next : blocks_) {
        if (step(block, next) && extend(next, covered)) {
          found = true;
          break;
        }
      }
    }
    list_.pop_back();
    return found;
  }

  [[nodiscard]] bool closes() const {
    return p_.kind == Kind::linear || b_ == 1 || step(list_.back(), list_.front());
  }

  [[nodiscard]] bool step(unsigned from, unsigned to) const {
    return static_cast<std::uint64_t>(std::popcount(to & ~from)) == p_.change;
  }

  Parameters p_;
  WantedCheck check_;
  std::vector<unsigned> blocks_, subsets_;
  std::size_t step_ = 0;  // subsets that one step may cover newly
  std::uint64_t b_ = 0;
  std::uint64_t left_ = 0;
  std::vector<unsigned> list_;
};

Block some_of(std::uint64_t v, std::uint64_t size, Random& random) {
  Block block;
  while (block.size() < size) {
    const Element x = random.below(static_cast<std::uint32_t>(v));
    if (std::find(block.begin(), block.end(), x) == block.end()) {
      block.push_back(x);
    }
  }
  return block;
}

std::uint64_t up_to(std::uint64_t most, Random& random) {
  return random.below(static_cast<std::uint32_t>(most) + 1);
}

// Anything that has a meaning.
Wanted draw(const Parameters& p, Random& random) {
  while (true) {
    Wanted wanted;
    if (p.kind == Kind::linear) {
      wanted.first = some_of(p.v, up_to(p.k, random) * up_to(1, random), random);
      wanted.last = some_of(p.v, up_to(p.k, random) * up_to(1, random), random);
    }
    wanted.expansion_set = up_to(1, random) == 1;
    const std::uint64_t given = up_to(1, random) * up_to(3, random);
    while (wanted.contained.size() < given) {
      Block next = some_of(p.v, p.k, random);
      const bool fits = wanted.contained.empty() ||
                        static_cast<std::uint64_t>(std::popcount(
                            mask_of(next) & ~mask_of(wanted.contained.back()))) == p.change;
      if (fits) {
        wanted.contained.push_back(std::move(next));
      }
    }
    if (wanted.any() && wanted_defect(p, wanted).empty()) {
      return wanted;
    }
  }
}

struct Counts {
  std::size_t found = 0;
  std::size_t none = 0;
};

class AgainstOracle {
 public:
  void hold(const Parameters& p, std::uint64_t b, const Wanted& wanted) {
    SCOPED_TRACE(fmt::format("{} with {} blocks{}", name(p), b, wanted_words(wanted)));
    const std::optional<bool> exists = WantedOracle(p, wanted).exists(b, 400'000);
    if (!exists) {
      ++undecided;
      return;
    }
    const DesignFormula formula = encode_design(p, b, {}, wanted);
    ASSERT_EQ(design_formula_size(p, b, {}, wanted), formula.cnf().size());
    RunControl control({});
    const SatResult result = solve_sat(formula.cnf(), {}, {}, control);
    ASSERT_EQ(result.outcome, *exists ? Outcome::found : Outcome::none);
    const auto is_true = [&](Literal x) { return result.is_true(x); };
    if (*exists) {
      expect_wanted(formula.decode(is_true), formula.chosen_positions(is_true), b, wanted);
    }
    const auto add = [&](std::size_t i, bool is_wanted) {
      if (is_wanted) {
        ++(*exists ? counts[i].found : counts[i].none);
      }
    };
    add(0, !wanted.first.empty());
    add(1, !wanted.last.empty());
    add(2, !wanted.contained.empty());
    add(3, wanted.expansion_set);
    if (++decided % 7 == 0) {  // with its proof, in one part or in several
      const Decision decision = decide(p, b, {.cubes = decided % 2, .wanted = wanted}, control);
      ASSERT_EQ(decision.outcome, *exists ? Outcome::found : Outcome::none);
      ASSERT_EQ(decision.excluded(), !*exists);
      if (decision.design) {
        std::vector<std::size_t> positions;
        for (const UnchangedSubset& subset : decision.subsets) {
          positions.push_back(subset.position);
        }
        expect_wanted(*decision.design, positions, b, wanted);
      }
    }
  }

  std::size_t decided = 0;
  std::size_t undecided = 0;
  std::array<Counts, 4> counts = {};  // first, last, contained, expansion set

 private:
  static void expect_wanted(const Design& design, const std::vector<std::size_t>& positions,
                            std::uint64_t b, const Wanted& wanted) {
    ASSERT_EQ(design.block_count(), b);
    EXPECT_TRUE(test::naive_verdict(design).valid);
    std::vector<unsigned> list;
    for (const Block& block : design.blocks()) {
      list.push_back(mask_of(block));
    }
    const WantedCheck check(design.parameters(), wanted);
    EXPECT_TRUE(check.holds(list));
    if (wanted.expansion_set) {
      EXPECT_TRUE(check.are_parts(list, positions));
    } else {
      EXPECT_TRUE(positions.empty());
    }
  }
};

void hold_all(std::uint64_t draws, std::uint64_t seed, std::size_t at_least) {
  Random random(seed);
  AgainstOracle against;
  for (std::uint64_t k = 3; k <= 4; ++k) {
    for (std::uint64_t v = k + 1; v <= 6; ++v) {
      for (std::uint64_t change = 1; change <= 2; ++change) {
        for (const Kind kind : {Kind::linear, Kind::circular}) {
          for (const std::uint32_t strength : {2U, 3U}) {
            const Parameters p{v, k, change, kind, strength};
            if (impossibility(p) || (strength == 3 && (k == 3 || v == 6))) {
              continue;
            }
            const std::uint64_t least = lower_bound(p).blocks;
            for (std::uint64_t b = std::max<std::uint64_t>(1, least) - 1; b <= least + 4; ++b) {
              for (std::uint64_t i = 0; b > 0 && i < draws; ++i) {
                against.hold(p, b, draw(p, random));
                if (testing::Test::HasFatalFailure()) {
                  return;
                }
              }
            }
          }
        }
      }
    }
  }
  for (const Counts& each : against.counts) {
    EXPECT_GE(each.found, at_least);
    EXPECT_GE(each.none, at_least);
  }
  EXPECT_LT(against.undecided, against.decided / 20);
}

TEST(ExactWanted, FindsAListExactlyWhereOneOfAllListsHasWhatIsWanted) { hold_all(25, 1, 100); }

TEST(ExactWanted, HoldsForMoreDrawsSlow) { hold_all(150, 2, 600); }

// Renaming must leave alone what is wanted: all pairs of elements, in the first and in the last
// block, whichever order of columns would be required of them.
TEST(ExactWanted, EveryPairAtTheEndsIsDecidedAlike) {
  const Parameters p{6, 3, 1, Kind::linear, 2};
  AgainstOracle against;
  for (Element x = 0; x < 6; ++x) {
    for (Element y = x + 1; y < 6; ++y) {
      against.hold(p, 7, {.first = {x, y}, .last = {y, x}});
      against.hold(p, 7, {.first = {y}, .last = {x}});
      against.hold(p, 7, {.last = {y, x}, .expansion_set = true});
    }
  }
  EXPECT_EQ(against.undecided, 0U);
}

TEST(ExactWanted, OnlyElementsInTheSameSetsAreAlike) {
  const Parameters p{7, 3, 1, Kind::linear, 2};
  EXPECT_EQ(next_alike(p, {}), (std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(next_alike(p, {.first = {5, 1}, .last = {5, 2}}),
            (std::vector<std::uint64_t>{3, 7, 7, 4, 6, 7, 7}));
  EXPECT_EQ(next_alike(p, {.contained = {{0, 1, 2}, {1, 2, 3}}}),
            (std::vector<std::uint64_t>{7, 2, 7, 7, 5, 6, 7}));
  EXPECT_EQ(next_alike(p, {.first = {4, 0}, .expansion_set = true}),
            (std::vector<std::uint64_t>{4, 2, 3, 5, 7, 6, 7}));
}

// What is proved is said where the proof is, and in files of their own.
TEST(ExactWanted, ProofsSayWhatTheyExclude) {
  const Parameters p{6, 3, 1, Kind::linear, 2};
  const test::TemporaryFolder folder;
  RunControl control({});
  const Wanted ends{.first = {0, 1}, .last = {2, 0}};
  EXPECT_EQ(wanted_words(ends), " that begins with {0,1} and ends with {2,0}");
  Wanted all{.first = {4}, .last = {5}, .expansion_set = true, .contained = {{0, 1, 2}, {1, 2, 3}}};
  EXPECT_EQ(wanted_words(all),
            " that begins with {4}, ends with {5}, contains {0,1,2}, {1,2,3} one after another and "
            "has disjoint unchanged subsets that hold all other elements");
  EXPECT_EQ(wanted_words({.contained = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}}}, 2),
            " that contains {0,1,2}, {1,2,3} and 1 more one after another");
  EXPECT_EQ(wanted_words({.expansion_set = true}),
            " that has disjoint unchanged subsets that hold all elements");
  for (const Wanted& wanted : {Wanted{}, ends, all}) {
    const Decision none =
        decide(p, 6, {.proof_directory = folder.path().string(), .wanted = wanted}, control);
    ASSERT_TRUE(none.excluded());
    const std::string cnf = test::slurp(none.parts.front().cnf_path);
    EXPECT_THAT(cnf, HasSubstr("c There is a linear SCCD(6,3) with 6 blocks" +
                               wanted_words(wanted) + ".\n"));
    EXPECT_EQ(none.parts.front().cnf_path, folder.file(file_stem(p, 6, wanted) + ".cnf"));
    EXPECT_EQ(cnf.find("partition") != std::string::npos, wanted.expansion_set);
    EXPECT_EQ(cnf.find("given blocks begin") != std::string::npos, !wanted.contained.empty());
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 6);
  EXPECT_EQ(file_stem(p, 6), "linear-m1-v6-k3-b6");
  EXPECT_THAT(file_stem(p, 6, ends), testing::MatchesRegex("linear-m1-v6-k3-b6-with-[0-9a-f]+"));
}

// The fewest blocks with what is wanted, which can be more than the minimum.
TEST(ExactWanted, FindsTheFewestBlocks) {
  std::size_t more = 0;
  Random random(7);
  for (const Parameters& p :
       {Parameters{6, 3, 1, Kind::linear, 2}, Parameters{6, 4, 2, Kind::linear, 2},
        Parameters{5, 3, 1, Kind::circular, 2}, Parameters{6, 3, 2, Kind::circular, 2}}) {
    RunControl control({});
    const std::uint64_t minimum = find_minimum(p, {}, control).lower;
    for (int i = 0; i < 12; ++i) {
      const Wanted wanted = draw(p, random);
      SCOPED_TRACE(name(p) + wanted_words(wanted));
      for (const bool from_known : {true, false}) {
        MinimumOptions options;
        options.exact.wanted = wanted;
        options.from_known = from_known;
        const MinimumResult result = find_minimum(p, options, control);
        ASSERT_TRUE(result.settled());
        EXPECT_FALSE(result.known && !from_known);
        EXPECT_TRUE(WantedOracle(p, wanted).exists(result.lower, 10'000'000).value());
        for (std::uint64_t b = minimum; b < result.lower; ++b) {
          EXPECT_FALSE(WantedOracle(p, wanted).exists(b, 10'000'000).value());
        }
        more += result.lower > minimum ? 1U : 0U;
      }
    }
  }
  EXPECT_GT(more, 5U);
}

TEST(ExactWanted, BeginsWithADesignThatIsKnown) {
  MinimumOptions options;
  options.exact.wanted = {.first = {7, 3, 19, 11}, .expansion_set = true};
  RunControl control({});
  const MinimumResult result = find_minimum({20, 5, 1, Kind::linear, 2}, options, control);
  EXPECT_TRUE(result.known);
  EXPECT_EQ(result.lower, 46U);
  EXPECT_EQ(result.subsets.size(), 4U);
  ASSERT_TRUE(result.best);
  EXPECT_TRUE(test::naive_verdict(*result.best).valid);
}

TEST(ExactWanted, RefusesWhatHasNoMeaning) {
  RunControl control({});
  const Parameters p{6, 3, 1, Kind::linear, 2};
  EXPECT_THAT(message_of([&] { (void)decide(p, 7, {.wanted = {.first = {6}}}, control); }),
              HasSubstr("element 6 does not exist; elements are 0 to 5"));
  MinimumOptions options;
  options.exact.wanted = {.first = {0}};
  EXPECT_THAT(message_of([&] {
                (void)find_minimum({3, 3, 1, Kind::linear, 2}, options, control);
              }),
              HasSubstr("v = k = 3: one block holds all elements"));
  const Design known = find_minimum(p, {}, control).best->design();
  EXPECT_THAT(message_of([&] { (void)find_minimum(p, options, control, known); }),
              HasSubstr("cannot start from a given design"));
}

}  // namespace
}  // namespace changeover::exact_wanted_test
