// What can be constructed, by whom it was found, and what it guarantees.
//
// Each construction is one file in src/construct/entries that defines a subclass of Construction
// and hands it out; the build collects them. A construction says what it can serve and how many
// blocks the result has *without* building it, so a table over thousands of parameters costs no
// blocks.
//
//     const Registry& registry = Registry::standard();
//     if (auto offer = registry.best({.v = 61, .k = 4, .kind = Kind::circular})) {
//       offer->b;                                          // 366
//       auto blocks = registry.build(offer->recipe);       // a stream; verify it before showing it
//     }
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/developed.hpp"
#include "changeover/core/fans.hpp"

namespace changeover {

class Catalog;
class Registry;

/// Where a construction comes from: a key of references.bib (docs/ of the sources) and a place in
/// it.
struct Citation {
  std::string key;    ///< e.g. "ChafeeStevens2025"
  std::string place;  ///< e.g. "Theorem 2"; may be empty

  /// "[ChafeeStevens2025, Theorem 2]"; "[elementary]" if neither key nor place is given.
  [[nodiscard]] std::string to_string() const;
};

/// What a construction promises for certain parameters.
struct Offer {
  Recipe recipe;
  std::uint64_t b = 0;         ///< number of blocks
  bool tight = false;          ///< every pair is newly covered exactly once, by theorem
  bool economical = false;     ///< b is the counting bound, by theorem; tight implies it
  bool expansion_set = false;  ///< an expansion set is known in closed form or was found
};

/// One way of making designs. Stateless; thread-safe.
class Construction {
 public:
  virtual ~Construction() = default;

  /// A short unique word, e.g. "cyclic-paper"; lower case, digits and hyphens.
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// One line: what it does.
  [[nodiscard]] virtual std::string_view summary() const = 0;
  /// One line: for which parameters it works, in the notation of the field.
  [[nodiscard]] virtual std::string_view preconditions() const = 0;
  /// One line: what is promised of the result.
  [[nodiscard]] virtual std::string_view guarantee() const = 0;
  [[nodiscard]] virtual Citation citation() const = 0;

  /// Whether offer() asks the registry for designs to work on. Such a construction asks only those
  /// that do not, or it says why its questions end.
  [[nodiscard]] virtual bool asks_registry() const { return false; }

  /// Whether exactly these parameters, kind included, can be served, and with what promise. Cheap:
  /// no blocks are built. Strength 2 only, unless said otherwise.
  [[nodiscard]] virtual std::optional<Offer> offer(const Parameters& p,
                                                   const Registry& registry) const = 0;

  /// The blocks of a recipe of this construction. Deterministic.
  /// @throws BadInput if the recipe's arguments, inputs or parameters do not fit this construction.
  [[nodiscard]] virtual std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                                           const Registry& registry) const = 0;

  /// An expansion set of the design that the recipe makes, one unchanged subset for each of its
  /// members in order of position, if one is known; see construct/expansion.hpp.
  [[nodiscard]] virtual std::optional<std::vector<UnchangedSubset>> expansion_set(
      const Recipe& recipe, const Registry& registry) const;

  /// The base blocks over Z_v of which the recipe's design is the development, if it is one: its
  /// differences then certify it (verify/difference.hpp).
  [[nodiscard]] virtual std::optional<BaseBlocks> base_blocks(const Recipe& recipe) const;

  /// The base blocks of the recipe's design under a permutation with several cycles, if it has such
  /// a development and the base blocks are not too many to write out.
  [[nodiscard]] virtual std::optional<OrbitBaseBlocks> orbit_base_blocks(
      const Recipe& recipe) const;

  /// The base blocks of base_blocks() that share an interval, without writing it out
  /// (verify/difference.hpp).
  [[nodiscard]] virtual std::optional<IntervalBaseBlocks> interval_base_blocks(
      const Recipe& recipe) const;

  /// The recipe's design as a stream of fans, if it has far fewer of them than blocks; nullptr
  /// otherwise: they then certify it (verify/fans.hpp). @throws as build().
  [[nodiscard]] virtual std::unique_ptr<FanSource> fans(const Recipe& recipe,
                                                        const Registry& registry) const;

  /// How this recipe makes its blocks, in one or two sentences with its numbers filled in, without
  /// its inputs: "Develop the base block {0,1,2,5} over Z_11."
  [[nodiscard]] virtual std::string explain(const Recipe& recipe) const;

  /// Names for the elements if the construction has its own (∞_s, 0_l, …); empty otherwise. The
  /// names of the inputs are kept; the registry is needed for these.
  [[nodiscard]] virtual std::vector<std::string> labels(const Recipe& recipe,
                                                        const Registry& registry) const;
};

