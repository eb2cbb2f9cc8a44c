// The verifier and checkdesign share no code: they must say the same of every design and every mutation.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "changeover/construct/registry.hpp"
#include "changeover/io/sink.hpp"
#include "changeover/io/text.hpp"
#include "changeover/verify/verdict.hpp"
#include "run_program.hpp"

namespace changeover::test {
namespace {

using List = std::vector<Block>;

List blocks_of(const Design& design) {
  List blocks;
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    blocks.emplace_back(design.block(i).begin(), design.block(i).end());
  }
  return blocks;
}

/// Designs whose verdict is to be compared, checked by one shell with many runs of checkdesign.
class Comparison {
 public:
  void add(const Design& design, const std::string& what) {
    StringSink sink;
    write_text(design, sink);
    spit(folder_.file(std::to_string(expected_.size())), sink.text());
    expected_.push_back(verify(design).valid());
    what_.push_back(what);
  }

  void expect_agreement() const {
    const Outcome outcome = run("for ((i = 0; i < " + std::to_string(expected_.size()) +
                                    "; ++i)); do $checkdesign $i | head -n 1; done",
                                folder_.path());
    std::istringstream lines(outcome.out);
    std::string line;
    for (std::size_t i = 0; i < expected_.size(); ++i) {
      ASSERT_TRUE(std::getline(lines, line)) << outcome.err;
      EXPECT_EQ(line == "valid", expected_[i]) << what_[i] << ": checkdesign says " << line;
    }
  }

  [[nodiscard]] std::size_t size() const { return expected_.size(); }
  [[nodiscard]] std::size_t valid() const {
    return static_cast<std::size_t>(std::count(expected_.begin(), expected_.end(), true));
  }

 private:
  TemporaryFolder folder_;
  std::vector<bool> expected_;
  std::vector<std::string> what_;
};

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
  EXPECT_EQ(comparison.valid(), comparison.size());
  comparison.expect_agreement();
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
  EXPECT_EQ(comparison.valid(), comparison.size());
  comparison.expect_agreement();
}

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
    const List blocks = blocks_of(registry.build_design(offer->recipe));
    for (int round = 0; round < 25; ++round) {
      const std::size_t i = random() % blocks.size();
      const std::size_t j = random() % blocks.size();
      List dropped = blocks;
      dropped.erase(dropped.begin() + static_cast<std::ptrdiff_t>(i));
      comparison.add(Design(p, dropped), name(p) + " without block " + std::to_string(i + 1));
      List swapped = blocks;
      std::swap(swapped[i], swapped[j]);
      comparison.add(Design(p, swapped), name(p) + " with two blocks swapped");
      List changed = blocks;
      const auto x = static_cast<Element>(random() % p.v);
      if (std::find(changed[i].begin(), changed[i].end(), x) == changed[i].end()) {
        changed[i][random() % p.k] = x;
        comparison.add(Design(p, changed), name(p) + " with an element changed");
      }
      List broken = blocks;  // the link: the last block repeated at the front breaks one step
      std::rotate(broken.begin(),
                  broken.begin() + 1 + static_cast<std::ptrdiff_t>(i % (blocks.size() - 1)),
                  broken.end());
      Design linear(p, broken);
      comparison.add(linear, name(p) + " rotated");
    }
  }
  EXPECT_LT(comparison.valid(), comparison.size());
  comparison.expect_agreement();
}

}  // namespace
}  // namespace changeover::test
