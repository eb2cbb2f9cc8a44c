// Hold k − m elements, let all others pass through the m free places, drop what was held, repeat on
// the rest: the general fallback, for any v, k and m < k. For m = 2 the others pass by the edges of
// a 1-factor.
//
// With R the elements whose pairs are not all covered, r = |R|: a round holds H ⊂ R, |H| = k − m,
// and has the blocks H ∪ g for groups g of m elements that hold all of R ∖ H. It covers every pair
// that meets H. The next round works on R ∖ H and starts from the last group; the way there is a
// shortest one (construct/tools/path.hpp). When r ≤ k one block holds R. A linear design may
// instead end with any design of the last R ∖ H, renamed so that its first block holds the last
// group.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "bounds/counting_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "construct/entry.hpp"
#include "construct/tools/path.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover::hold_and_stream_entry {
namespace {

/// The rounds one after another, each a held set with its groups, and the ways between them.
class HoldAndStreamSource final : public BlockByBlock<HoldAndStreamSource> {
 public:
  /// `tail` is a design of v − rounds·(k−m) elements, or nullptr with `rounds` ignored: to the end.
  HoldAndStreamSource(const Parameters& p, std::uint64_t b, std::uint64_t rounds,
                      std::unique_ptr<BlockSource> tail)
      : p_(p),
        b_(b),
        rounds_(rounds),
        tail_(std::move(tail)),
        distances_(std::make_shared<const Distances>(p.k, p.change, p.v)) {
    begin();
  }

