// The state of the search for cheap lists: a list of set-ups, its cost, and its uncovered pairs,
// updated by every move.
//
// Frequent moves can be evaluated before they are made: rise_of_replace(), rise_of_take_out() and
// others return what they would add to cost() and uncovered(), in O(at_once) and O(at_once²). The
// others are made at once and can be undone by their inverse. A move on a stretch of L set-ups
// costs O(L·at_once).
// set-ups costs O(L·at_once).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "changeover/plan/job.hpp"
#include "plan/job/fitting.hpp"
#include "run/random.hpp"

namespace changeover {

/// The weights of introductions and tests in a search; not always their costs.
struct Weights {
  std::uint64_t test = 0;
  std::vector<std::uint64_t> change;  ///< by part
  std::uint64_t unit = 1;             ///< millionths for a weight of 1

  /// The true costs in millionths. A change that costs nothing has weight 1, so that a search does
  /// not prefer lists with many changes. If `tests` tests could overflow, a larger unit is used and
  /// the weights are rounded up: the weight of a list is at least its cost.
  static Weights of(const Job& job, std::uint64_t tests);
};

/// A run of set-ups, including both ends.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// The change caused by a move.
struct Rise {
  std::int64_t cost = 0;
  std::int64_t uncovered = 0;
};

class Sequence {
 public:
  /// Starts with set-ups that break no constraint but may leave pairs uncovered. The job must
  /// outlive this. @throws Stopped if the scope of this thread (run/control.hpp) requests it.
  Sequence(const Job& job, Weights weights, const std::vector<Block>& setups);

  [[nodiscard]] std::int64_t cost() const { return cost_; }
  [[nodiscard]] std::size_t uncovered() const { return uncovered_.size(); }
  [[nodiscard]] std::size_t size() const { return order_.size(); }
  [[nodiscard]] std::vector<Block> setups() const;
  /// Writes the set-ups one after another, each with its size before its parts; setups_of() reads
  /// them.
  void write_to(std::vector<Element>& flat) const;
  [[nodiscard]] static std::vector<Block> setups_of(const std::vector<Element>& flat);
  [[nodiscard]] const Job& job() const { return *job_; }
  [[nodiscard]] const Weights& weights() const { return weights_; }

  /// Parts that a search may move: not permanently mounted, and with a needed pair or of a slot
  /// that needs parts.
  [[nodiscard]] const std::vector<Element>& movable() const { return movable_; }
  [[nodiscard]] bool is_movable(Element x) const { return is_movable_[x]; }
  /// Uncovered needed pair number `index`, index < uncovered().
  [[nodiscard]] std::pair<Element, Element> uncovered_pair(std::size_t index) const;
  [[nodiscard]] std::span<const Element> setup(std::size_t at) const {
    const std::uint32_t h = order_[at];
    return {elements_of(h), sizes_[h]};
  }
  [[nodiscard]] bool holds(std::size_t at, Element x) const { return bit(order_[at], x); }
  [[nodiscard]] bool full(std::size_t at) const { return sizes_[order_[at]] >= room_; }
  /// The free room in all set-ups together.
  [[nodiscard]] std::uint64_t slack() const { return size() * room_ - occupied_; }
  /// Whether y may replace `leaving`; pass y itself if no part leaves.
  [[nodiscard]] bool may_join(std::size_t at, Element y, Element leaving) const;
  /// Whether the slot of x has more parts here than it needs.
  [[nodiscard]] bool may_leave(std::size_t at, Element x) const {
    return !fitting_.has_slots() || has_to_spare(order_[at], x);
  }
  /// Whether the slot of y is full here.
  [[nodiscard]] bool slot_full(std::size_t at, Element y) const {
    return fitting_.has_slots() && !has_place(order_[at], y);
  }
  [[nodiscard]] const Fitting& fitting() const { return fitting_; }

  /// One of the movable parts at position `in` that are not at `without`: number `choice` modulo
  /// their count; nullopt if there is none. Position size() stands for the start.
  [[nodiscard]] std::optional<Element> some_difference(std::size_t in, std::size_t without,
                                                       std::uint32_t choice) const;

  /// Evaluates y in place of x in one set-up, which has x and not y.
  [[nodiscard]] Rise rise_of_replace(std::size_t at, Element x, Element y) const;
  /// Makes this move; `rise` is the result of rise_of_replace().
  void replace(std::size_t at, Element x, Element y, const Rise& rise);

