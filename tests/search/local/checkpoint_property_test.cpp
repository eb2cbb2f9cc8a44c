// Checkpoints at random: read as they were written; damaged, refused; damaged by a program that
// makes
// the checksum right, refused or such a state as a search can have.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>

#include "changeover/construct/registry.hpp"
#include "changeover/verify/verdict.hpp"
#include "damage.hpp"
#include "run_program.hpp"
#include "search/local/checkpoint.hpp"

namespace changeover::checkpoint_property_test {
namespace {

using test::Damage;
using test::some_number;

SearchArm some_arm(const Parameters& p) {
  SearchArm arm{.method = *rc::gen::element(SearchArm::Method::free, SearchArm::Method::reheated,
                                            SearchArm::Method::imposed, SearchArm::Method::cold),
                .budget = 1 + some_number(SearchArm::most_moves - 1),
                .spent = some_number(SearchArm::most_moves),
                .step = some_number(SearchArm::most_step),
                .missed = some_number(SearchArm::most_missed)};
  if (arm.method == SearchArm::Method::imposed) {
    arm.extra = some_number(SearchArm::most_extra);
    arm.fixed = static_cast<std::uint32_t>(some_number(SearchArm::most_fixed));
    arm.order = static_cast<std::uint32_t>(2 + some_number(p.v));
    if (arm.order > p.v + arm.extra || !arm.automorphism(p.v)) {
      arm = {.method = SearchArm::Method::free, .budget = 1};
    }
  }
  return arm;
}

Checkpoint some_checkpoint() {
  Checkpoint checkpoint;
  Parameters& p = checkpoint.parameters;
  p = *rc::gen::elementOf(std::vector<Parameters>{
      {.v = 6, .k = 4, .change = 2, .kind = Kind::circular},
      {.v = 9, .k = 3, .change = 1},
      {.v = 11, .k = 4, .change = 2},
      {.v = 7, .k = 5, .change = 2, .kind = Kind::circular, .strength = 3}});
  checkpoint.seed = *rc::gen::arbitrary<std::uint64_t>();
  checkpoint.attempts = some_number(SearchArm::most_moves);
  checkpoint.moves = some_number(SearchArm::most_moves);
  for (std::uint64_t arms = some_number(4); arms > 0; --arms) {
    checkpoint.arms.push_back(some_arm(p));
  }
  checkpoint.how = test::some_text({"blocks", " ", "order 7", ",", "check ", "~"}, 5);
  const auto offers = Registry::standard().offers(p);
  if (!offers.empty() && some_number(3) > 0) {
    checkpoint.best =
        verified(Registry::standard().build_design((*rc::gen::elementOf(offers)).recipe));
    RC_ASSERT(checkpoint.best.has_value());
  }
  return checkpoint;
}

void expect_equal(const Checkpoint& a, const Checkpoint& b) {
  RC_ASSERT(a.parameters == b.parameters);
  RC_ASSERT(a.seed == b.seed);
  RC_ASSERT(a.attempts == b.attempts);
  RC_ASSERT(a.moves == b.moves);
  RC_ASSERT((a.arms == b.arms));
  RC_ASSERT(a.how == b.how);
  RC_ASSERT(a.best.has_value() == b.best.has_value());
  RC_ASSERT((!a.best || a.best->blocks() == b.best->blocks()));
}

// A file that is put there and read again.
class State {
 public:
  State() { std::filesystem::remove(path()); }
  [[nodiscard]] static std::string path() {
    static const test::TemporaryFolder folder;
    return folder.file("state");
  }
  [[nodiscard]] static std::string text() { return test::slurp(path()); }
  static void put(const std::string& text) {
    std::filesystem::remove(path());
    test::spit(path(), text);
  }
};

std::uint64_t fnv1a(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : text) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
  }
  return hash;
}

std::string with_check(const std::string& text) {
  return text + fmt::format("check {:016x}\n", fnv1a(text));
}

// The file as the format says, but for its last line.
std::string written(const Checkpoint& checkpoint) {
  const Parameters& p = checkpoint.parameters;
  std::string text = fmt::format(
      "changeover-checkpoint 1\n# changeover design v={} k={} change={} kind={}{}\nseed {}\n"
      "attempts {}\nmoves {}\n",
      p.v, p.k, p.change, to_string(p.kind), p.strength == 2 ? "" : " strength=3", checkpoint.seed,
      checkpoint.attempts, checkpoint.moves);
  for (const SearchArm& arm : checkpoint.arms) {
    text += fmt::format("arm {} {} {} {} {} {} {} {}\n", static_cast<int>(arm.method), arm.order,
                        arm.fixed, arm.extra, arm.budget, arm.spent, arm.step, arm.missed);
  }
  text += checkpoint.how.empty() ? "" : "how " + checkpoint.how + "\n";
  for (std::size_t i = 0; checkpoint.best && i < checkpoint.best->block_count(); ++i) {
    text += fmt::format("block {}\n", fmt::join(checkpoint.best->block(i), " "));
  }
  return text;
}

RC_GTEST_PROP(CheckpointsProperty, AreReadAsTheyWereWritten, ()) {
  const State state;
  const Checkpoint checkpoint = some_checkpoint();
  write_checkpoint(checkpoint, State::path());
  RC_ASSERT(State::text() == with_check(written(checkpoint)));
  const auto read = read_checkpoint(State::path(), checkpoint.parameters);
  RC_ASSERT(read.has_value());
  expect_equal(*read, checkpoint);
}

RC_GTEST_PROP(CheckpointsProperty, DamagedTheyAreRefused, (const std::vector<Damage>& damages)) {
  const State state;
  const Checkpoint checkpoint = some_checkpoint();
  const std::string good = with_check(written(checkpoint));
  for (std::size_t i = 0; i < damages.size() && i < 5; ++i) {
    const std::string bad = damages[i].of(good);
    if (bad != good) {
      State::put(bad);
      RC_ASSERT_FALSE(test::accepted(State::path(), [&] {
        static_cast<void>(read_checkpoint(State::path(), checkpoint.parameters));
      }));
      RC_ASSERT(State::text() == bad);
    }
  }
}

RC_GTEST_PROP(CheckpointsProperty, WithARightChecksumTheyAreRefusedOrStatesOfASearch,
              (const std::vector<Damage>& damages)) {
  const State state;
  const Checkpoint checkpoint = some_checkpoint();
  const Parameters& p = checkpoint.parameters;
  const std::string good = written(checkpoint);
  for (std::size_t i = 0; i < damages.size() && i < 5; ++i) {
    std::string bad = damages[i].of(good);
    bad += bad.ends_with('\n') ? "" : "\n";
    State::put(with_check(bad));
    std::optional<Checkpoint> read;
    if (!test::accepted(State::path(), [&] { read = read_checkpoint(State::path(), p); })) {
      continue;
    }
    RC_ASSERT(read.has_value());
    RC_ASSERT((!read->best || verify(read->best->design()).valid()));
    for (const SearchArm& arm : read->arms) {
      const bool imposed = arm.method == SearchArm::Method::imposed;
      RC_ASSERT((imposed ? arm.automorphism(p.v).has_value()
                         : arm.order == 0 && arm.fixed == 0 && arm.extra == 0));
    }
    State::put(with_check(written(*read)));
    const auto again = read_checkpoint(State::path(), p);
    RC_ASSERT(again.has_value());
    expect_equal(*again, *read);
  }
}

}  // namespace
}  // namespace changeover::checkpoint_property_test
