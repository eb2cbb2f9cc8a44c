// 3-change designs near the bound: what a cyclic list of base blocks leaves is split into classes
// of triangles, and these pass beside new elements that are held [docs/theorems.md, Theorem 34].
#include <fmt/format.h>

#include <memory>
#include <string>

#include "construct/entry.hpp"
#include "construct/tools/cyclic.hpp"
#include "construct/tools/leave/held_classes.hpp"
#include "construct/tools/leave/triple_leave.hpp"

namespace changeover::held_triangles_entry {
namespace {

constexpr Description description{
    .name = "held-triangles",
    .summary =
        "a cyclic list, and classes of triangles that it leaves beside groups of new elements",
    .preconditions = "m = 3, 4 <= k <= 64, v = 6c(k-2)+(k-1)t-2j+1 or one less, c <= 13 as known",
    .guarantee =
        "over the counting bound by a number of k alone, and about 2cj, c more for even v-(k-3)t",
    .place = "docs/theorems.md, Theorem 34",
};

constexpr std::uint64_t largest_k = 64;

std::shared_ptr<const TripleLeave> leave_of(const Parameters& p) {
  if (!asks_for_pairs(p, 3) || p.k > largest_k) {
    return nullptr;
  }
  return TripleLeave::of(p.k, p.v);
}

class HeldTriangles final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    auto leave = leave_of(p);
    return leave ? std::optional(Promise{.b = held_classes_count(p, std::move(leave))})
                 : std::nullopt;
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return held_classes_source(p, leave_of(p));
  }

  std::string explanation(const Parameters& p) const override {
    const auto leave = leave_of(p);
    const std::uint64_t n = p.k - 3;
    const std::uint64_t w = leave->elements();
    const std::uint64_t t = leave->groups();
    const std::string developed =
        explain_development(p.on(w), n, leave->base_blocks(), leave->points());
    std::string twice =
        leave->is_doubled() ? fmt::format(" Pairs with the difference {} come twice.", w / 2) : "";
    if (const std::uint64_t surplus = 3 * leave->base_blocks() * (p.k - 2) + t - w / 2) {
      twice += surplus == 1 ? " One of their differences repeats another."
                            : fmt::format(" {} of their differences repeat others.", surplus);
    }
    const std::string beside =
        t == 1
            ? fmt::format(
                  "They are those of {} triangles that hold every element of Z_{}. "
                  "These pass beside {}.",
                  w / 3, w,
                  n == 1 ? "a new element that is held"
                         : fmt::format("{} new elements that are held", n))
            : fmt::format(
                  "They are those of {} classes of {} triangles; each class holds every "
                  "element of Z_{}, and passes beside {}, which is held in a short list "
                  "on all {} new elements.",
                  t, w / 3, w,
                  n == 1 ? "a new element" : fmt::format("a group of {} new elements", n), n * t);
    return fmt::format("{}{} This leaves the pairs with the difference{} {}. {}", developed, twice,
                       t == 1 ? "" : "s", fmt::join(leave->differences(), ", "), beside);
  }
};

}  // namespace

const Construction& construction() { return only<HeldTriangles>(); }

}  // namespace changeover::held_triangles_entry
