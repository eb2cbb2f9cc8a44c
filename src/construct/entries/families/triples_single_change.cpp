// The minimum SCCD(v,3), linear and circular, for every v ≥ 4. All of them are economical.
//
// v → v+4 adds 2v+3 blocks, by which the counting bounds grow as well: C(v+4,2) − C(v,2) = 2(2v+3).
#include <array>

#include "changeover/construct/registry.hpp"
#include "construct/tools/extended_minima.hpp"

namespace changeover::triples_single_change_entry {
namespace {

constexpr std::array<ListedMinimum, 5> linear{{
    {4, "012 023 123"},
    {5, "012 023 234 134 014"},
    {6, "012 023 234 245 045 145 135", true},
    {7, "012 023 234 134 345 346 046 056 256 156"},
    {8, "012 023 234 235 356 357 057 047 067 267 167 146 145 135", true},
}};

constexpr std::array<ListedMinimum, 5> circular{{
    {4, "012 023 013"},
    {5, "012 023 234 134 014"},
    {6, "012 023 034 345 245 145 135 015", true},
    {7, "012 023 034 345 135 356 056 256 246 146 014"},
    {8, "012 023 024 025 056 356 345 134 347 467 267 167 157 017", true},
}};

constexpr Description description{
    .name = "triples-single-change",
    .summary = "a small minimum SCCD(v,3) extended by four elements again and again",
    .preconditions = "m = 1, k = 3, v >= 4",
    .guarantee = "an economical SCCD(v,3), with an expansion set if v is even, 6 <= v <= 2^20",
    .cited = "WallisYucasZhang1993",
};

class TriplesSingleChange final : public ExtendedMinima {
 public:
  TriplesSingleChange() : ExtendedMinima(description, 3, linear, circular) {}
};

}  // namespace

const Construction& construction() { return only<TriplesSingleChange>(); }

}  // namespace changeover::triples_single_change_entry
