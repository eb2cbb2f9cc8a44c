// What the files in src/construct/entries share: what they say of themselves, recognising their own
// recipes, choosing a design to build on, and blocks as streams.
//
//     constexpr Description description{.name = "mcsorley-circular", …};
//     class McSorleyCircular final : public Described<Family, description> {
//       std::optional<Promise> promise(const Parameters& p) const override;
//       std::unique_ptr<BlockSource> blocks(const Parameters& p) const override;
//       std::string explanation(const Parameters& p) const override;
//     };
//
// A construction that has only one recipe for given parameters compares the whole of it: what is
// built is then what was offered, and nothing else in a recipe can be silently ignored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/construct/registry.hpp"

namespace changeover {

/// What a construction says of itself; see Construction.
struct Description {
  std::string_view name{};
  std::string_view summary{};
  std::string_view preconditions{};
  std::string_view guarantee{};
  std::string_view cited{};  ///< the key of what it is from, if it is from somewhere
  std::string_view place{};  ///< where it is there
};

/// A construction that is described by data.
class Entry : public Construction {
 public:
  [[nodiscard]] std::string_view name() const final { return description_.name; }
  [[nodiscard]] std::string_view summary() const final { return description_.summary; }
  [[nodiscard]] std::string_view preconditions() const final { return description_.preconditions; }
  [[nodiscard]] std::string_view guarantee() const final { return description_.guarantee; }
  [[nodiscard]] Citation citation() const final {
    return {std::string(description_.cited), std::string(description_.place)};
  }

  /// None: rules and lists make no offers, since those would recurse without end.
  [[nodiscard]] std::optional<Offer> offer(const Parameters&, const Registry&) const override {
    return std::nullopt;
  }

 protected:
  explicit Entry(const Description& description) : description_(description) {}

  /// A recipe of this construction.
  [[nodiscard]] Recipe recipe_of(const Parameters& p,
                                 std::map<std::string, std::int64_t> arguments = {},
                                 std::vector<Recipe> inputs = {}) const {
    return {std::string(name()), p, std::move(arguments), std::move(inputs), {}};
  }

  /// The argument `element` of a recipe whose one input has that element and the parameters
  /// `larger`, and that says nothing else. @throws BadInput, with what the rule takes
  [[nodiscard]] Element element_of(const Recipe& recipe, const Parameters& larger,
                                   std::string_view takes) const;

  /// @throws BadInput unless the recipe has one input, any recipe of the parameters `smaller`, and
  /// is else a recipe of this construction with these arguments.
  void require_input(const Recipe& recipe, const std::optional<Parameters>& smaller,
                     const std::map<std::string, std::int64_t>& arguments) const;

 private:
  Description description_;
};

/// An Entry, Family or Rule with this description.
template <typename Base, const Description& description>
class Described : public Base {
 protected:
  Described() : Base(description) {}
};

/// The one object of that kind: what an entry hands out.
template <typename T>
const Construction& only() {
  static const T construction;
  return construction;
}

/// What is promised of a design; see Offer.
struct Promise {
  std::uint64_t b = 0;
  bool tight = false;
  bool economical = false;
  bool expansion_set = false;
};

/// A construction with one recipe, which has no inputs, for all parameters that it serves.
class Family : public Entry {
 public:
  [[nodiscard]] std::optional<Offer> offer(const Parameters& p, const Registry&) const override;
  [[nodiscard]] std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                                   const Registry&) const override;
  [[nodiscard]] std::string explain(const Recipe& recipe) const override;

 protected:
  using Entry::Entry;

  /// nullopt if p is not served.
  [[nodiscard]] virtual std::optional<Promise> promise(const Parameters& p) const = 0;
  /// The recipe, of parameters that are served: what is in it besides the name, if anything.
  [[nodiscard]] virtual Recipe recipe_for(const Parameters& p) const { return recipe_of(p); }
  /// The blocks, and how they are made, of parameters that are served.
  [[nodiscard]] virtual std::unique_ptr<BlockSource> blocks(const Parameters& p) const = 0;
  [[nodiscard]] virtual std::string explanation(const Parameters& p) const = 0;

  /// The parameters of a recipe of this construction. @throws BadInput if it is none.
  const Parameters& required(const Recipe& recipe) const;
};

/// A rule that makes a design of another one, its one input, and a number that their parameters
/// tell.
class Rule : public Entry {
 protected:
  using Entry::Entry;

