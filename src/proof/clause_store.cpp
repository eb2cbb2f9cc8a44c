#include "proof/clause_store.hpp"

#include <fmt/format.h>

#include <utility>

#include "changeover/core/error.hpp"

namespace changeover {

void ClauseStore::reserve(std::uint64_t variable) {
  const std::size_t literals = 2 * static_cast<std::size_t>(variable) + 2;
  if (value_.size() < literals) {
    value_.resize(literals, 0);
    mark_.resize(literals, 0);
    watches_.resize(literals);
  }
}

std::uint32_t ClauseStore::hash_of(std::span<const std::int32_t> clause) {
  std::uint64_t sum = clause.size();
  for (const std::int32_t x : clause) {  // commutative: the order of literals means nothing
    std::uint64_t z = literal(x) * 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 29)) * 0xbf58476d1ce4e5b9U;
    sum += z ^ (z >> 32);
  }
  return static_cast<std::uint32_t>(sum ^ (sum >> 32));
}

void ClauseStore::add(std::span<const std::int32_t> clause) {
  if (arena_.size() + head + clause.size() > std::min<std::uint64_t>(max_literals_, none - 1)) {
    compact();
    if (arena_.size() + head + clause.size() > std::min<std::uint64_t>(max_literals_, none - 1)) {
      throw MissingResource(
          fmt::format("more than {} literals at once: raise the checker's limit", max_literals_));
    }
  }
  const auto c = static_cast<Reference>(arena_.size());
  const std::uint32_t hash = hash_of(clause);
  if (count_ >= buckets_.size()) {
    grow_buckets();
  }
  Reference& bucket = buckets_[hash & (buckets_.size() - 1)];
  arena_.insert(arena_.end(), {static_cast<std::uint32_t>(clause.size()), hash, bucket});
  bucket = c;
  ++count_;
  // Those that are not false come first: they are watched.
  std::size_t open = 0;
  for (const std::int32_t x : clause) {
    arena_.push_back(literal(x));
    if (value_[literal(x)] >= 0) {
      std::swap(arena_.back(), arena_[c + head + open]);
      ++open;
    }
  }
  if (clause.size() >= 2) {
    watch(c);
  }
  if (open == 0) {
    arena_[c] |= fixing_flag;
    contradictory_ = true;
  } else if (open == 1) {
    const Literal l = arena_[c + head];
    if (value_[l] == 0 && !fix(c, l)) {
      contradictory_ = true;
    }
  }
}

bool ClauseStore::fix(Reference c, Literal l) {
  arena_[c] |= fixing_flag;
  assign(l);
  return propagate(true);
}

void ClauseStore::watch(Reference c) {
  const Literal first = arena_[c + head];
  const Literal second = arena_[c + head + 1];
  watches_[first].push_back({c, second});
  watches_[second].push_back({c, first});
}

bool ClauseStore::remove(std::span<const std::int32_t> clause) {
  const std::uint32_t hash = hash_of(clause);
  Reference before = none;
  const Reference c = find(clause, hash, &before);
  if (c == none || clause.size() == 1 || (arena_[c] & fixing_flag) != 0) {
    return false;
  }
  const std::uint32_t next = arena_[c + 2];
  (before == none ? buckets_[hash & (buckets_.size() - 1)] : arena_[before + 2]) = next;
  arena_[c] |= dead_flag;
  --count_;
  dead_words_ += head + clause.size();
  if (dead_words_ > (std::size_t{1} << 16) && 2 * dead_words_ > arena_.size()) {
    compact();
  }
  return true;
}

ClauseStore::Reference ClauseStore::find(std::span<const std::int32_t> clause, std::uint32_t hash,
                                         Reference* before) {
  for (const std::int32_t x : clause) {
    mark_[literal(x)] = 1;
  }
  Reference c = buckets_[hash & (buckets_.size() - 1)];
  for (; c != none; *before = c, c = arena_[c + 2]) {
    if (arena_[c + 1] != hash || size_of(c) != clause.size()) {
      continue;
    }
    std::size_t same = 0;
    while (same < clause.size() && mark_[arena_[c + head + same]] != 0) {
      ++same;
    }
    if (same == clause.size()) {
      break;
    }
  }
  for (const std::int32_t x : clause) {
    mark_[literal(x)] = 0;
  }
  return c;
}

void ClauseStore::grow_buckets() {
  buckets_.assign(2 * buckets_.size(), none);
  for (std::size_t c = 0; c < arena_.size(); c += head + size_of(static_cast<Reference>(c))) {
    if (!dead(static_cast<Reference>(c))) {
      Reference& bucket = buckets_[arena_[c + 1] & (buckets_.size() - 1)];
      arena_[c + 2] = bucket;
      bucket = static_cast<Reference>(c);
    }
  }
}

