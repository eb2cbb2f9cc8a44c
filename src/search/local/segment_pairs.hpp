// The state of a local search for strength 2: blocks, and the number of blocks that contain each
// pair.
//
//     SegmentPairs<std::uint8_t> state(design);            // any list with the change property
//     const SegmentSwap move = state.propose(random);
//     if (move.length > 0) {
//       state.attempt(move, [](std::int32_t change) { return change <= 0; });
//     }
//     state.missing();                                     // pairs that are in no block
//
// A move on a run of n blocks uses rows of v counters. For every z, d(z) is how often z is in the
// run together with y, less how often together with x. The pair {x,z} gains d(z) and {y,z} loses
// it; only counters that become 0, or cease to be 0, matter. Counters are bytes (or 16 bits) and
// rows are added 16 bytes at a time, so evaluating a move costs O((n + 1)·v/16) for any k, about 50
// ns at (30,6).
//
// Memory: bytes(v, k, b), about (2v² + bv)·sizeof(Count) + 4v² + 2bk. The scope of the thread
// (run/control.hpp) can stop the constructor.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/run/control.hpp"
#include "run/random.hpp"
#include "search/local/segment_swap.hpp"

namespace changeover {

/// Blocks during a search; see above. Count must hold the number of blocks that contain an element:
/// 8 bits if that is at most 255 at the start (moves that would exceed it are excluded).
template <typename Count>
class SegmentPairs {
 public:
  /// Whether counters of this type can hold this design. O(bk).
  [[nodiscard]] static bool fits(const Design& design) {
    std::vector<std::size_t> blocks(static_cast<std::size_t>(design.v()), 0);
    for (const Element x : design.elements()) {
      ++blocks[x];
    }
    return *std::ranges::max_element(blocks) <= most;
  }

  /// The memory for b < 2³² blocks of k of v ≤ 65,535 elements, at most: the list of uncovered
  /// pairs may be as long as all pairs.
  [[nodiscard]] static constexpr std::uint64_t bytes(std::uint64_t v, std::uint64_t k,
                                                     std::uint64_t b) {
    const std::uint64_t row = 16 * vectors_of_a_row(v);
    return (2 * v + b + 1) * row + v * v * (sizeof(std::uint32_t) + sizeof(Pair)) + 4 * v +
           b * k * sizeof(std::uint16_t);
  }

  /// Starts with one or more blocks; needs fits() and v ≤ 65,535. The first `frozen` < b blocks and
  /// the locked cells never change; parts stay parts.
  explicit SegmentPairs(const Design& design, std::size_t frozen = 0, const Locks& locks = {})
      : parameters_(design.parameters()),
        v_(static_cast<std::uint32_t>(design.v())),
        k_(static_cast<std::uint32_t>(design.k())),
        b_(static_cast<std::uint32_t>(design.block_count())),
        frozen_(static_cast<std::uint32_t>(frozen)),
        circular_(design.parameters().kind == Kind::circular),
        usual_(usual_segment(design.k(), design.parameters().change)),
        row_(static_cast<std::uint32_t>(vectors_of_a_row(v_))),
        parts_(locks.parts.begin(), locks.parts.end()) {
    grow(counts_, std::size_t{v_} * row_, Sixteen{});
    grow(members_, std::size_t{b_} * row_, Sixteen{});
    grow(keep_, std::size_t{v_} * row_, Sixteen{});
    gained_.resize(row_);
    blocks_of_.resize(v_);
    grow(place_, std::size_t{v_} * v_, absent);
    elements_.reserve(std::size_t{b_} * k_);
    for (Element x = 0; x < v_; ++x) {
      stop_if_asked();
      std::fill_n(lane(keep_, x), row_ * lanes, static_cast<Count>(~Count{0}));
      lane(keep_, x)[x] = 0;
    }
    for (std::uint32_t i = 0; i < b_; ++i) {
      stop_if_asked();
      for (const Element x : design.block(i)) {
        elements_.push_back(static_cast<std::uint16_t>(x));
        lane(members_, i)[x] = 1;
        ++blocks_of_[x];
        for (const Element y : design.block(i)) {
          if (x != y) {
            ++lane(counts_, x)[y];
          }
        }
      }
    }
    if (!locks.cells.empty() || !parts_.empty()) {
      locked_.resize(std::size_t{b_} * v_);
      for (const LockedCell& cell : locks.cells) {
        ++locks_at(cell.block)[cell.element];
      }
      for (const LockedPart& part : parts_) {
        lock(part, part.block, 1);
        lock(part, after(part.block), 1);
      }
    }
    for (Element y = 1; y < v_; ++y) {
      stop_if_asked();
      for (Element x = 0; x < y; ++x) {
        if (lane(counts_, x)[y] == 0) {
          enlist(x, y);
        }
      }
    }
  }

