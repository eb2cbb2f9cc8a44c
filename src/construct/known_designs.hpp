// What is known of a cell: the one answer that every door gives, whatever else is asked.
//
//     KnownDesigns known(Registry::standard());
//     known.best({.v = 198, .k = 9});  // the same before and after any other question
//     known.best({.v = 199, .k = 9});  // cheaper now: both share most of what they come from
//
// The answer for a cell is defined by levels. Level 0 is the registry's best offer. Level 1 adds
// blowing up and interpolating from other change numbers, fixed elements and cuts. Each further
// level takes the best of the level below it and of what the rules make of cells around, as these
// are one level below: cut, coarsen, fix, unfix, truncate, close up, partial expansion, join ends;
// and needless blocks go. The answer is level 3, and 2 beyond v = 300.
//
// Each level refers to lower levels, to lower change numbers (and m = 1 to m = 2 without other
// change numbers), to the circular design, to smaller blocks or to fewer elements; so this ends. A
// source is left out where lower bounds show that it cannot help: that saves time and changes
// nothing. What else is asked, before or at once, has no influence.
//
// Two kinds of cells have no levels. One whose best is its lower bound is done. One that the
// catalog comes with was looked at with all others, again and again, when the catalog was made:
// there only designs of the user's can be news, and only they and what comes of them are followed.
//
// Results are kept, so a range is computed in one pass. Not thread-safe; each question has its own.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "changeover/construct/best_known.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/parameters.hpp"
#include "construct/tools/concatenation/groups.hpp"

namespace changeover {

class KnownDesigns {
 public:
  explicit KnownDesigns(const Registry& registry, Stored stored = Stored::as_shipped);

  /// The best recipe that is known for p; nullopt if there is none. Listens to the scope of this
  /// thread.
  /// @throws as check(); InternalError if a design that was built does not keep its promise.
  [[nodiscard]] std::optional<Offer> best(const Parameters& p);

  /// lower_bound(p), kept.
  [[nodiscard]] const Bound& bound(const Parameters& p);

 private:
  // A design that is known, and what the rules found when they looked at its blocks.
  struct Known {
    Offer offer;
    std::size_t depth = 0;  // of the recipe
    bool news = false;      // the user's, or made of one
    std::optional<std::optional<CoverPositions>> cover = {};
    std::optional<std::uint64_t> needed = {};
    std::optional<std::optional<Recipe>> unfixed = {};
    std::vector<std::shared_ptr<Known>> smaller = {};  // with 1, 2, … elements less
    bool no_smaller = false;                           // than the last of them
    std::optional<BestCut> cut = {};
    std::optional<std::vector<Hinge>> hinges = {};
  };
  using Ptr = std::shared_ptr<Known>;
  // Alone: without the rules that lead from other change numbers.
  using Key = std::tuple<Parameters, unsigned, bool>;
  class Cell;

  // Rules are not put on top of deeper recipes: these have a limited depth.
  static constexpr std::size_t deepest_chain = max_recipe_depth / 2;

  [[nodiscard]] static Ptr known(Offer offer, bool news);
  [[nodiscard]] Ptr at(const Parameters& p, unsigned level, bool alone);
  [[nodiscard]] Ptr offered(const Parameters& p);
  [[nodiscard]] bool possible(const Parameters& p);
  [[nodiscard]] bool comes_settled(const Parameters& p) const;

  // What the rules see in its blocks, looked at once. A design stays until some others were built.
  [[nodiscard]] const Design& design_of(const Ptr& known);
  [[nodiscard]] std::uint64_t needed_of(const Ptr& known);
  [[nodiscard]] const BestCut& cut_of(const Ptr& known, std::uint64_t enough);
  [[nodiscard]] const std::optional<Recipe>& unfixed_of(const Ptr& known);
  [[nodiscard]] const std::optional<CoverPositions>& cover_of(const Ptr& known);
  [[nodiscard]] Ptr smaller(const Ptr& from, std::size_t elements);
  [[nodiscard]] const std::vector<Hinge>& hinges_of(const Ptr& known);

  // Concatenation with groups, in known_groups.cpp.
  struct GroupCandidate;
  [[nodiscard]] const std::vector<Ptr>& with_groups_at(const Parameters& p);
  [[nodiscard]] const std::vector<Ptr>& bases_at(const Parameters& p);
  void add_candidates(const Parameters& p, const Parameters& base, std::uint64_t fewer_than,
                      std::vector<GroupCandidate>& found);
  void add_candidates(const Parameters& p, const Ptr& base, const Groups& groups,
                      std::uint64_t fewer_than, std::vector<GroupCandidate>& found);
  [[nodiscard]] Ptr built(const Parameters& p, const GroupCandidate& candidate);

  const Registry& registry_;
  Stored stored_;
  bool users_;  // The user has designs of their own.
  std::map<Key, Ptr> cells_;
  std::map<Parameters, Bound> bounds_;
  std::map<Parameters, bool> possible_;
  std::map<Parameters, std::vector<Ptr>> with_groups_, bases_;
  std::deque<std::pair<Ptr, Design>> designs_;  // built last
  std::uint64_t numbers_held_ = 0;
};

}  // namespace changeover