  [[nodiscard]] const Parameters& parameters() const override { return p_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override { return b_; }

  bool make(std::span<Element> block) {
    while (legs_.empty()) {
      if (group_ < groups_) {
        last_ = round_block(group_++);
        std::ranges::copy(last_, block.begin());
        return true;
      }
      if (!advance(block)) {
        return false;
      }
      if (in_tail_ && legs_.empty()) {  // advance() wrote a block of the tail
        return true;
      }
    }
    Leg& leg = legs_.front();
    if (!way_ && leg.from) {
      way_.emplace(distances_, *std::exchange(leg.from, std::nullopt), leg.to);
    }
    if (way_ && way_->next(block)) {
      return true;
    }
    way_.reset();
    const Leg done = std::move(leg);
    legs_.pop_front();
    if (!done.arrives) {
      return make(block);
    }
    last_ = done.to;
    std::ranges::copy(last_, block.begin());
    return true;
  }

  /// The number of blocks, and those of the first 1, 2, … rounds, when there is no tail. No block
  /// is made but the first and the last of each round: O(k log k) a round.
  struct Count {
    std::uint64_t total = 0;
    std::vector<std::uint64_t> after_round;
  };
  [[nodiscard]] Count count() {
    begin();
    Count count;
    count.total = groups_;
    last_ = round_block(groups_ - 1);
    while (true) {
      stop_if_asked();
      count.after_round.push_back(count.total);
      advance({});
      for (const Leg& leg : legs_) {
        count.total += steps(*leg.from, leg.to) - (leg.arrives ? 0 : 1);
        last_ = leg.to;
      }
      legs_.clear();
      if (finished_) {
        break;
      }
      count.total += groups_ - 1;  // the way led to the first block of the round
      last_ = round_block(groups_ - 1);
    }
    begin();
    return count;
  }

  bool rewind() override {
    if (tail_ && !tail_->rewind()) {
      return false;
    }
    begin();
    return true;
  }

 private:
  /// A shortest way between two blocks, without the first; the last is left out too unless it
  /// `arrives`.
  struct Leg {
    std::optional<Block> from;  // nothing once the way was begun
    Block to;
    bool arrives = true;
  };

  [[nodiscard]] std::size_t held() const { return static_cast<std::size_t>(p_.k - p_.change); }

  [[nodiscard]] std::uint64_t steps(const Block& from, const Block& to) const {
    const auto steps = distances_->steps(difference(from, to).size());
    if (!steps || *steps == 0) {
      throw InternalError("hold-and-stream: no way to the next round");
    }
    return *steps;
  }

  void begin() {
    rest_.resize(static_cast<std::size_t>(p_.v));
    std::iota(rest_.begin(), rest_.end(), 0U);
    round_ = 0;
    in_tail_ = finished_ = false;
    legs_.clear();
    way_.reset();
    start_round();
    first_ = round_block(0);
  }

  // rest_ is R: the held elements first, then the groups in order.
  void start_round() {
    groups_ = ceil_div(rest_.size() - held(), p_.change);
    group_ = 0;
  }

  [[nodiscard]] Block round_block(std::uint64_t group) const {
    const std::size_t h = held();
    const auto m = static_cast<std::size_t>(p_.change);
    Block block(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(h));
    const std::size_t start = h + static_cast<std::size_t>(group) * m;
    const std::size_t end = std::min(start + m, rest_.size());
    block.insert(block.end(), rest_.begin() + static_cast<std::ptrdiff_t>(start),
                 rest_.begin() + static_cast<std::ptrdiff_t>(end));
    // A last group that is not full takes elements that are not in the group before it.
    const std::size_t before = start >= m ? start - m : 0;
    for (std::size_t i = h; block.size() < p_.k && i < before; ++i) {
      block.push_back(rest_[i]);
    }
    for (Element x = 0; block.size() < p_.k; ++x) {
      const auto from = rest_.begin() + static_cast<std::ptrdiff_t>(before);
      if (std::ranges::find(block, x) == block.end() &&
          std::find(from, rest_.end(), x) == rest_.end()) {
        block.push_back(x);
      }
    }
    return block;
  }

  void go_to(Block block) { legs_.push_back({last_, std::move(block), true}); }

  // What comes after a round: legs, or in the tail a block, written to `block`; false at the end.
  bool advance(std::span<Element> block) {
    if (finished_) {
      return false;
    }
    if (in_tail_) {
      if (!tail_->next(block)) {
        return false;
      }
      for (Element& x : block) {
        x = renamed_[x];
      }
      return true;
    }
    // The last block has in common with the next R its last group and what that was filled up with
    // from the front. These elements come first in the next R. Everything happens at the ends of
    // rest_.
    const auto first = rest_.begin();
    const Block dropped(first, first + static_cast<std::ptrdiff_t>(held()));
    rest_.erase(first, first + static_cast<std::ptrdiff_t>(held()));
    const std::size_t last_group =
        rest_.size() - static_cast<std::size_t>((groups_ - 1) * p_.change);
    const std::size_t filled =
        groups_ < 2 ? std::size_t{0}
                    : std::min<std::size_t>(static_cast<std::size_t>(p_.change) - last_group,
                                            static_cast<std::size_t>((groups_ - 2) * p_.change));
    const auto group = rest_.end() - static_cast<std::ptrdiff_t>(last_group);
    Block kept(group, rest_.end());
    kept.insert(kept.end(), rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(filled));
    rest_.erase(group, rest_.end());
    rest_.erase(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(filled));
    ++round_;
    if (tail_ && round_ == rounds_) {
      rest_.insert(rest_.begin(), kept.begin(), kept.end());
      start_tail();
    } else if (rest_.size() + kept.size() <= p_.k) {
      rest_.insert(rest_.begin(), kept.begin(), kept.end());
      finish(kept.size(), dropped);
    } else {
      // The last group becomes the first one; those to be held stand before it.
      const auto end = rest_.begin() + static_cast<std::ptrdiff_t>(held());
      Block front(rest_.begin(), end);
      rest_.erase(rest_.begin(), end);
      front.insert(front.end(), kept.begin(), kept.end());
      rest_.insert(rest_.begin(), front.begin(), front.end());
      start_round();
      go_to(round_block(0));
      group_ = 1;
    }
    return true;
  }

  void start_tail() {
    // The first block of the tail gets the elements at the front of rest_, the last group among
    // them.
    Block first(static_cast<std::size_t>(p_.k));
    if (!tail_->next(first)) {
      throw InternalError("hold-and-stream: the design at the end has no blocks");
    }
    renamed_.assign(rest_.size(), 0);
    std::vector<bool> used(rest_.size(), false);
    std::size_t at = 0;
    for (const Element x : first) {
      renamed_[x] = rest_[at++];
      used[x] = true;
    }
    for (std::size_t x = 0; x < renamed_.size(); ++x) {
      if (!used[x]) {
        renamed_[x] = rest_[at++];
      }
    }
    for (Element& x : first) {
      x = renamed_[x];
    }
    in_tail_ = true;
    go_to(std::move(first));
  }

  // One block for what is left, and the way back in a circular design.
  void finish(std::size_t kept, const Block& dropped) {
    finished_ = true;
    if (rest_.size() > kept) {
      Block block(rest_.begin(), rest_.end());
      // Fill with what is in the last block, unless less than m elements would change then.
      const std::size_t fresh = rest_.size() - kept;
      const auto missing = static_cast<std::size_t>(p_.change) > fresh
                               ? static_cast<std::size_t>(p_.change) - fresh
                               : std::size_t{0};
      std::vector<bool> taken(static_cast<std::size_t>(p_.v), false);
      for (const Element x : rest_) {
        taken[x] = true;
      }
      for (const Element x : last_) {
        taken[x] = true;
      }
      const std::size_t from_outside =
          std::min(missing, static_cast<std::size_t>(p_.k) - block.size());
      for (Element x = 0; x < p_.v && block.size() < rest_.size() + from_outside; ++x) {
        if (!taken[x]) {
          block.push_back(x);
        }
      }
      for (std::size_t i = 0; block.size() < p_.k && i < dropped.size(); ++i) {
        block.push_back(dropped[i]);
      }
      std::vector<bool> in_block(static_cast<std::size_t>(p_.v), false);
      for (const Element x : block) {
        in_block[x] = true;
      }
      for (const Element x : last_) {  // a padded last group
        if (block.size() < p_.k && !in_block[x]) {
          block.push_back(x);
        }
      }
      go_to(std::move(block));
    }
    if (p_.kind == Kind::circular) {
      Block end = legs_.empty() ? last_ : legs_.back().to;
      legs_.push_back({std::move(end), first_, false});
    }
  }

  Parameters p_;
  std::uint64_t b_;
  std::uint64_t rounds_;
  std::unique_ptr<BlockSource> tail_;
  std::shared_ptr<const Distances> distances_;
  std::deque<Element> rest_;  // R, those held first
  Block first_;               // the first block of all
  Block last_;                // the last block of a round, or the end of a leg
  std::deque<Leg> legs_;
  std::optional<Way> way_;  // of the first leg, once it was begun
  std::uint64_t groups_ = 0;
  std::uint64_t group_ = 0;
  std::uint64_t round_ = 0;
  Block renamed_;  // of the tail's elements
  bool in_tail_ = false;
  bool finished_ = false;
};

constexpr Description description{
    .name = "hold-and-stream",
    .summary = "hold k - m elements, let the others pass in groups of m, repeat on the rest",
    .preconditions = "m < k, k + m <= v <= 20000, v^2 / (k - m) <= 2^27",
    .guarantee = "always there; for m = 1 about 5 to 21 % over the counting bound",
};

class HoldAndStream final : public Described<Entry, description> {
 public:
  bool asks_registry() const override { return true; }

