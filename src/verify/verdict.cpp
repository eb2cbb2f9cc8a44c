#include "changeover/verify/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "verify/element_bits.hpp"
#include "verify/own_count.hpp"
#include "verify/subset_set.hpp"

namespace changeover {
namespace {

/// Counts distinct sets of elements by a 128-bit sum of element hashes.
class SubsetHashes {
 public:
  void add(std::span<const Element> elements) {
    Hash hash{};
    for (const Element x : elements) {
      hash.first += mix(x);
      hash.second += mix(x + (std::uint64_t{1} << 32));
    }
    hashes_.push_back(hash);
  }

  [[nodiscard]] std::uint64_t distinct() {
    std::sort(hashes_.begin(), hashes_.end());
    return static_cast<std::uint64_t>(std::unique(hashes_.begin(), hashes_.end()) -
                                      hashes_.begin());
  }

 private:
  using Hash = std::pair<std::uint64_t, std::uint64_t>;

  // The finalizer of splitmix64: every bit of the result depends on every bit of x.
  static std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
  }

  std::vector<Hash> hashes_;
};

/// Takes the blocks in turn; templated on the set so that the pair case has no indirection.
template <typename Set>
class Verification {
 public:
  Verification(const Parameters& p, const VerifyOptions& options, Set occurring)
      : p_(p),
        k_(static_cast<std::size_t>(p.k)),
        options_(options),
        occurring_(std::move(occurring)),
        last_(static_cast<std::size_t>(p.v), 0),
        tracks_(static_cast<std::size_t>(p.v)),
        surplus_(static_cast<std::size_t>(p.v), 0),
        batch_(std::max<std::size_t>(1, 2048 / k_)),
        arranged_(batch_ * k_),
        kept_(batch_),
        left_(k_) {
    verdict_.parameters = p;
    usually_covered_ = newly_covered(p.change);
  }

  /// Blocks, one after another.
  void add(std::span<const Element> blocks) {
    while (!blocks.empty()) {
      const std::size_t size = std::min(blocks.size(), arranged_.size());
      add_batch(blocks.first(size));
      blocks = blocks.subspan(size);
    }
  }

  Verdict finish() {
    close_the_circle();
    count_subsets();
    count_elements();
    if (options_.unchanged) {
      verdict_.unchanged_subsets = unchanged_.distinct();
    }
    verdict_.counting_bound = economical_blocks(p_);
    return std::move(verdict_);
  }

 private:
  /// Where an element has been. A run of blocks from `first` to `last` counts last − first + 1;
  /// when a run begins, the sum is known but for its `last`, which is in last_.
  struct Track {
    std::uint64_t runs = 0;
    std::uint64_t length =
        0;  ///< Σ(last − first) of the runs, less the last of the latest; may wrap
  };

  // First the changes from block to block, which take little memory; then the bits of all pairs
  // together, so that the waits for memory overlap.
  void add_batch(std::span<const Element> blocks) {
    Element* arranged = arranged_.data();
    std::size_t* kept = kept_.data();
    for (std::size_t at = 0; at < blocks.size(); at += k_, arranged += k_) {
      *kept++ = add_block(blocks.subspan(at, k_), arranged);
    }
    for (std::size_t at = 0, i = 0; at < blocks.size(); at += k_, ++i) {
      occurring_.insert_new({arranged_.data() + at, k_}, kept_[i]);
    }
  }

  // Writes the kept elements of the block to `arranged`, then the introduced ones, and returns how
  // many are kept.
  std::size_t add_block(std::span<const Element> block, Element* arranged) {
    const std::uint64_t number = ++verdict_.b;
    const std::uint64_t now = number + 1;  // so that 0 and 1 stand before every block
    std::uint64_t* const left = left_.data();
    std::uint64_t* const last_seen = last_.data();
    const std::uint64_t v = p_.v;
    const std::size_t k = block.size();
    std::size_t kept = 0;
    std::size_t introduced_from = k;
    bool repeated = false;
    for (const Element x : block) {
      if (x >= v) {
        throw BadInput(fmt::format("block {}: element {} is not below v = {}", number, x, v));
      }
      const std::uint64_t last = last_seen[x];
      last_seen[x] = now;
      // Both stores are made, from the front and from the back, and one place advances: a branch
      // would be mispredicted at every change.
      const bool stays = last + 1 == now;
      arranged[kept] = x;
      arranged[introduced_from - 1] = x;
      left[introduced_from - 1] = last;
      kept += stays ? 1 : 0;
      introduced_from -= stays ? 0 : 1;
    }
    for (std::size_t i = kept; i < k; ++i) {
      Track& track = tracks_[arranged[i]];
      track.length += left[i] - now;
      ++track.runs;
      repeated |= left[i] == now;  // it was in this block already, so it counted as introduced
    }
    if (repeated) {
      refuse_repetition(block);
    }
    if (number == 1) {
      first_.assign(block.begin(), block.end());
    } else {
      judge_step(number - 1, number, k - kept, {arranged, kept});
    }
    verdict_.covered += k - kept == p_.change ? usually_covered_ : newly_covered(k - kept);
    return kept;
  }

