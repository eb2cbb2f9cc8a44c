// The verifier and checkdesign share no code: they must say the same of every design and every
// mutation.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <sstream>

#include "changeover/construct/registry.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/io/output.hpp"
#include "changeover/verify/verdict.hpp"
#include "run_program.hpp"

namespace changeover::test::both_checkers_test {
namespace {

using List = std::vector<Block>;

/// Designs whose verdict is to be compared, checked by one shell with many runs of checkdesign.
class Comparison {
 public:
  /// How many designs of a class there are, and how many each checker rejects.
  struct Count {
    int designs = 0;
    int by_verifier = 0;
    int by_checkdesign = 0;

    bool operator==(const Count&) const = default;
  };

  void add(const Design& design, const std::string& what, const std::string& mutation = "") {
    StringSink sink;
    write_text(design, sink);
    spit(folder_.file(std::to_string(added_.size())), sink.text());
    added_.push_back({what, mutation, verify(design).valid()});
  }

  /// Runs checkdesign and expects it to agree. @return the counts of each mutation.
  [[nodiscard]] std::map<std::string, Count> expect_agreement() const {
    const Outcome outcome =
        run("for ((i = 0; i < " + std::to_string(added_.size()) +
                "; ++i)); do said=$($checkdesign $i); echo \"${said%%$'\\n'*}\"; done",
            folder_.path());
    std::istringstream lines(outcome.out);
    std::map<std::string, Count> counts;
    for (const Added& added : added_) {
      std::string line;
      EXPECT_TRUE(std::getline(lines, line)) << outcome.err;
      EXPECT_TRUE(line == "valid" || line == "invalid") << added.what << ": " << line;
      EXPECT_EQ(line == "valid", added.valid) << added.what << ": checkdesign says " << line;
      Count& count = counts[added.mutation];
      ++count.designs;
      count.by_verifier += added.valid ? 0 : 1;
      count.by_checkdesign += line == "valid" ? 0 : 1;
    }
    return counts;
  }

  /// The same where there is nothing to reject.
  void expect_all_accepted() const {
    const int size = static_cast<int>(added_.size());
    EXPECT_EQ(expect_agreement(), (std::map<std::string, Count>{{"", {size, 0, 0}}}));
  }

  [[nodiscard]] std::size_t size() const { return added_.size(); }

 private:
  struct Added {
    std::string what;
    std::string mutation;
    bool valid;
  };

  TemporaryFolder folder_;
  std::vector<Added> added_;
};

void PrintTo(const Comparison::Count& count, std::ostream* out) {
  *out << count.by_verifier << " and " << count.by_checkdesign << " of " << count.designs;
}

TEST(BothCheckers, AcceptEveryOfferOfEveryConstruction) {
  const Registry& registry = Registry::standard();
  Comparison comparison;
  for (std::uint64_t m = 1; m <= 3; ++m) {
    for (std::uint64_t k = std::max<std::uint64_t>(2, m); k <= 7; ++k) {
      for (std::uint64_t v = k; v <= 26; v += 1 + v / 12) {
        for (const Kind kind : {Kind::circular, Kind::linear}) {
          for (const Offer& offer : registry.offers({.v = v, .k = k, .change = m, .kind = kind})) {
            comparison.add(registry.build_design(offer.recipe),
                           name(offer.recipe.parameters) + " by " + offer.recipe.construction);
          }
        }
      }
    }
  }
  EXPECT_GT(comparison.size(), 500U);
  comparison.expect_all_accepted();
}

TEST(BothCheckers, AcceptThePapersLargerDesigns) {
  const Registry& registry = Registry::standard();
  Comparison comparison;
  for (const auto& [v, k] : std::vector<std::pair<std::uint64_t, std::uint64_t>>{{61, 4},
                                                                                 {105, 9},
                                                                                 {77, 5},
                                                                                 {171, 11},
                                                                                 {63, 3},
                                                                                 {253, 13},
                                                                                 {78, 40},
                                                                                 {76, 39},
                                                                                 {75, 39}}) {
    const auto offer = registry.best({.v = v, .k = k, .kind = Kind::circular});
    ASSERT_TRUE(offer);
    comparison.add(registry.build_design(offer->recipe), name(offer->recipe.parameters));
  }
  comparison.expect_all_accepted();
}

// Mutations of minimum designs. Those that must break one are rejected always: a design with a
// block fewer than the minimum, with a step that changes nothing, with an element that is nowhere.
// Those that are read from another block on are designs, the linear ones too, which can be read as
// circular. Of the others it is known how many are no designs.
TEST(BothCheckers, RejectMutationsAtMarginOne) {
  const Registry& registry = Registry::standard();
  std::mt19937 random(5);
  Comparison comparison;
  for (const Parameters& p : {Parameters{.v = 11, .k = 4, .kind = Kind::circular},
                              Parameters{.v = 8, .k = 5, .kind = Kind::circular},
                              Parameters{.v = 15, .k = 3, .kind = Kind::linear},
                              Parameters{.v = 13, .k = 4, .change = 1, .kind = Kind::circular},
                              Parameters{.v = 9, .k = 5, .change = 1, .kind = Kind::linear}}) {
    const auto offer = registry.best(p);
    ASSERT_TRUE(offer);
    const List blocks = registry.build_design(offer->recipe).blocks();
    const auto add = [&](const std::string& mutation, List list, const Parameters& as) {
      comparison.add(Design(as, list), name(as) + ", " + mutation, mutation);
    };
    Parameters larger = p;
    ++larger.v;
    add("an element that is nowhere", blocks, larger);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const auto at = static_cast<std::ptrdiff_t>(i);
      List dropped = blocks;
      dropped.erase(dropped.begin() + at);
      add("a block dropped", dropped, p);
      List repeated = blocks;
      repeated.insert(repeated.begin() + at, blocks[i]);
      add("a block repeated", repeated, p);
      List turned = blocks;
      std::rotate(turned.begin(), turned.begin() + at, turned.end());
      add("rotated", turned, p);
    }
    for (int round = 0; round < 25; ++round) {
      const std::size_t i = random() % blocks.size();
      const std::size_t j = (i + 1 + random() % (blocks.size() - 1)) % blocks.size();
      List swapped = blocks;
      std::swap(swapped[i], swapped[j]);
      add("two blocks swapped", swapped, p);
      List changed = blocks;
      Element x = 0;
      do {
        x = static_cast<Element>(random() % p.v);
      } while (std::find(changed[i].begin(), changed[i].end(), x) != changed[i].end());
      changed[i][random() % p.k] = x;
      add("an element changed", changed, p);
    }
  }
  EXPECT_EQ(comparison.expect_agreement(), (std::map<std::string, Comparison::Count>{
                                               {"an element that is nowhere", {5, 5, 5}},
                                               {"a block dropped", {86, 86, 86}},
                                               {"a block repeated", {86, 86, 86}},
                                               {"rotated", {86, 0, 0}},
                                               {"two blocks swapped", {125, 115, 115}},
                                               {"an element changed", {125, 121, 121}},
                                           }));
}

}  // namespace
}  // namespace changeover::test::both_checkers_test