  [[nodiscard]] std::uint32_t block_count() const { return b_; }
  /// The number of pairs that are in no block. O(1).
  [[nodiscard]] std::uint64_t missing() const { return uncovered_.size(); }
  [[nodiscard]] bool contains(std::uint32_t block, Element x) const {
    return lane(members_, block)[x] != 0;
  }
  /// The number of blocks that contain both; x ≠ y.
  [[nodiscard]] std::uint32_t count(Element x, Element y) const { return lane(counts_, x)[y]; }
  /// The k elements of a block, in any order.
  [[nodiscard]] std::span<const std::uint16_t> block(std::uint32_t index) const {
    return std::span(elements_).subspan(std::size_t{index} * k_, k_);
  }

  /// The parts, with the first of the two blocks where each is now.
  [[nodiscard]] const std::vector<LockedPart>& parts() const { return parts_; }

  /// The current blocks.
  [[nodiscard]] Design design() const {
    Design design(parameters_);
    design.reserve(b_);
    Block block(k_);
    for (std::uint32_t i = 0; i < b_; ++i) {
      std::copy_n(elements_.begin() + std::ptrdiff_t{i} * k_, k_, block.begin());
      design.append(block);
    }
    return design;
  }

  /// The move that exchanges x in block i and y outside it; of length 0 if it would change a frozen
  /// block, relabel a whole circular list or overflow a counter.
  [[nodiscard]] SegmentSwap segment(std::uint32_t i, Element x, Element y) const {
    return segment(i, x, y, b_);
  }

  /// The same, but of length 0 if it is longer than `longest`.
  [[nodiscard]] SegmentSwap segment(std::uint32_t i, Element x, Element y,
                                    std::uint32_t longest) const {
    SegmentSwap move = find_segment(b_, circular_, longest, i, x, y, [&](std::uint32_t block) {
      const Count* row = lane(members_, block);
      return row[x] != row[y];
    });
    if (move.first < frozen_ || (frozen_ > 0 && move.first + move.length > b_) ||
        std::max(blocks_of_[x], blocks_of_[y]) + move.length > most || touches_locked(move)) {
      move.length = 0;
    }
    return move;
  }

  /// A move at a random place.
  [[nodiscard]] SegmentSwap propose(Random& random) {
    if (!parts_.empty()) {
      shift_some_part(random);
    }
    const std::uint32_t i = frozen_ + random.below(b_ - frozen_);
    const Element x = block(i)[random.below(k_)];
    Element y = random.below(v_);
    while (contains(i, y)) {
      y = random.below(v_);
    }
    return segment(i, x, y, longest(random));
  }

  /// A move that brings the elements of some uncovered pair together; needs missing() > 0.
  [[nodiscard]] SegmentSwap propose_aimed(Random& random) {
    const std::uint64_t bits = random.next();
    const auto which = static_cast<std::size_t>(((bits & 0xffffffff) * uncovered_.size()) >> 32);
    Element p = uncovered_[which].x;
    Element q = uncovered_[which].y;
    if (bits >> 63 != 0) {
      std::swap(p, q);
    }
    for (std::uint32_t tries = 0; tries < most_tries; ++tries) {
      const std::uint32_t i = frozen_ + random.below(b_ - frozen_);
      if (contains(i, p)) {
        Element x = block(i)[random.below(k_)];
        while (x == p && k_ > 1) {
          x = block(i)[random.below(k_)];
        }
        return segment(i, x, q, longest(random));
      }
    }
    return propose(random);
  }

  /// Computes the change of missing() and makes the move if accept(change) returns true. Returns
  /// whether it was made. The move must come from segment() in this state.
  template <typename Accept>
  bool attempt(const SegmentSwap& move, Accept&& accept) {
    if (!accept(look(move))) {
      return false;
    }
    make(move);
    return true;
  }