  [[noreturn]] void refuse_repetition(std::span<const Element> block) const {
    Block sorted(block.begin(), block.end());
    std::sort(sorted.begin(), sorted.end());
    const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
    throw BadInput(fmt::format("block {} repeats the element {}", verdict_.b, *twin));
  }

  /// t-subsets of a block with that many introduced elements that contain one of them.
  [[nodiscard]] std::uint64_t newly_covered(std::uint64_t introduced) const {
    if (p_.strength == 2) {
      return introduced * (p_.k - introduced) + introduced * (introduced - 1) / 2;
    }
    return binomial(p_.k, p_.strength) - binomial(p_.k - introduced, p_.strength);
  }

  void judge_step(std::uint64_t from, std::uint64_t to, std::uint64_t changes,
                  std::span<const Element> kept) {
    if (changes != p_.change) {
      ++verdict_.bad_steps;
      if (verdict_.bad_step_examples.size() < options_.examples) {
        verdict_.bad_step_examples.push_back({from, to, changes});
      }
      for (const Element x : kept) {
        surplus_[x] += static_cast<std::int64_t>(changes) - static_cast<std::int64_t>(p_.change);
      }
    }
    if (options_.unchanged) {
      unchanged_.add(kept);
    }
  }

  // Until here the first block counted as if nothing preceded it.
  void close_the_circle() {
    const std::uint64_t b = verdict_.b;
    verdict_.elements.resize(tracks_.size());
    for (std::size_t x = 0; x < tracks_.size(); ++x) {
      const std::uint64_t blocks = tracks_[x].length + last_[x] + tracks_[x].runs;
      verdict_.elements[x].blocks = blocks;
      if (b > 0 && blocks == b) {
        verdict_.fixed.push_back(static_cast<Element>(x));
      }
    }
    if (p_.kind != Kind::circular || b < 2) {
      return;
    }
    Block kept;
    for (const Element x : first_) {
      if (last_[x] == b + 1) {
        kept.push_back(x);
        --tracks_[x].runs;  // its first and its last run are one
      }
    }
    const std::uint64_t introduced = p_.k - kept.size();
    judge_step(b, 1, introduced, kept);
    verdict_.covered -= newly_covered(p_.k) - newly_covered(introduced);
    verdict_.never_newly_covered = binomial(verdict_.fixed.size(), p_.strength);
  }

  void count_subsets() {
    verdict_.subsets = binomial(p_.v, p_.strength);
    const std::uint64_t occurring = occurring_.size();
    verdict_.uncovered = verdict_.subsets - occurring;
    verdict_.excess = verdict_.covered - (occurring - verdict_.never_newly_covered);
    occurring_.for_each_missing(options_.examples, [&](std::span<const Element> subset) {
      verdict_.uncovered_examples.emplace_back(subset.begin(), subset.end());
    });
  }

  void count_elements() {
    const bool pairs = p_.strength == 2;
    for (std::size_t x = 0; x < tracks_.size(); ++x) {
      ElementCount& count = verdict_.elements[x];
      count.introductions = tracks_[x].runs;
      if (count.blocks == count.introductions) {
        verdict_.never_unchanged.push_back(static_cast<Element>(x));
      }
      if (pairs) {
        count.covered = count.introductions * (p_.k - 1) +
                        (count.blocks - count.introductions) * p_.change +
                        static_cast<std::uint64_t>(surplus_[x]);
      }
    }
    if (pairs && verdict_.b > 0) {
      count_excess();
    }
  }

  // e_x = covered pairs at x less the distinct ones; the rarer of occurring and missing pairs is
  // listed. Unsigned differences may wrap on the way; the results do not.
  void count_excess() {
    const std::uint64_t occurring = verdict_.subsets - verdict_.uncovered;
    const bool by_missing = verdict_.uncovered <= occurring;
    for (ElementCount& count : verdict_.elements) {
      count.excess = count.covered - (by_missing ? p_.v - 1 : 0);
    }
    if (by_missing) {
      occurring_.for_each_missing(verdict_.uncovered, [&](std::span<const Element> pair) {
        for (const Element x : pair) {
          ++verdict_.elements[x].excess;
        }
      });
    } else {
      occurring_.for_each(occurring, [&](std::span<const Element> pair) {
        for (const Element x : pair) {
          --verdict_.elements[x].excess;
        }
      });
    }
    if (verdict_.never_newly_covered > 0) {
      for (const Element x : verdict_.fixed) {
        verdict_.elements[x].excess += verdict_.fixed.size() - 1;
      }
    }
    std::uint64_t sum = 0;
    for (const ElementCount& count : verdict_.elements) {
      sum += count.excess;
    }
    verdict_.degree_identity = verdict_.valid() && sum == 2 * verdict_.excess;
  }

