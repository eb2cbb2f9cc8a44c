// The minimum SCCD(v,4), linear and circular, for every v ≥ 5.
//
// v → v+6 adds 2v+5 blocks, by which the counting bounds grow as well: C(v+6,2) − C(v,2) = 3(2v+5).
// All are economical but the circular one with v = 5, which has one block less than the bound, for
// two elements are in all its blocks, and the linear ones with v = 6, 7, 9, 10, which have one
// block more. That these are minimum is known by exhaustive search; they are circular designs.
#include <array>

#include "changeover/construct/registry.hpp"
#include "construct/tools/extended_minima.hpp"

namespace changeover::quadruples_single_change_entry {
namespace {

constexpr ListedMinimum five{5, "0123 0234 1234"};
constexpr ListedMinimum six{6, "0123 0234 2345 1245 0125"};
constexpr ListedMinimum seven{7, "0123 0234 2345 3456 1456 0156 0126"};
constexpr std::string_view nine = "0123 0234 0245 0456 1456 1457 4578 3578 3678 2678 0278 0128";
constexpr ListedMinimum ten{
    10, "0123 0234 2345 2356 2367 2378 3789 5789 0578 1578 1478 1468 1469 0169 0129"};

constexpr std::array<ListedMinimum, 11> linear{{
    five,
    six,
    seven,
    {8, "0123 0234 0235 0256 0257 1257 1457 1467 1367"},
    {9, nine},
    ten,
    {11,
     "0123 0234 0235 0236 0237 2378 2379 239a 289a 089a 189a 489a 4689 5689 5678 567a 1567 1457"},
    {12,
     "0123 0234 2345 2356 2567 2578 1578 1789 3789 378a 378b 078b 478b 468b 146b 14ab 49ab 29ab "
     "59ab 059a 069a",
     true},
    {13,
     "0123 0234 2345 2356 2567 2578 5789 4789 1789 3789 0789 089a 0689 689b 89bc 29bc 2abc 3abc "
     "7abc 5abc 05bc 15bc 14bc 146c 146a"},
    {15,
     "0123 0234 0245 0246 0267 0678 6789 3678 368a 3568 568b 1568 568c 68cd 68de 48de 28de 2ade "
     "0ade 5ade 59de 57de 7bde 1bde 3bde 3bce 39bc 09bc 29bc 9abc 49ab 149a 147a 147c",
     true},
    {16,
     "012f 0123 0234 0245 0246 0267 0678 6789 3678 368a 3568 568f 568b 1568 568c 68cd 68de 48de "
     "28de 2ade 0ade 5ade 59de 57de 7def 7bde 1bde 3bde 3bce 3bcf 39bc 09bc 29bc 9abc 49ab 49af "
     "149a 147a 147c"},
}};

constexpr std::array<ListedMinimum, 8> circular{{
    five,
    six,
    seven,
    {8, "0123 0234 2345 2356 3567 0567 1567 1467 1267 0127"},
    {9, nine, true},
    ten,
    {11,
     "0123 0124 0125 0156 1567 4567 5678 3567 3569 356a 236a 238a 348a 489a 089a 189a 179a 1279 "
     "0127"},
    {12,
     "0123 0124 1245 1456 3456 3567 3568 3569 359a 35ab 05ab 06ab 26ab 27ab 17ab 18ab 48ab 489b "
     "4789 0789 0289 0129",
     true},
}};

constexpr Description description{
    .name = "quadruples-single-change",
    .summary = "a small minimum SCCD(v,4) extended by six elements again and again",
    .preconditions = "m = 1, k = 4, v >= 5",
    .guarantee =
        "a minimum SCCD(v,4); an expansion set if 3 | v <= 2^20, v >= 12 or circular with v = 9",
    .cited = "ChafeeStevens2023",
};

class QuadruplesSingleChange final : public ExtendedMinima {
 public:
  QuadruplesSingleChange() : ExtendedMinima(description, 4, linear, circular) {}
};

}  // namespace

const Construction& construction() { return only<QuadruplesSingleChange>(); }

}  // namespace changeover::quadruples_single_change_entry