  /// The number; 0 if the rule does not lead from the one to the other. Kinds and strengths are the
  /// same.
  [[nodiscard]] virtual std::uint64_t number_between(const Parameters& small,
                                                     const Parameters& large) const = 0;
  /// The recipe of this rule.
  [[nodiscard]] virtual Recipe with(const Recipe& input, std::uint64_t number) const = 0;
  /// What it takes, for a message: "takes one input …".
  [[nodiscard]] virtual std::string_view needs() const = 0;

  /// The number of a recipe of this rule; the input may be any of the right parameters.
  /// @throws BadInput if the recipe is none.
  [[nodiscard]] std::uint64_t number(const Recipe& recipe) const;
};

/// Whether p asks that pairs be covered (strength 2) with m = change, and 2 ≤ k, m ≤ k ≤ v < 2³²,
/// so that products of two of its numbers fit in 64 bits. Never throws, unlike check().
[[nodiscard]] bool asks_for_pairs(const Parameters& p, std::uint64_t change);

/// @throws BadInput, in one line that says what does not fit and what would, unless `recipe` equals
/// `expected`, the only recipe of the construction for these parameters (nullopt if there is none).
void require_recipe(const Recipe& recipe, const Construction& construction,
                    const std::optional<Recipe>& expected);

/// The number of recipes in the tree, itself included.
[[nodiscard]] std::size_t recipe_size(const Recipe& recipe);

/// What a construction needs of the design that it works on.
enum class Need : std::uint8_t { blocks, expansion_set };

/// The offer to build on: of all constructions but `asking`, the one with the fewest blocks; ties
/// go to a tight one, then to one with an expansion set, then to the smaller recipe, then by name.
///
/// @note So that offers end, an entry that asks must ask for fewer elements or, as cut does, for a
/// circular design where a linear one is wanted.
[[nodiscard]] std::optional<Offer> best_input(const Parameters& p, Need need,
                                              const Construction& asking, const Registry& registry);

/// The offer with the fewest blocks of the constructions that do not ask the registry, so that
/// questions end.
[[nodiscard]] std::optional<Offer> best_that_asks_none(const Parameters& p, Need need,
                                                       const Registry& registry);

/// The same, where a circular design serves as a linear one, too, cut open.
[[nodiscard]] std::optional<Offer> best_leaf(const Parameters& p, const Registry& registry);

/// "0,1,2", or "0,…,9" when there are many; for explanations.
[[nodiscard]] std::string first_elements(std::uint64_t count);

/// The expansion set of an input. @throws BadInput if none is known.
[[nodiscard]] std::vector<UnchangedSubset> known_expansion_set(const Recipe& input,
                                                               const Registry& registry);

/// The labels of the recipe's one input.
[[nodiscard]] std::vector<std::string> labels_of_input(const Recipe& recipe,
                                                       const Registry& registry);

/// The same, and those of the elements that are new; see expanded_labels().
[[nodiscard]] std::vector<std::string> labels_with_new(const Recipe& recipe,
                                                       const Registry& registry);

/// Each block of `source` made into one of another design by `map`, which reads the one and writes
/// the other.
[[nodiscard]] std::unique_ptr<BlockSource> mapped(
    const Parameters& parameters, std::unique_ptr<BlockSource> source,
    std::function<void(std::span<const Element> from, std::span<Element> to)> map);

/// `copies` of every element x: copies·x, copies·x + 1, …
void blow_up(std::span<const Element> from, std::uint64_t copies, std::span<Element> to);

/// The same in each block of `source`.
[[nodiscard]] std::unique_ptr<BlockSource> blown_up(const Parameters& parameters,
                                                    std::unique_ptr<BlockSource> source,
                                                    std::uint64_t copies);

/// Each block of `source` with as many new elements, the last ones, as it lacks.
[[nodiscard]] std::unique_ptr<BlockSource> with_fixed(const Parameters& parameters,
                                                      std::unique_ptr<BlockSource> source);

/// `count` blocks, each written by its number 0, 1, …, count − 1.
[[nodiscard]] std::unique_ptr<BlockSource> numbered(
    const Parameters& parameters, std::uint64_t count,
    std::function<void(std::uint64_t number, std::span<Element> block)> write);

/// A stream that owns its list of blocks.
class BlockListSource final : public BlockByBlock<BlockListSource> {
 public:
  /// @throws BadInput unless `parameters` can be those of a design and each block has k distinct
  /// elements below v, at least one block. O(bk log k).
  BlockListSource(const Parameters& parameters, std::vector<Block> blocks);

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override { return blocks_.size(); }
  bool make(std::span<Element> block);
  bool rewind() override {
    position_ = 0;
    return true;
  }

 private:
  Parameters parameters_;
  std::vector<Block> blocks_;
  std::size_t position_ = 0;
};

}  // namespace changeover