// Moves the clauses that are alive together; the watched literals stay watched.
void ClauseStore::compact() {
  std::vector<std::uint32_t> kept;
  kept.reserve(arena_.size() - dead_words_);
  for (std::size_t c = 0; c < arena_.size();) {
    const std::size_t words = head + size_of(static_cast<Reference>(c));
    if (!dead(static_cast<Reference>(c))) {
      const auto place = static_cast<std::uint32_t>(kept.size());
      const auto from = arena_.begin() + static_cast<std::ptrdiff_t>(c);
      kept.insert(kept.end(), from, from + static_cast<std::ptrdiff_t>(words));
      arena_[c + 2] = place;  // where watches find it
    }
    c += words;
  }
  for (std::vector<Watch>& list : watches_) {
    std::size_t size = 0;
    for (const Watch& entry : list) {
      if (!dead(entry.clause)) {
        list[size++] = {arena_[entry.clause + 2], entry.other};
      }
    }
    list.resize(size);
  }
  arena_.swap(kept);
  dead_words_ = 0;
  buckets_.resize(buckets_.size() / 2);
  grow_buckets();
}

bool ClauseStore::assume_false(std::span<const std::int32_t> clause) {
  for (const std::int32_t x : clause) {
    const Literal l = literal(x);
    if (value_[l] > 0) {
      return false;
    }
    if (value_[l] == 0) {
      assign(l ^ 1);
    }
  }
  return true;
}

void ClauseStore::undo(std::size_t length) {
  while (trail_.size() > length) {
    const Literal l = trail_.back();
    value_[l] = 0;
    value_[l ^ 1] = 0;
    trail_.pop_back();
  }
  propagated_ = length;
}

void ClauseStore::looked(std::size_t clauses) {
  constexpr std::uint64_t often = 1'000'000;
  looks_ += clauses;
  if (looks_ >= often) {
    looks_ = 0;
    if (ask_) {
      ask_();
    }
  }
}

// False if a clause has become false.
bool ClauseStore::propagate(bool for_good) {
  while (propagated_ < trail_.size()) {
    const Literal now_false = trail_[propagated_++] ^ 1;
    ++propagations_;
    std::vector<Watch>& list = watches_[now_false];
    const std::size_t size = list.size();
    looked(size);
    std::size_t from = 0;
    std::size_t to = 0;
    bool conflict = false;
    while (from < size) {
      const Watch entry = list[from++];
      if (value_[entry.other] > 0) {
        list[to++] = entry;
        continue;
      }
      std::uint32_t* const c = arena_.data() + entry.clause;
      if ((c[0] & dead_flag) != 0) {
        continue;
      }
      std::uint32_t* const literals = c + head;
      const Literal other = literals[0] ^ literals[1] ^ now_false;
      if (value_[other] > 0) {
        list[to++] = {entry.clause, other};
        continue;
      }
      const std::uint32_t length = c[0] & size_mask;
      std::uint32_t i = 2;
      while (i < length && value_[literals[i]] < 0) {
        ++i;
      }
      if (i < length) {
        const Literal next = literals[i];
        literals[i] = now_false;
        literals[0] = other;
        literals[1] = next;
        watches_[next].push_back({entry.clause, other});
        continue;
      }
      list[to++] = {entry.clause, other};
      if (for_good) {
        c[0] |= fixing_flag;
      }
      if (value_[other] < 0) {
        conflict = true;
        break;
      }
      assign(other);
    }
    while (from < size) {
      list[to++] = list[from++];
    }
    list.resize(to);
    if (conflict) {
      return false;
    }
  }
  return true;
}

bool ClauseStore::implies(std::span<const std::int32_t> clause) {
  const std::size_t fixed = trail_.size();
  const bool consistent = assume_false(clause) && propagate(false);
  undo(fixed);
  return !consistent;
}

bool ClauseStore::implies_resolvents(std::span<const std::int32_t> clause, std::int32_t pivot) {
  const std::size_t fixed = trail_.size();
  bool all = true;
  if (assume_false(clause) && propagate(false)) {
    const std::size_t assumed = trail_.size();
    const Literal negated = literal(-pivot);
    std::vector<std::int32_t> rest;
    for (std::size_t c = 0; all && c < arena_.size();
         c += head + size_of(static_cast<Reference>(c))) {
      looked(1);
      if (dead(static_cast<Reference>(c))) {
        continue;
      }
      bool resolves = false;
      rest.clear();
      for (std::size_t i = c + head; i < c + head + size_of(static_cast<Reference>(c)); ++i) {
        const Literal l = arena_[i];
        if (l == negated) {
          resolves = true;
        } else {
          const auto variable = static_cast<std::int32_t>(l / 2);
          rest.push_back(l % 2 == 0 ? variable : -variable);
        }
      }
      if (resolves) {
        all = !(assume_false(rest) && propagate(false));
        undo(assumed);
      }
    }
  }
  undo(fixed);
  return all;
}

}  // namespace changeover