  std::optional<Offer> offer(const Parameters& p, const Registry& registry) const override {
    if (!serves(p)) {
      return std::nullopt;
    }
    const HoldAndStreamSource::Count count = HoldAndStreamSource(p, 0, 0, nullptr).count();
    Offer best{recipe_of(p), count.total, false, false, false};
    if (p.kind == Kind::linear) {
      // After each round, any design of what is left may follow.
      Parameters rest = p;
      for (std::size_t i = 0; i < count.after_round.size() && i < most_rounds; ++i) {
        stop_if_asked();
        rest.v -= p.k - p.change;
        if (rest.v < p.k + p.change) {
          break;
        }
        const std::uint64_t before = count.after_round[i] + steps_to_tail(p, i) - 1;
        if (before + counting_bound(rest) >= best.b) {
          continue;  // finding a design for the rest is slow, and could gain nothing
        }
        const std::optional<Offer> tail = best_leaf(rest, registry);
        if (tail && before + tail->b < best.b) {
          best.b = before + tail->b;
          best.recipe.arguments = {{"rounds", static_cast<std::int64_t>(i + 1)}};
          best.recipe.inputs = {tail->recipe};
        }
      }
    }
    best.recipe.arguments["blocks"] = static_cast<std::int64_t>(best.b);
    best.economical = best.b == counting_bound(p);
    return best;
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const Parameters& p = recipe.parameters;
    if (!serves(p) || recipe.inputs.size() > 1) {
      require_recipe(recipe, *this, std::nullopt);
    }
    const HoldAndStreamSource::Count count = HoldAndStreamSource(p, 0, 0, nullptr).count();
    Recipe expected = recipe_of(p);
    std::uint64_t b = count.total;
    std::uint64_t rounds = 0;
    std::unique_ptr<BlockSource> tail;
    if (!recipe.inputs.empty()) {
      const auto given = recipe.arguments.find("rounds");
      const Recipe& input = recipe.inputs.front();
      Parameters rest = p;
      rounds = given == recipe.arguments.end() || given->second < 1
                   ? 0
                   : static_cast<std::uint64_t>(given->second);
      if (p.kind != Kind::linear || rounds < 1 || rounds > count.after_round.size() ||
          rounds * (p.k - p.change) + p.k > p.v) {
        throw BadInput(
            fmt::format("hold-and-stream for {}: no design can follow after {}; use "
                        "another number of rounds",
                        changeover::name(p), count_of(rounds, "round")));
      }
      rest.v -= rounds * (p.k - p.change);
      if (input.parameters != rest) {
        throw BadInput(
            fmt::format("hold-and-stream for {}: after {} a {} follows, not a {}; "
                        "correct the input",
                        changeover::name(p), count_of(rounds, "round"), changeover::name(rest),
                        changeover::name(input.parameters)));
      }
      tail = registry.build(input);
      const std::optional<std::uint64_t> blocks = tail->block_count();
      if (!blocks || *blocks == 0) {
        throw BadInput("hold-and-stream: the design at the end must know its number of blocks");
      }
      b = count.after_round[static_cast<std::size_t>(rounds) - 1] +
          steps_to_tail(p, static_cast<std::size_t>(rounds) - 1) - 1 + *blocks;
      expected.arguments["rounds"] = static_cast<std::int64_t>(rounds);
      expected.inputs = recipe.inputs;
    }
    expected.arguments["blocks"] = static_cast<std::int64_t>(b);
    require_recipe(recipe, *this, expected);
    return std::make_unique<HoldAndStreamSource>(p, b, rounds, std::move(tail));
  }

