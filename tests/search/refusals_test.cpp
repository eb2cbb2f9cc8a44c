// What callers of the library are told, and no request reaches: requests are checked before.
#include <gmock/gmock.h>

#include <functional>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "message_of.hpp"
#include "run/random.hpp"
#include "search/local/local_search_arms.hpp"
#include "search/local/segment_subsets.hpp"

namespace changeover::test::refusals_test {
namespace {

using ::testing::HasSubstr;

Design with(const Parameters& p, std::size_t blocks) {
  Design design(p);
  for (std::size_t i = 0; i < blocks; ++i) {
    design.append(i % 2 == 0 ? Block{0, 1, 2} : Block{0, 1, 3});
  }
  return design;
}

TEST(Refusals, SayWhatIsTooMuch) {
  Random random(1);
  RunControl control({.threads = 1});
  struct Case {
    std::function<void()> call;
    std::string words;
  };
  for (const auto& [call, words] : std::vector<Case>{
           {[] {
              (void)SegmentSubsets(with({2000, 3, 1, Kind::linear, 3}, 1));
            },
            "local search would need counters for 1331334000 subsets of 3 elements; at most "},
           {[&] {
              (void)anneal_blocks(with({4, 3, 1, Kind::linear, 2}, 70'000), 0, {}, random, control);
            },
            "local search supports elements in at most 65535 blocks each"}}) {
    EXPECT_THAT(message_of<Error>(call), HasSubstr(words));
  }
}

}  // namespace
}  // namespace changeover::test::refusals_test
