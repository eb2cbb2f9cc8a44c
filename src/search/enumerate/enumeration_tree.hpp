// The search tree of one case: partial designs, block after block.
//
// A node is a list of blocks; its children are the blocks that may follow. Elements with the same
// past (twins) are always neighbours in number, kept as one bit for each element that is a twin of
// the one below it, so that a block is in standard form if of each run of twins it holds the
// lowest. Going down copies the masks of missing pairs, 8v bytes; going up costs nothing.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "search/enumerate/enumeration_case.hpp"
#include "search/enumerate/enumeration_degrees.hpp"

namespace changeover {

/// Who explores a tree.
class EnumerationVisitor {
 public:
  virtual ~EnumerationVisitor() = default;

  /// The blocks 0, …, depth of a node at the depth that was asked for, as masks; false stops.
  virtual bool reached(std::span<const std::uint64_t> blocks) = 0;

  /// Asked every thousand nodes or so, and where there are none in between; false stops. `nodes` is
  /// how many were met since the last time.
  virtual bool go_on(std::uint64_t nodes) = 0;

 protected:
  EnumerationVisitor() = default;
  EnumerationVisitor(const EnumerationVisitor&) = default;
  EnumerationVisitor& operator=(const EnumerationVisitor&) = default;
};

class EnumerationTree {
 public:
  /// Keeps references.
  EnumerationTree(const EnumerationCase& own, const DegreeTable& degrees);

  /// What one takes for b blocks.
  [[nodiscard]] static std::uint64_t bytes(std::uint64_t b) {
    return b * (sizeof(Level) + sizeof(Mask));
  }

  /// Visits, from left to right, all nodes at `depth` below the node with these blocks, whose first
  /// is the first block; depth b−1 are the designs. Returns false if the visitor stopped it.
  bool explore(std::span<const std::uint64_t> blocks, std::size_t depth,
               EnumerationVisitor& visitor);

 private:
  using Mask = std::uint64_t;

  struct Level {
    Mask block = 0;
    Mask twins = 0;      // x is a twin of x − 1
    Mask first_run = 0;  // has been in every block so far
    std::int64_t excess = 0;
    std::array<Mask, 64> missing{};
    std::array<std::uint8_t, 64> still{};  // how many are missing
    std::array<std::int16_t, 64>
        run_begin{};  // of elements in the block; −1: before the first block
    std::array<std::int16_t, 64>
        first_end{};  // blocks of the first run that began before the first block
  };

  // What the choice of the next block needs at hand, for one node.
  struct Choice {
    std::size_t depth = 0;
    const DegreeTable::Row* row = nullptr;
    std::uint64_t all_out = 0;    // costs of the elements outside, if they stay there
    std::uint64_t base = 0;       // all_out and the costs of those that leave
    std::uint64_t allowance = 0;  // without further excess
    bool lanes_full = false;      // the allowance was cut: do not subtract from it
    Mask must_leave = 0;
    Mask must_stay = 0;
    Mask stay = 0;
  };

  bool expand(std::size_t depth);
  bool may_go_on();
  bool choose_leaving(Choice& choice, Mask from, Mask leaving, std::size_t more);
  bool introduce(const Choice& choice, Mask from, Mask introduced, std::size_t more,
                 std::int64_t excess);
  bool enter(const Choice& choice, Mask introduced, std::int64_t excess);
  void descend(std::size_t depth, Mask block, std::int64_t excess);
  void follow_runs(std::size_t depth);
  void limit_runs(Choice& choice) const;
  [[nodiscard]] bool runs_begin_well(std::size_t depth) const;
  [[nodiscard]] bool is_design() const;

  [[nodiscard]] std::uint64_t cost(const Choice& choice, std::size_t x, bool in,
                                   std::size_t missing) const;

  const EnumerationCase& own_;
  const DegreeTable& degrees_;
  std::vector<Level> levels_;
  std::vector<Mask> path_;
  std::array<std::size_t, 64> role_offset_{};
  EnumerationVisitor* visitor_ = nullptr;
  std::size_t target_ = 0;
  std::uint64_t nodes_ = 0;  // since the visitor was told
  unsigned choices_ = 0;
};

}  // namespace changeover