  std::string explain(const Recipe& recipe) const override {
    const Parameters& p = recipe.parameters;
    const std::uint64_t h = p.k - p.change;
    std::string text = fmt::format("Hold {} of {} elements while the others pass in groups of {}; ",
                                   h, p.v, p.change);
    if (recipe.inputs.empty()) {
      return text + "drop those held and repeat on the rest, to the end.";
    }
    return text + fmt::format("after {} end with the {}, renamed.",
                              count_of(static_cast<std::uint64_t>(recipe.arguments.at("rounds")),
                                       "such round"),
                              changeover::name(recipe.inputs.front().parameters));
  }

 private:
  static constexpr std::size_t most_rounds = 256;  // after which a tail is looked for
  // An offer makes two blocks of each round, v²/(k−m) elements in all.
  static constexpr std::uint64_t largest_v = 20'000;
  static constexpr std::uint64_t most_work = std::uint64_t{1} << 27;

  static bool serves(const Parameters& p) {
    return asks_for_pairs(p, p.change) && p.change < p.k && p.v >= p.k + p.change &&
           p.v <= largest_v && p.v * p.v / (p.k - p.change) <= most_work;
  }

  // From the last group of a round to a block of the rest that holds that group. A last group that
  // was not full has fewer elements in common with the rest.
  static std::uint64_t steps_to_tail(const Parameters& p, std::size_t round) {
    const std::uint64_t h = p.k - p.change;
    const std::uint64_t passing = p.v - (round + 1) * h;
    const std::uint64_t last = passing % p.change == 0 ? p.change : passing % p.change;
    // A group is filled up from the groups before it when there are two or more of them.
    const std::uint64_t common =
        last == p.change || passing >= 2 * p.change + last ? p.change : last;
    const auto steps = connecting_steps(p.k - common, p.k, p.change, p.v);
    if (!steps) {
      throw InternalError("hold-and-stream: no way to the next round");
    }
    return *steps;
  }
};

}  // namespace

const Construction& construction() { return only<HoldAndStream>(); }

}  // namespace changeover::hold_and_stream_entry
