// Lists of fans, and their verdict held against that of reading every block.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/verify/fans.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover::test {

struct OwnFan {
  Block kept;
  Element first = 0;
  Element last = 0;
};

class Listed final : public FanSource {
 public:
  Listed(const Parameters& p, std::vector<OwnFan> fans) : p_(p), fans_(std::move(fans)) {}

  [[nodiscard]] const Parameters& parameters() const override { return p_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    std::uint64_t b = 0;
    for (const OwnFan& fan : fans_) {
      b += fan.last - fan.first + 1;
    }
    return b;
  }
  std::optional<Fan> next() override {
    if (at_ == fans_.size()) {
      return std::nullopt;
    }
    const OwnFan& fan = fans_[at_++];
    return Fan{fan.kept, fan.first, fan.last};
  }
  bool rewind() override {
    at_ = 0;
    return true;
  }

 private:
  Parameters p_;
  std::vector<OwnFan> fans_;
  std::size_t at_ = 0;
};

inline std::vector<Block> written_out(FanSource& fans) {
  std::vector<Block> blocks;
  while (const auto fan = fans.next()) {
    for (Element x = fan->first; x <= fan->last; ++x) {
      blocks.emplace_back(fan->kept.begin(), fan->kept.end()).push_back(x);
    }
  }
  fans.rewind();
  return blocks;
}

// The same by reading every block.
inline void expect_as_read(FanSource& fans) {
  const Parameters p = fans.parameters();
  const Verdict read = verify(Design(p, written_out(fans)));
  const FanVerdict found = verify_fans(fans);
  EXPECT_EQ(found.b, read.b);
  EXPECT_EQ(found.bad_steps, read.bad_steps);
  EXPECT_EQ(found.uncovered, read.uncovered);
  EXPECT_EQ(found.never_newly_covered, read.never_newly_covered);
  EXPECT_EQ(found.excess, read.excess);
  EXPECT_EQ(found.counting_bound, read.counting_bound);
  EXPECT_EQ(found.valid(), read.valid());
  EXPECT_EQ(found.tight(), read.tight());
  EXPECT_EQ(found.economical(), read.economical());
  EXPECT_EQ(found.first_bad_step.has_value(), !read.bad_step_examples.empty());
  if (found.first_bad_step) {
    EXPECT_EQ(*found.first_bad_step, read.bad_step_examples.front().from);
  }
  EXPECT_EQ(found.uncovered_examples.size(),
            std::min<std::uint64_t>(read.uncovered, FanVerdict::most_examples));
  for (const auto& [x, y] : found.uncovered_examples) {
    EXPECT_LT(x, y);
    for (const Block& block : written_out(fans)) {
      EXPECT_FALSE(std::ranges::count(block, x) > 0 && std::ranges::count(block, y) > 0);
    }
  }
}

}  // namespace changeover::test