  /// Exchanges x and y in a stretch whose set-ups each have exactly one of them, where may_join()
  /// allows it. It is its own inverse.
  void exchange(Stretch where, Element x, Element y);
  /// Adds y to set-ups that have room and do not have it; the inverse of remove().
  void add(Stretch where, Element y);
  void remove(Stretch where, Element y);
  [[nodiscard]] Rise rise_of_take_out(std::size_t at) const;
  /// Evaluates a copy of a set-up directly after it, with y instead of x, or unchanged if y is x.
  [[nodiscard]] Rise rise_of_copy(std::size_t at, Element x, Element y) const;
  /// Removes a set-up and returns a handle with which put_back() inserts it before position `at`.
  [[nodiscard]] std::uint32_t take_out(std::size_t at);
  void put_back(std::size_t at, std::uint32_t handle);
  /// Inserts a set-up before position `at`; forget() frees the handle of a set-up that was removed
  /// for good.
  void insert(std::size_t at, std::span<const Element> setup);
  void forget(std::uint32_t handle) { free_.push_back(handle); }
  /// Reverses a stretch; its own inverse.
  void reverse(Stretch where);
  /// The change of the cost by reverse(). O(at_once).
  [[nodiscard]] std::int64_t rise_of_reverse(Stretch where) const;
  /// Swaps two adjacent stretches [first, middle) and [middle, end).
  void rotate(std::size_t first, std::size_t middle, std::size_t end);
  /// The change of the cost by rotate(). O(at_once).
  [[nodiscard]] std::int64_t rise_of_rotate(std::size_t first, std::size_t middle,
                                            std::size_t end) const;

 private:
  // A set-up is a handle: its parts, in any order, and its bits are at a fixed place.
  [[nodiscard]] Element* elements_of(std::uint32_t h) { return &elements_[h * room_]; }
  [[nodiscard]] const Element* elements_of(std::uint32_t h) const { return &elements_[h * room_]; }
  [[nodiscard]] const std::uint64_t* bits_of(std::uint32_t h) const { return &bits_[h * words_]; }
  [[nodiscard]] bool bit(std::uint32_t h, Element x) const {
    return (bits_[h * words_ + (x >> 6)] >> (x & 63) & 1) != 0;
  }
  void flip(std::uint32_t h, Element x) {
    bits_[h * words_ + (x >> 6)] ^= std::uint64_t{1} << (x & 63);
  }
  [[nodiscard]] bool has_to_spare(std::uint32_t h, Element x) const {
    const std::size_t s = fitting_.slot(x);
    return s == fitting_.slots() || of_slot_[h * fitting_.slots() + s] > fitting_.least(s);
  }
  [[nodiscard]] bool has_place(std::uint32_t h, Element y) const {
    const std::size_t s = fitting_.slot(y);
    return s == fitting_.slots() || of_slot_[h * fitting_.slots() + s] < fitting_.most(s);
  }
  // The start has a handle, too.
  [[nodiscard]] std::uint32_t before(std::size_t at) const { return at == 0 ? 0 : order_[at - 1]; }
  [[nodiscard]] std::int64_t weight(Element x) const {
    return static_cast<std::int64_t>(weights_.change[x]);
  }
  // The cost of the introductions from one set-up to the next.
  [[nodiscard]] std::int64_t step(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] std::int64_t step_into(std::size_t at) const {
    return at >= size() ? 0 : step(before(at), order_[at]);
  }
  // The cost of the introductions of x from position `first` to `last` + 1.
  [[nodiscard]] std::int64_t introductions(Element x, Stretch where) const;
  [[nodiscard]] std::int64_t rise_of_cost(std::size_t at, Element x, Element y) const;
  [[nodiscard]] std::uint32_t new_handle();
  void put(std::uint32_t h, Element y);
  void drop(std::uint32_t h, Element x);
  void cover(Element x, Element y);
  void uncover(Element x, Element y);
  void cover_all(std::uint32_t h);
  void uncover_all(std::uint32_t h);
  [[nodiscard]] std::size_t pair_index(Element x, Element y) const {
    return x < y ? std::size_t{y} * parts_ + x : std::size_t{x} * parts_ + y;
  }

  const Job* job_;
  Fitting fitting_;
  Weights weights_;
  std::size_t parts_;
  std::size_t room_;
  std::size_t words_;
  bool one_weight_ = false;
  bool has_never_ = false;
  std::vector<std::vector<std::uint64_t>> never_;  // by part, if there are forbidden pairs
  std::vector<Element> movable_;
  std::vector<bool> is_movable_;
  std::vector<std::uint64_t> movable_bits_;
  std::vector<Element> elements_;
  std::vector<std::uint32_t> sizes_;
  std::vector<std::uint64_t> bits_;
  std::vector<std::int64_t> mounting_;  // by handle: cost of mounting all of it on an empty bench
  std::vector<std::uint32_t> of_slot_;  // by handle and slot: number of its parts in the slot
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t>
      count_;  // by two parts: number of set-ups with both, plus one if they need not meet
  std::vector<std::uint32_t> uncovered_, place_;
  std::int64_t cost_ = 0;
  std::uint64_t occupied_ = 0;
};

}  // namespace changeover
