// The verdict on a list of blocks: whether it is an m-change covering design, and its quality.
//
//     DesignSource source(design);
//     Verdict verdict = verify(source);
//     if (!verdict.valid()) {
//       verdict.bad_steps;            // how many steps do not change exactly m elements, and which
//       verdict.uncovered;            // how many pairs are in no block, and which
//     }
//
// Contract. The verdict rests on the blocks alone: it trusts nothing that made them, and nothing
// here includes a header of constructions, search or files. A pair S is *covered* (newly) in Bᵢ if
// S ⊂ Bᵢ and S ⊄ Bᵢ₋₁ [ChafeeStevens2025, Section 1]; in the first block of a linear design every
// pair is. A pair that is in *every* block of a circular design occurs but is never newly covered;
// the design is still valid, because the definition is "every pair occurs in some block", and such
// pairs are counted apart. A single block (b = 1, v = k) is valid in both kinds: it has no step,
// and all its pairs count as newly covered.
//
// Cost: one pass over the blocks, O(k) per block plus one bit set per newly covered t-subset, and
// C(v,t) bits of memory. For large blocks the bits take most of the time; for k = 4 half of it goes
// into looking up the last block of each element.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"

namespace changeover {

struct VerifyOptions {
  std::uint64_t examples = 20;  ///< how many bad steps and uncovered subsets to list
  /// Count the distinct unchanged subsets: 16 bytes of memory a block, and a sort at the end.
  bool unchanged = false;
};

/// A step whose blocks differ in the wrong number of elements; blocks numbered from 1, and the step
/// back from the last block of a circular design has to = 1.
struct BadStep {
  std::uint64_t from = 0;
  std::uint64_t to = 0;
  std::uint64_t changes = 0;

  bool operator==(const BadStep&) const = default;
};

/// Counts for one element.
struct ElementCount {
  std::uint64_t introductions = 0;  ///< i_x: blocks in which it is introduced
  std::uint64_t blocks = 0;         ///< r_x: blocks that contain it
  std::uint64_t covered = 0;        ///< newly covered pairs that contain it, with repetition
  std::uint64_t excess = 0;         ///< e_x: `covered` less the distinct pairs among them

  bool operator==(const ElementCount&) const = default;
};

struct Verdict {
  Parameters parameters;
  std::uint64_t b = 0;  ///< number of blocks

  std::uint64_t bad_steps = 0;
  std::vector<BadStep> bad_step_examples;

  std::uint64_t subsets = 0;    ///< C(v,t): subsets that must occur
  std::uint64_t uncovered = 0;  ///< t-subsets that are in no block
  std::vector<Block> uncovered_examples;

  std::uint64_t covered = 0;  ///< newly covered t-subsets, with repetition
  std::uint64_t never_newly_covered =
      0;                     ///< t-subsets that are in every block of a circular design
  std::uint64_t excess = 0;  ///< `covered` less the distinct t-subsets among them

  std::vector<Element> fixed;          ///< elements that are in every block
  std::vector<ElementCount> elements;  ///< by element; `covered` and `excess` for strength 2 only
  /// i_x(k−1) + m(r_x − i_x) = v − 1 + e_x for every x, less the f − 1 pairs that are never newly
  /// covered at each of f ≥ 2 fixed elements, and Σe_x is twice the excess, which is counted from
  /// the pairs. Strength 2 only; false for an invalid list.
  bool degree_identity = false;

  std::optional<std::uint64_t> unchanged_subsets;  ///< distinct unchanged subsets, if asked for
  std::vector<Element> never_unchanged;  ///< elements that are in no unchanged subset Bᵢ ∩ Bᵢ₊₁

  /// ⌈g₁⌉ or ⌈g₂⌉ of [ChafeeStevens2025, Theorem 1], for any m and t: linear
  /// ⌈(C(v,t) − C(k,t)) / p⌉ + 1, circular ⌈C(v,t) / p⌉, p = C(k,t) − C(k−m,t); 1 if v = k. A
  /// circular design with two or more fixed elements may have fewer blocks.
  std::uint64_t counting_bound = 0;

