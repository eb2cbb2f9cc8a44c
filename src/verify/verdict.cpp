#include "changeover/verify/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <utility>

#include "changeover/core/checked.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/run/scope.hpp"
#include "verify/element_bits.hpp"
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
        arranged_(k_),
        introduced_(k_),
        left_(k_) {
    verdict_.parameters = p;
  }

  void add(std::span<const Element> block) {
    ++verdict_.b;
    const std::uint64_t now = verdict_.b + 1;  // so that 0 and 1 stand before every block
    // Both stores are made and one counter advances: a branch would be mispredicted at every change.
    Element* const kept = arranged_.data();
    Element* const introduced = introduced_.data();
    std::uint64_t* const left = left_.data();
    std::uint64_t* const last_seen = last_.data();
    const std::uint64_t v = p_.v;
    std::size_t kept_count = 0;
    std::size_t introduced_count = 0;
    bool repeated = false;
    for (const Element x : block) {
      if (x >= v) {
        throw BadInput(fmt::format("block {}: element {} is not below v = {}", verdict_.b, x, v));
      }
      const std::uint64_t last = last_seen[x];
      const bool stays = last + 1 == now;
      kept[kept_count] = x;
      introduced[introduced_count] = x;
      left[introduced_count] = last;
      kept_count += stays ? 1 : 0;
      introduced_count += stays ? 0 : 1;
      repeated |= last == now;
      last_seen[x] = now;
    }
    if (repeated) {
      refuse_repetition(block);
    }
    for (std::size_t i = 0; i < introduced_count; ++i) {
      Track& track = tracks_[introduced[i]];
      track.close_run(left[i]);
      track.first = now;
      kept[kept_count + i] = introduced[i];
    }
    if (verdict_.b == 1) {
      first_.assign(block.begin(), block.end());
    } else {
      judge_step(verdict_.b - 1, verdict_.b, introduced_count, {kept, kept_count});
    }
    verdict_.covered += newly_covered(introduced_count);
    occurring_.insert_new({kept, k_}, kept_count);
  }

  Verdict finish() {
    close_the_circle();
    count_subsets();
    count_elements();
    if (options_.unchanged) {
      verdict_.unchanged_subsets = unchanged_.distinct();
    }
    const std::uint64_t all = verdict_.subsets;
    const std::uint64_t most = newly_covered_at_most(p_);
    if (p_.v == p_.k) {
      verdict_.counting_bound = 1;
    } else if (p_.kind == Kind::circular) {
      verdict_.counting_bound = ceil_div(all, most);
    } else {
      verdict_.counting_bound = ceil_div(all - binomial(p_.k, p_.strength), most) + 1;
    }
    return std::move(verdict_);
  }

 private:
  /// Where an element has been: closed runs of blocks, and where the run began that is open or was open
  /// last. Blocks are told by verdict_.b + 1.
  struct Track {
    std::uint64_t first = 0;
    std::uint64_t runs = 0;
    std::uint64_t blocks = 0;
    std::int64_t surplus = 0;  ///< covered pairs at x beyond m for each block that keeps it

    void close_run(std::uint64_t last) {
      if (last != 0) {
        ++runs;
        blocks += last - first + 1;
      }
    }
  };

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
        tracks_[x].surplus +=
            static_cast<std::int64_t>(changes) - static_cast<std::int64_t>(p_.change);
      }
    }
    if (options_.unchanged) {
      unchanged_.add(kept);
    }
  }

  // Until here the first block counted as if nothing preceded it.
  void close_the_circle() {
    for (std::size_t x = 0; x < tracks_.size(); ++x) {
      tracks_[x].close_run(last_[x]);
    }
    const std::uint64_t b = verdict_.b;
    for (std::size_t x = 0; x < tracks_.size() && b > 0; ++x) {
      if (tracks_[x].blocks == b) {
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
    verdict_.elements.resize(tracks_.size());
    for (std::size_t x = 0; x < tracks_.size(); ++x) {
      const Track& track = tracks_[x];
      ElementCount& count = verdict_.elements[x];
      count.introductions = track.runs;
      count.blocks = track.blocks;
      if (track.blocks == track.runs) {
        verdict_.never_unchanged.push_back(static_cast<Element>(x));
      }
      if (pairs) {
        count.covered = track.runs * (p_.k - 1) + (track.blocks - track.runs) * p_.change +
                        static_cast<std::uint64_t>(track.surplus);
      }
    }
    if (pairs && verdict_.b > 0) {
      count_excess();
    }
  }

  // e_x = covered pairs at x less the distinct ones; the rarer of occurring and missing pairs is listed.
  // Unsigned differences may wrap on the way; the results do not.
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
  std::vector<Element> arranged_;  // the kept elements of a block, then the introduced ones
  std::vector<Element> introduced_;
  std::vector<std::uint64_t> left_;  // last_ of the introduced elements, before this block
  Block first_;
  SubsetHashes unchanged_;
  Verdict verdict_;
};

/// PairSet with the interface that Verification needs.
class Pairs {
 public:
  explicit Pairs(const Parameters& p) : set_(p.v) {}

  // Elements from `introduced_from` on are introduced: mark each with all that stand before it.
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

/// Where reading blocks can stop: every few thousand elements.
class StopPlace {
 public:
  explicit StopPlace(std::size_t k) : every_(std::max<std::size_t>(1, 4096 / (k + 1))) {}

  void pass() {
    if (--left_ == 0) {
      left_ = every_;
      stop_if_asked();
    }
  }

 private:
  std::size_t every_;
  std::size_t left_ = 1;
};

/// Hands every block to `take`.
void for_each_block(BlockSource& source, auto&& take) {
  Block block(static_cast<std::size_t>(source.parameters().k));
  StopPlace place(block.size());
  while (source.next(block)) {
    place.pass();
    take(std::span<const Element>(block));
  }
}

void for_each_block(const Design& design, auto&& take) {
  StopPlace place(static_cast<std::size_t>(design.k()));
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    place.pass();
    take(design.block(i));
  }
}

template <typename Set, typename Blocks>
Verdict run(Blocks& blocks, const Parameters& p, const VerifyOptions& options) {
  Verification<Set> verification(p, options, Set(p));
  for_each_block(blocks, [&](std::span<const Element> block) { verification.add(block); });
  return verification.finish();
}

void check_size(const Parameters& p) {
  check(p);
  constexpr std::uint64_t most_bits = std::uint64_t{1} << 35;
  if (p.v > max_elements_in_memory) {
    throw MissingResource(fmt::format("v = {} exceeds the {} elements that verification can hold",
                                      p.v, max_elements_in_memory));
  }
  if (binomial(p.v, p.strength) > most_bits) {
    throw MissingResource(
        fmt::format("the C({},{}) subsets to verify need more than 4 GiB of memory: use a smaller "
                    "v or strength",
                    p.v, p.strength));
  }
}

MissingResource no_memory(const Parameters& p) {
  return MissingResource(
      fmt::format("not enough memory to verify v = {}: it takes C(v,{}) bits", p.v, p.strength));
}

template <typename Blocks>
Verdict judge(Blocks& blocks, const VerifyOptions& options) {
  const Parameters p = blocks.parameters();
  check_size(p);
  try {
    return p.strength == 2 ? run<Pairs>(blocks, p, options) : run<SubsetSet>(blocks, p, options);
  } catch (const std::bad_alloc&) {
    throw no_memory(p);
  }
}

}  // namespace

struct RunningVerdict::State {
  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  virtual ~State() = default;
  virtual void add(std::span<const Element> block) = 0;
  virtual Verdict finish() = 0;
};

template <typename Set>
struct RunningVerdict::StateOf final : RunningVerdict::State {
  StateOf(const Parameters& p, const VerifyOptions& options) : verification(p, options, Set(p)) {}
  void add(std::span<const Element> block) override { verification.add(block); }
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

void RunningVerdict::add(std::span<const Element> block) {
  if (block.size() != k_) {
    throw BadInput(fmt::format("a block of {} elements, not k = {}", block.size(), k_));
  }
  state_->add(block);
}

Verdict RunningVerdict::finish() { return state_->finish(); }

Verdict verify(BlockSource& source, const VerifyOptions& options) { return judge(source, options); }

Verdict verify(const Design& design, const VerifyOptions& options) {
  return judge(design, options);
}

}  // namespace changeover
