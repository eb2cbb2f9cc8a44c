// A set of clauses under unit propagation.
//
//     ClauseStore store(limits);
//     store.add({1, 2});                // normalised: no repeated literals
//     store.implies({1});               // does unit propagation from ¬1 meet a contradiction?
//     store.contradictory();            // does unit propagation from nothing?
//
// Two literals of each clause are watched. What propagates from no assumption at all is kept: "the
// fixed literals", and the clauses that fixed them are never deleted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace changeover {

class ClauseStore {
 public:
  /// `ask` is called every million looks at a clause or so; it throws to give up.
  explicit ClauseStore(std::uint64_t max_literals, std::function<void()> ask = {})
      : max_literals_(max_literals), ask_(std::move(ask)) {
    buckets_.resize(std::size_t{1} << 10, none);
  }

  /// Makes room for variables up to this one.
  void reserve(std::uint64_t variable);

  /// Adds a clause, without a proof. Literals are distinct and do not contradict each other.
  /// @throws MissingResource if there are too many literals.
  void add(std::span<const std::int32_t> clause);

  /// Deletes one copy of a clause; false if there is none, or if it has one literal or fixed one.
  bool remove(std::span<const std::int32_t> clause);

  /// Whether assuming all literals of `clause` false makes unit propagation meet a contradiction.
  [[nodiscard]] bool implies(std::span<const std::int32_t> clause);

  /// Whether, besides, it does so for each clause on −pivot whose other literals are assumed false
  /// too.
  [[nodiscard]] bool implies_resolvents(std::span<const std::int32_t> clause, std::int32_t pivot);

  [[nodiscard]] bool contradictory() const { return contradictory_; }
  [[nodiscard]] std::uint64_t propagations() const { return propagations_; }

 private:
  using Literal = std::uint32_t;  // 2x or 2x + 1
  using Reference = std::uint32_t;
  static constexpr Reference none = 0xffffffffU;

  // A clause in the arena: size and flags, hash, next of its bucket, and then the literals.
  static constexpr std::size_t head = 3;
  static constexpr std::uint32_t dead_flag = 1U << 31;
  static constexpr std::uint32_t fixing_flag = 1U << 30;
  static constexpr std::uint32_t size_mask = fixing_flag - 1;

  struct Watch {
    Reference clause;
    Literal other;  // a literal of the clause: if it is true, the clause need not be looked at
  };

  static Literal literal(std::int32_t x) {
    return x > 0 ? 2 * static_cast<Literal>(x) : 2 * static_cast<Literal>(-x) + 1;
  }
  [[nodiscard]] std::uint32_t size_of(Reference c) const { return arena_[c] & size_mask; }
  [[nodiscard]] bool dead(Reference c) const { return (arena_[c] & dead_flag) != 0; }

  void assign(Literal l) {
    value_[l] = 1;
    value_[l ^ 1] = -1;
    trail_.push_back(l);
  }
  bool assume_false(std::span<const std::int32_t> clause);
  void undo(std::size_t length);
  bool propagate(bool for_good);
  bool fix(Reference c, Literal l);
  void watch(Reference c);
  [[nodiscard]] Reference find(std::span<const std::int32_t> clause, std::uint32_t hash,
                               Reference* before);
  static std::uint32_t hash_of(std::span<const std::int32_t> clause);
  void grow_buckets();
  void compact();
  void looked(std::size_t clauses);

  std::uint64_t max_literals_;
  std::function<void()> ask_;
  std::uint64_t looks_ = 0;  // since it was asked
  std::vector<std::uint32_t> arena_;
  std::vector<Reference> buckets_;
  std::vector<std::vector<Watch>> watches_;  // by literal: looked at when it becomes false
  std::vector<std::int8_t> value_;           // by literal: 1 true, −1 false
  std::vector<std::uint8_t> mark_;           // by literal, for comparing clauses
  std::vector<Literal> trail_;
  std::size_t propagated_ = 0;
  std::size_t count_ = 0;       // of clauses alive
  std::size_t dead_words_ = 0;  // of the arena
  std::uint64_t propagations_ = 0;
  bool contradictory_ = false;
};

}  // namespace changeover