  Parameters p_;
  std::size_t k_;
  VerifyOptions options_;
  Set occurring_;
  std::vector<std::uint64_t> last_;  // by element: the last block that holds it; 0: none yet
  std::vector<Track> tracks_;
  std::vector<std::int64_t>
      surplus_;        // by element: covered pairs beyond m for each block that keeps it
  std::size_t batch_;  // blocks that are taken together
  std::vector<Element>
      arranged_;  // of each block of a batch the kept elements, then the introduced ones
  std::vector<std::size_t> kept_;    // by block of a batch: the number of kept elements
  std::vector<std::uint64_t> left_;  // last_ of the introduced elements, before this block
  Block first_;
  std::uint64_t usually_covered_ = 0;  // by a step with m changes
  SubsetHashes unchanged_;
  Verdict verdict_;
};

/// PairSet with the interface that Verification needs.
class Pairs {
 public:
  explicit Pairs(const Parameters& p) : set_(p.v) {}

  // Elements from `introduced_from` on are introduced: mark each with all elements before it.
  void insert_new(std::span<const Element> block, std::size_t introduced_from) {
    if (ElementBits::pay(block.size() - introduced_from, set_.v())) {
      bits_.assign(block, introduced_from, set_.v());
      for (std::size_t i = 0; i < block.size(); ++i) {
        set_.insert_below(block[i], bits_.completing(i >= introduced_from));
      }
      return;
    }
    for (std::size_t i = introduced_from; i < block.size(); ++i) {
      const Element x = block[i];
      for (std::size_t j = 0; j < i; ++j) {
        set_.insert(x, block[j]);
      }
    }
  }

  [[nodiscard]] std::uint64_t size() const { return set_.size(); }

  template <typename Visit>
  void for_each_missing(std::uint64_t limit, Visit&& visit) const {
    set_.for_each_missing(limit, [&](Element x, Element y) { visit_pair(x, y, visit); });
  }

  template <typename Visit>
  void for_each(std::uint64_t limit, Visit&& visit) const {
    set_.for_each(limit, [&](Element x, Element y) { visit_pair(x, y, visit); });
  }

 private:
  template <typename Visit>
  static void visit_pair(Element x, Element y, Visit& visit) {
    const std::array<Element, 2> pair{x, y};
    visit(std::span<const Element>(pair));
  }

  PairSet set_;
  ElementBits bits_;
};

template <typename Set>
Verdict run(BlockSource& blocks, const Parameters& p, const VerifyOptions& options) {
  Verification<Set> verification(p, options, Set(p));
  for_each_batch(blocks, [&](std::span<const Element> batch) {
    stop_if_asked();
    verification.add(batch);
  });
  return verification.finish();
}

void check_size(const Parameters& p) {
  check(p);
  constexpr std::uint64_t most_bits = std::uint64_t{1} << 35;
  if (p.v > max_elements_in_memory) {
    throw MissingResource(
        fmt::format("v = {} exceeds the {} elements that verification can hold; give a smaller v",
                    p.v, max_elements_in_memory));
  }
  if (binomial(p.v, p.strength) > most_bits) {
    throw MissingResource(
        fmt::format("the C({},{}) subsets to verify need more than 4 GiB of memory; use a smaller "
                    "v or strength",
                    p.v, p.strength));
  }
}

MissingResource no_memory(const Parameters& p) {
  return MissingResource(
      fmt::format("not enough memory to verify v = {}: it takes C(v,{}) bits; give a smaller v",
                  p.v, p.strength));
}

}  // namespace

struct RunningVerdict::State {
  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  virtual ~State() = default;
  virtual void add(std::span<const Element> blocks) = 0;
  virtual Verdict finish() = 0;
};

template <typename Set>
struct RunningVerdict::StateOf final : RunningVerdict::State {
  StateOf(const Parameters& p, const VerifyOptions& options) : verification(p, options, Set(p)) {}
  void add(std::span<const Element> blocks) override { verification.add(blocks); }
  Verdict finish() override { return verification.finish(); }

  Verification<Set> verification;
};

RunningVerdict::RunningVerdict(const Parameters& p, const VerifyOptions& options) : k_(p.k) {
  check_size(p);
  try {
    if (p.strength == 2) {
      state_ = std::make_unique<StateOf<Pairs>>(p, options);
    } else {
      state_ = std::make_unique<StateOf<SubsetSet>>(p, options);
    }
  } catch (const std::bad_alloc&) {
    throw no_memory(p);
  }
}

RunningVerdict::~RunningVerdict() = default;

void RunningVerdict::add(std::span<const Element> blocks) {
  if (blocks.size() % k_ != 0) {
    throw BadInput(fmt::format("a block of {} elements, not k = {}", blocks.size() % k_, k_));
  }
  state_->add(blocks);
}

Verdict RunningVerdict::finish() { return state_->finish(); }

Verdict verify(BlockSource& source, const VerifyOptions& options) {
  const Parameters p = source.parameters();
  check_size(p);
  try {
    return p.strength == 2 ? run<Pairs>(source, p, options) : run<SubsetSet>(source, p, options);
  } catch (const std::bad_alloc&) {
    throw no_memory(p);
  }
}

Verdict verify(const Design& design, const VerifyOptions& options) {
  DesignSource source(design);
  return verify(source, options);
}

}  // namespace changeover