  /// Whether it is a change covering design with these parameters.
  [[nodiscard]] bool valid() const { return b > 0 && bad_steps == 0 && uncovered == 0; }
  /// Whether it is valid and every t-subset is newly covered exactly once.
  [[nodiscard]] bool tight() const { return valid() && excess == 0 && never_newly_covered == 0; }
  /// Whether it is valid and has exactly counting_bound blocks.
  [[nodiscard]] bool economical() const { return valid() && b == counting_bound; }

  bool operator==(const Verdict&) const = default;
};

/// Reads the stream to its end and returns the verdict on it.
/// @throws BadInput if a block has a repeated element or one that is not below v;
/// ImpossibleParameters as check(); MissingResource if v exceeds max_elements_in_memory or C(v,t)
/// bits exceed 4 GiB.
[[nodiscard]] Verdict verify(BlockSource& source, const VerifyOptions& options = {});

/// The verdict on a design in memory. @throws as above.
[[nodiscard]] Verdict verify(const Design& design, const VerifyOptions& options = {});

/// A verdict on blocks that are passed one batch after another, while the caller also uses them for
/// something else:
///
///     RunningVerdict running(parameters);
///     for_each_batch(source, [&](std::span<const Element> blocks) {
///       running.add(blocks);
///       write(blocks);
///     });
///     Verdict verdict = running.finish();
class RunningVerdict {
 public:
  /// @throws ImpossibleParameters and MissingResource as verify().
  explicit RunningVerdict(const Parameters& p, const VerifyOptions& options = {});
  ~RunningVerdict();
  RunningVerdict(const RunningVerdict&) = delete;
  RunningVerdict& operator=(const RunningVerdict&) = delete;

  /// The next block, or blocks, one after another. @throws BadInput as verify(), and unless they
  /// have k elements each.
  void add(std::span<const Element> blocks);

  /// The verdict on all blocks. Call it once, at the end.
  [[nodiscard]] Verdict finish();

 private:
  struct State;
  template <typename Set>
  struct StateOf;

  std::uint64_t k_;
  std::unique_ptr<State> state_;
};

// A design that was verified: its type says so, and a function that takes one need not verify
// again.
//
//     if (const auto found = verified(std::move(design))) {
//       found->block_count();                 // as of the design
//       found->verdict().tight();
//       const Design& blocks = *found;        // read-only; a copy counts as not verified
//     }
//
// Only the functions below make one, and they read every block.

class VerifiedDesign {
 public:
  [[nodiscard]] const Design& design() const { return design_; }
  // NOLINTNEXTLINE(google-explicit-constructor): a verified design is a design
  operator const Design&() const { return design_; }
  /// The design itself, which may be changed and no longer counts as verified.
  [[nodiscard]] Design take() && { return std::move(design_); }

  [[nodiscard]] const Verdict& verdict() const { return verdict_; }

  [[nodiscard]] const Parameters& parameters() const { return design_.parameters(); }
  [[nodiscard]] std::size_t block_count() const { return design_.block_count(); }
  [[nodiscard]] std::span<const Element> block(std::size_t index) const {
    return design_.block(index);
  }
  [[nodiscard]] std::vector<Block> blocks() const { return design_.blocks(); }
  [[nodiscard]] const std::vector<std::string>& labels() const { return design_.labels(); }
  [[nodiscard]] const std::optional<Recipe>& recipe() const { return design_.recipe; }
  /// Records how the blocks were made; the blocks stay the same.
  void set_recipe(Recipe recipe) { design_.recipe = std::move(recipe); }

 private:
  friend std::optional<VerifiedDesign> verified(Design design);
  VerifiedDesign(Design design, Verdict verdict)
      : design_(std::move(design)), verdict_(std::move(verdict)) {}

  Design design_;
  Verdict verdict_;
};

/// The design, if verify() finds it valid; nothing otherwise. @throws as verify().
[[nodiscard]] std::optional<VerifiedDesign> verified(Design design);

/// The design, verified, if it must be valid. `what` names it in the message, as in "a repaired
/// DCCD(60,5)". @throws InternalError if it is not.
[[nodiscard]] VerifiedDesign surely_verified(Design design, std::string_view what);

}  // namespace changeover