  /// Makes the move. Making it twice restores the state.
  void apply(const SegmentSwap& move) {
    attempt(move, [](std::int32_t) { return true; });
  }

 private:
  using Lanes __attribute__((vector_size(16))) = Count;
  using Words __attribute__((vector_size(16))) = std::uint64_t;
  static constexpr std::uint32_t lanes = 16 / sizeof(Count);
  static constexpr std::uint32_t chunk = 4;  // vectors of a row that are kept in registers
  static constexpr std::uint32_t most = std::numeric_limits<Count>::max();
  static constexpr std::uint32_t absent = 0xffffffff;
  static constexpr std::uint32_t most_tries = 1000;

  /// 16 bytes of a row; a struct, as template arguments lose the attribute.
  struct Sixteen {
    Lanes of;
  };

  struct Pair {
    std::uint16_t x = 0;
    std::uint16_t y = 0;
  };

  // Rounded up to whole registers, if a row has more than one vector.
  [[nodiscard]] static constexpr std::uint64_t vectors_of_a_row(std::uint64_t v) {
    const std::uint64_t vectors = (v + lanes - 1) / lanes;
    return vectors > chunk ? (vectors + chunk - 1) / chunk * chunk : vectors;
  }

  // Allocating much memory is slow: it is touched in pieces, so that it can be stopped.
  template <typename Value>
  static void grow(std::vector<Value>& values, std::size_t size, const Value& value) {
    constexpr std::size_t piece = std::size_t{1} << 20;
    values.reserve(size);
    while (values.size() < size) {
      stop_if_asked();
      values.resize(std::min(size, values.size() + piece), value);
    }
  }

  [[nodiscard]] bool touches_locked(const SegmentSwap& move) const {
    if (locked_.empty()) {
      return false;
    }
    std::uint32_t j = move.first;
    for (std::uint32_t n = 0; n < move.length; ++n) {
      const std::size_t row = std::size_t{j} * v_;
      if (locked_[row + move.x] != 0 || locked_[row + move.y] != 0) {
        return true;
      }
      j = j + 1 == b_ ? 0 : j + 1;
    }
    return false;
  }

  [[nodiscard]] std::uint8_t* locks_at(std::uint32_t block) {
    return locked_.data() + std::size_t{block} * v_;
  }
  void lock(const LockedPart& part, std::uint32_t block, int by) {
    for (const Element x : part.elements) {
      locks_at(block)[x] = static_cast<std::uint8_t>(locks_at(block)[x] + by);
    }
  }
  [[nodiscard]] std::uint32_t after(std::uint32_t block) const {
    return block + 1 == b_ ? 0 : block + 1;
  }
  [[nodiscard]] std::uint32_t before(std::uint32_t block) const {
    return block == 0 ? b_ - 1 : block - 1;
  }

  // A part that a third block holds may be locked one block later or earlier from now on.
  void shift_some_part(Random& random) {
    LockedPart& part = parts_[random.below(static_cast<std::uint32_t>(parts_.size()))];
    const bool later = random.one_in_two();
    const std::uint32_t second = after(part.block);
    const std::uint32_t next = later ? after(second) : before(part.block);
    if (!circular_ && (later ? second + 1 == b_ : part.block == 0)) {
      return;
    }
    const std::uint32_t place = later ? second : next;
    const bool fits =
        std::ranges::all_of(part.elements, [&](Element x) { return contains(next, x); });
    if (!fits || std::ranges::any_of(
                     parts_, [&](const LockedPart& other) { return other.block == place; })) {
      return;
    }
    lock(part, next, 1);
    lock(part, later ? part.block : second, -1);
    part.block = place;
  }

  // One move in 16 may have any length.
  [[nodiscard]] std::uint32_t longest(Random& random) const {
    return (random.next() >> 60) == 0 ? b_ : usual_;
  }

  // The counters of row `index` one by one.
  [[nodiscard]] Count* lane(std::vector<Sixteen>& rows, std::size_t index) {
    return reinterpret_cast<Count*>(rows.data() + index * row_);
  }
  [[nodiscard]] const Count* lane(const std::vector<Sixteen>& rows, std::size_t index) const {
    return reinterpret_cast<const Count*>(rows.data() + index * row_);
  }

  void enlist(Element x, Element y) {
    const auto at = static_cast<std::uint32_t>(uncovered_.size());
    place_[std::size_t{x} * v_ + y] = at;
    place_[std::size_t{y} * v_ + x] = at;
    uncovered_.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
  }