/// How deep a recipe's inputs may be nested: far beyond any recipe of use, and safe to recurse
/// into.
inline constexpr std::size_t max_recipe_depth = 64;

/// A set of constructions, by name.
class Registry {
 public:
  /// The constructions of this library, and what the standard catalog knows
  /// (standard_catalog()).
  [[nodiscard]] static const Registry& standard();

  /// A registry of some constructions only, which must outlive it, and of a catalog, if one is
  /// given: its designs are offered too. @throws BadInput if two have the same name.
  explicit Registry(std::vector<const Construction*> constructions,
                    const Catalog* catalog = nullptr);

  /// The catalog whose designs are offered; nullptr if there is none.
  [[nodiscard]] const Catalog* catalog() const { return catalog_; }

  [[nodiscard]] std::span<const Construction* const> constructions() const {
    return constructions_;
  }

  /// The construction of that name, or nullptr.
  [[nodiscard]] const Construction* find(std::string_view name) const;

  /// The construction that a recipe names. @throws BadInput if there is none of that name, or if
  /// the recipe's inputs are nested deeper than max_recipe_depth.
  [[nodiscard]] const Construction& construction_of(const Recipe& recipe) const;

  /// Every offer for exactly these parameters, fewest blocks first, ties in the order of names,
  /// designs that are written down ("found") last; that of the catalog is among them if it has
  /// fewer blocks than any other; none if impossibility() rules them out. @throws as check().
  [[nodiscard]] std::vector<Offer> offers(const Parameters& p) const;

  /// The first of offers(); nullopt if no construction serves these parameters. @throws as check().
  [[nodiscard]] std::optional<Offer> best(const Parameters& p) const;

  /// The blocks of a recipe. @throws BadInput if a construction is unknown or its arguments, inputs
  /// or parameters do not fit.
  [[nodiscard]] std::unique_ptr<BlockSource> build(const Recipe& recipe) const;

  /// The design of a recipe as fans; each block is one if its construction has no others. @throws
  /// as build().
  [[nodiscard]] std::unique_ptr<FanSource> fans(const Recipe& recipe) const;

  /// The blocks of a recipe in memory, with labels and recipe. @throws as build() and read_all().
  [[nodiscard]] Design build_design(const Recipe& recipe) const;

  /// The parameters (v′, k′) nearest to (v, k), by |v−v′| + |k−k′|, with the same change and kind
  /// that some construction serves, nearest first and then by v′: the best offer for each of up to
  /// `limit` of them, v′ and k′ within `radius` of the asked ones. @throws as check(). O(radius²)
  /// offers.
  [[nodiscard]] std::vector<Offer> nearest(const Parameters& p, std::size_t limit,
                                           std::uint64_t radius) const;

 private:
  std::vector<const Construction*> constructions_;
  const Catalog* catalog_;
};

/// The constructions in src/construct/entries; this function is written by the build.
[[nodiscard]] std::vector<const Construction*> registry_entries();

// The catalog that everybody asks: the designs that come with the program, and the user's own.
//
//     if (const auto entry = standard_catalog().best({.v = 20, .k = 6, .change = 1})) {
//       entry->label();                                         // "20.6.1.linear.37.…"
//     }
//
// The user's file is $CHANGEOVER_CATALOG if that is set (empty: none), else changeover/catalog.db
// in $XDG_DATA_HOME, else in ~/.local/share. It is looked at when the catalog is first asked for
// anything.

/// Names another file for the user's designs, before the catalog is first asked; empty for none.
/// @throws BadOption if it was asked already.
void choose_catalog(std::string path);

/// The user's file, whether it is there or not; empty for none.
[[nodiscard]] std::string standard_catalog_file();

/// Whether the catalog that comes with the program has the best design of p that was known to all
/// constructions, closure rules and searches when it was made: strength 2, m = 1, 2, 3, and 3 ≤ k ≤
/// 40 and v ≤ 160.
[[nodiscard]] bool is_stored_cell(const Parameters& p);

/// What is wrong with the user's file, as Catalog::problem(); empty if the catalog was not asked
/// for anything.
[[nodiscard]] std::string standard_catalog_problem();

/// What else is to be said of it, as Catalog::remark(); empty if the catalog was not asked for
/// anything.
[[nodiscard]] std::string standard_catalog_remark();

/// The one catalog of this process.
[[nodiscard]] Catalog& standard_catalog();

}  // namespace changeover
