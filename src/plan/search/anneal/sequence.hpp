// The state of the search for cheap lists of set-ups: a list, its cost and what it leaves
// uncovered, kept up to date under every move.
//
// The frequent moves can be looked at before they are made: rise_of_replace(), rise_of_take_out()
// and the like say what they would add to cost() and to uncovered(), in O(at_once) and O(at_once²).
// The others are made at once and can be taken back by their inverse. A move on a stretch of L
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

/// What an introduction and a test weigh in a search; not always what they cost.
struct Weights {
  std::uint64_t test = 0;
  std::vector<std::uint64_t> change;  ///< by part
  std::uint64_t unit = 1;             ///< how many millionths a weight of 1 stands for

  /// The true costs in millionths; a change that costs nothing weighs one millionth, so that no
  /// search wanders among lists of many changes. If `tests` tests could overflow, a larger unit is
  /// taken and the weights are rounded up: no list weighs less than it costs.
  static Weights of(const Job& job, std::uint64_t tests);
};

/// A run of set-ups, both ends included.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// What a move would add.
struct Rise {
  std::int64_t cost = 0;
  std::int64_t uncovered = 0;
};

class Sequence {
 public:
  /// Set-ups that break no constraint but may leave pairs uncovered. The job must outlive this.
  /// @throws Stopped if the scope of this thread (run/control.hpp) wants to stop.
  Sequence(const Job& job, Weights weights, const std::vector<Block>& setups);

  [[nodiscard]] std::int64_t cost() const { return cost_; }
  [[nodiscard]] std::size_t uncovered() const { return uncovered_.size(); }
  [[nodiscard]] std::size_t size() const { return order_.size(); }
  [[nodiscard]] std::vector<Block> setups() const;
  /// The set-ups one after another, each with its size before its parts; setups_of() reads them.
  void write_to(std::vector<Element>& flat) const;
  [[nodiscard]] static std::vector<Block> setups_of(const std::vector<Element>& flat);
  [[nodiscard]] const Job& job() const { return *job_; }
  [[nodiscard]] const Weights& weights() const { return weights_; }

  /// Parts that a search may move: not mounted for good, and with a needed pair or of a slot that
  /// needs some.
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
  /// Room left over all set-ups.
  [[nodiscard]] std::uint64_t slack() const { return size() * room_ - occupied_; }
  /// Whether y may be where `leaving` goes; pass y itself if none goes.
  [[nodiscard]] bool may_join(std::size_t at, Element y, Element leaving) const;
  /// Whether the slot of x has a part to spare here.
  [[nodiscard]] bool may_leave(std::size_t at, Element x) const {
    return !fitting_.has_slots() || has_to_spare(order_[at], x);
  }
  /// Whether the slot of y has no place left here.
  [[nodiscard]] bool slot_full(std::size_t at, Element y) const {
    return fitting_.has_slots() && !has_place(order_[at], y);
  }
  [[nodiscard]] const Fitting& fitting() const { return fitting_; }

  /// Of the movable parts that position `in` has and `without` lacks, number `choice` modulo how
  /// many there are; nothing if there is none. Position size() stands for what is on the bench at
  /// the start.
  [[nodiscard]] std::optional<Element> some_difference(std::size_t in, std::size_t without,
                                                       std::uint32_t choice) const;

  /// y in place of x, which is there, in one set-up, which lacks y.
  [[nodiscard]] Rise rise_of_replace(std::size_t at, Element x, Element y) const;
  /// Makes it; `rise` is what rise_of_replace() says.
  void replace(std::size_t at, Element x, Element y, const Rise& rise);

  /// Exchanges x and y in a stretch whose set-ups hold exactly one of them, where may_join() allows
  /// it. Its own inverse.
  void exchange(Stretch where, Element x, Element y);
  /// Adds y to set-ups that have room for it and lack it; the inverse of remove().
  void add(Stretch where, Element y);
  void remove(Stretch where, Element y);
  [[nodiscard]] Rise rise_of_take_out(std::size_t at) const;
  /// What a copy of a set-up, right after it, with y for x or, if y is x, as it is, would add.
  [[nodiscard]] Rise rise_of_copy(std::size_t at, Element x, Element y) const;
  /// Takes out a set-up and returns a handle by which put_back() inserts it again, before position
  /// `at`.
  [[nodiscard]] std::uint32_t take_out(std::size_t at);
  void put_back(std::size_t at, std::uint32_t handle);
  /// A new set-up before position `at`; forget() frees the handle of one that was taken out for
  /// good.
  void insert(std::size_t at, std::span<const Element> setup);
  void forget(std::uint32_t handle) { free_.push_back(handle); }
  /// Reverses a stretch; its own inverse.
  void reverse(Stretch where);
  /// What reverse() would add to the cost. O(at_once).
  [[nodiscard]] std::int64_t rise_of_reverse(Stretch where) const;
  /// Swaps two adjacent stretches [first, middle) and [middle, end).
  void rotate(std::size_t first, std::size_t middle, std::size_t end);
  /// What rotate() would add to the cost. O(at_once).
  [[nodiscard]] std::int64_t rise_of_rotate(std::size_t first, std::size_t middle,
                                            std::size_t end) const;

 private:
  // A set-up is a handle: its parts, in no order, and its bits lie at a fixed place.
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
  // The start has a handle too.
  [[nodiscard]] std::uint32_t before(std::size_t at) const { return at == 0 ? 0 : order_[at - 1]; }
  [[nodiscard]] std::int64_t weight(Element x) const {
    return static_cast<std::int64_t>(weights_.change[x]);
  }
  // Of the introductions from one set-up to the next.
  [[nodiscard]] std::int64_t step(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] std::int64_t step_into(std::size_t at) const {
    return at >= size() ? 0 : step(before(at), order_[at]);
  }
  // Of the introductions of x from position `first` to `last` + 1.
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
  std::vector<std::int64_t> mounting_;  // by handle: of all changes that mount it on an empty bench
  std::vector<std::uint32_t> of_slot_;  // by handle and slot: its parts there
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t>
      count_;  // by two parts: set-ups that hold both, and one if they need not meet
  std::vector<std::uint32_t> uncovered_, place_;
  std::int64_t cost_ = 0;
  std::uint64_t occupied_ = 0;
};

}  // namespace changeover