  void strike(Element x, Element y) {
    const std::uint32_t at = place_[std::size_t{x} * v_ + y];
    const Pair last = uncovered_.back();
    uncovered_[at] = last;
    place_[std::size_t{last.x} * v_ + last.y] = at;
    place_[std::size_t{last.y} * v_ + last.x] = at;
    uncovered_.pop_back();
  }

  // The sum of signed lanes: they are made positive first, then added in pairs.
  [[nodiscard]] static std::int32_t sum(const Lanes& signed_lanes) {
    if constexpr (sizeof(Count) == 1) {
      constexpr std::uint64_t even = 0x00ff00ff00ff00ffULL;
      constexpr std::uint64_t ones = 0x0001000100010001ULL;
      const Lanes positive = signed_lanes + Count{0x80};
      const auto words = reinterpret_cast<Words>(positive);
      const std::uint64_t low = (words[0] & even) + (words[0] >> 8 & even);
      const std::uint64_t high = (words[1] & even) + (words[1] >> 8 & even);
      return static_cast<std::int32_t>(((low + high) * ones) >> 48) - 16 * 0x80;
    } else {
      std::int32_t total = 0;
      for (std::uint32_t i = 0; i < lanes; ++i) {
        total += static_cast<std::make_signed_t<Count>>(signed_lanes[i]);
      }
      return total;
    }
  }

  // N vectors from vector w on: writes d to gained_ and adds the change to `change`.
  template <std::uint32_t N>
  void look_at(const SegmentSwap& move, std::uint32_t w, Lanes& change) {
    std::array<Sixteen, N> d{};
    std::uint32_t j = move.first;
    for (std::uint32_t n = 0; n < move.length; ++n) {
      const Sixteen* row = members_.data() + std::size_t{j} * row_;
      const Count holds_x = reinterpret_cast<const Count*>(row)[move.x];
      const Lanes sign = Lanes{} - holds_x;  // all bits if x is in the block: its pairs lose
      for (std::uint32_t i = 0; i < N; ++i) {
        d[i].of += (row[w + i].of ^ sign) - sign;
      }
      j = j + 1 == b_ ? 0 : j + 1;
    }
    const Sixteen* keep_x = keep_.data() + std::size_t{move.x} * row_ + w;
    const Sixteen* keep_y = keep_.data() + std::size_t{move.y} * row_ + w;
    const Sixteen* of_x = counts_.data() + std::size_t{move.x} * row_ + w;
    const Sixteen* of_y = counts_.data() + std::size_t{move.y} * row_ + w;
    for (std::uint32_t i = 0; i < N; ++i) {
      const Lanes gained = d[i].of & keep_x[i].of & keep_y[i].of;
      gained_[w + i].of = gained;
      // A comparison that holds is −1 in its lane.
      const auto before =
          reinterpret_cast<Lanes>(of_x[i].of == 0) + reinterpret_cast<Lanes>(of_y[i].of == 0);
      const auto after = reinterpret_cast<Lanes>(of_x[i].of + gained == 0) +
                         reinterpret_cast<Lanes>(of_y[i].of - gained == 0);
      change += before - after;
    }
  }

  [[nodiscard]] std::int32_t look(const SegmentSwap& move) {
    Lanes change{};
    switch (row_) {
      case 1:
        look_at<1>(move, 0, change);
        return sum(change);
      case 2:
        look_at<2>(move, 0, change);
        return sum(change);
      case 3:
        look_at<3>(move, 0, change);
        return sum(change);
      default:
        break;
    }
    // Each chunk is summed at once, since a lane of 8 bits could overflow.
    std::int32_t total = 0;
    for (std::uint32_t w = 0; w < row_; w += chunk) {
      Lanes part{};
      look_at<chunk>(move, w, part);
      total += sum(part);
    }
    return total;
  }

  // Needs gained_ from look().
  void make(const SegmentSwap& move) {
    const auto [first, length, x, y] = move;
    std::uint32_t j = first;
    for (std::uint32_t n = 0; n < length; ++n) {
      Count* row = lane(members_, j);
      const Element out = row[x] != 0 ? x : y;
      const Element in = row[x] != 0 ? y : x;
      row[out] = 0;
      row[in] = 1;
      --blocks_of_[out];
      ++blocks_of_[in];
      std::uint16_t* place = elements_.data() + std::size_t{j} * k_;
      while (*place != out) {
        ++place;
      }
      *place = static_cast<std::uint16_t>(in);
      j = j + 1 == b_ ? 0 : j + 1;
    }
    Count* of_x = lane(counts_, x);
    Count* of_y = lane(counts_, y);
    const Count* gained = reinterpret_cast<const Count*>(gained_.data());
    for (std::uint32_t w = 0; w < row_ * lanes; w += 8 / sizeof(Count)) {
      std::uint64_t word = 0;
      std::memcpy(&word, gained + w, sizeof word);
      if (word == 0) {
        continue;
      }
      for (std::uint32_t z = w; z < w + 8 / sizeof(Count); ++z) {
        if (gained[z] != 0) {
          change_count(x, z, of_x[z], static_cast<Count>(of_x[z] + gained[z]));
          change_count(y, z, of_y[z], static_cast<Count>(of_y[z] - gained[z]));
        }
      }
    }
  }

  void change_count(Element x, Element z, Count before, Count after) {
    lane(counts_, x)[z] = after;
    lane(counts_, z)[x] = after;
    if (before == 0) {
      strike(x, z);
    } else if (after == 0) {
      enlist(x, z);
    }
  }

  Parameters parameters_;
  std::uint32_t v_, k_, b_, frozen_;
  bool circular_;
  std::uint32_t usual_;                   // usual length of a segment
  std::uint32_t row_;                     // number of vectors in a row
  std::vector<Sixteen> counts_;           // v rows: in how many blocks {x,z} is
  std::vector<Sixteen> members_;          // b rows: 1 where the block has the element
  std::vector<Sixteen> keep_;             // v rows: all bits except at the row's own element
  std::vector<Sixteen> gained_;           // of the move that was evaluated last
  std::vector<std::uint16_t> elements_;   // k of each block
  std::vector<std::uint32_t> blocks_of_;  // by element
  std::vector<std::uint8_t> locked_;      // b rows of v cells, how often; empty for none
  std::vector<LockedPart> parts_;         // where they are now
  std::vector<Pair> uncovered_;           // in any order
  std::vector<std::uint32_t> place_;      // of a pair in uncovered_
};

// Counts how often each thing is covered, and lists the uncovered ones, to draw one at random.

/// Things 0, 1, … below 2³². All but the constructor is O(1).
class Coverage {
 public:
  Coverage() = default;
  /// Starts with the numbers in `times`. Stops with the scope of this thread (run/control.hpp).
  explicit Coverage(std::vector<std::uint32_t> times)
      : times_(std::move(times)), place_(times_.size()) {
    constexpr std::uint32_t between_questions = 1 << 16;
    for (std::uint32_t thing = 0; thing < times_.size(); ++thing) {
      if (thing % between_questions == 0) {
        stop_if_asked();
      }
      if (times_[thing] == 0) {
        enlist(thing);
      }
    }
  }

  [[nodiscard]] std::uint32_t times(std::size_t thing) const { return times_[thing]; }
  /// For a change that is undone at once: the list of uncovered things is not updated.
  [[nodiscard]] std::uint32_t& times(std::size_t thing) { return times_[thing]; }
  [[nodiscard]] std::uint32_t missing() const {
    return static_cast<std::uint32_t>(uncovered_.size());
  }
  /// One of the missing() uncovered things.
  [[nodiscard]] std::uint32_t uncovered(std::size_t which) const { return uncovered_[which]; }

  void add(std::size_t thing) {
    if (times_[thing]++ == 0) {
      const std::uint32_t last = uncovered_.back();
      uncovered_[place_[thing]] = last;
      place_[last] = place_[thing];
      uncovered_.pop_back();
    }
  }

  void remove(std::size_t thing) {
    if (--times_[thing] == 0) {
      enlist(static_cast<std::uint32_t>(thing));
    }
  }

 private:
  void enlist(std::uint32_t thing) {
    place_[thing] = static_cast<std::uint32_t>(uncovered_.size());
    uncovered_.push_back(thing);
  }

  std::vector<std::uint32_t> times_;
  std::vector<std::uint32_t> uncovered_;  // in any order
  std::vector<std::uint32_t> place_;      // in uncovered_, for uncovered things
};

}  // namespace changeover
