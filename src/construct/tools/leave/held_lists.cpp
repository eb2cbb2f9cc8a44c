#include "construct/tools/leave/held_lists.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>

#include "construct/tools/short_blocks.hpp"

namespace changeover {
namespace {

struct WrittenHeldList {
  std::uint64_t k;
  std::uint64_t t;
  std::string_view blocks;
  std::vector<std::uint64_t> positions;
};

// Designs of the catalog, and two that a search with --expansion-set found, with elements renamed.
const std::vector<WrittenHeldList>& written_held_lists() {
  static const std::vector<WrittenHeldList> lists{
      {4, 2, "0123", {0, 1}},
      {4, 3, "0123 2345 0145", {0, 1, 3}},
      {4, 4, "0147 0237 1236 2345 0456 1567", {0, 2, 4, 6}},
      {4, 5, "0123 2345 1458 0459 4567 1679 0678 2367 2389", {0, 1, 2, 5, 9}},
      {4,
       6,
       "01ab 46ab 23ab 2347 2356 0238 0458 1459 1389 0129 0167 6789 89ab 57ab",
       {0, 3, 7, 11, 12, 14}},
      {4,
       7,
       "0128 0239 236a 237b 24bc 245d 3458 1459 147a 0467 567c 689c 789d 89ab 05ab 0acd 13cd "
       "16bd",
       {0, 2, 6, 10, 12, 14, 16}},
      {4,
       8,
       "01ae 123a 234b 2468 2459 45af 158f 19bf 167f 3679 389e 089c 89ad 78ab 6abc 6bde 056b "
       "035d 3cdf 14cd 27cd 57ce 047e 02ef",
       {0, 2, 5, 9, 11, 14, 19, 24}},
      {4,
       9,
       "01ag 18cg 123g 238a 23ce 239f 236d 023b 237h 2345 459g 145b 045h 4568 678f 1679 67bg "
       "067e 089e 89dh 8abd 9abc 6ach 57ac 47cd 0cdf 5def befh 4aef 1efg 1dgh",
       {0, 3, 10, 15, 19, 21, 25, 27, 31}},
      {5, 3, "01236 12378 12345 34578 03456 03678", {0, 3, 6}},
      {5,
       5,
       "0123c 1346c 3457c 3458d 2459d 256ad 267bd 2678e 06789 1789a 89abc 39abe 04abe 015be "
       "01cde",
       {0, 3, 8, 11, 15}},
      {5,
       6,
       "0126f 012cg 0129d 0127a 0128e 012bh 013bf 0145b 12345 3456h 3489h 3478a 4678e 678bd "
       "679bc 69abg 9abef 59ade acdeh 3cdeg 4cdfg 58cfg 57fgh",
       {0, 9, 13, 16, 19, 23}},
      {6, 2, "012345 012367 014567", {0, 3}},
      {6, 3, "012389 0123ab 0145ab 014567 234567 456789 6789ab", {0, 4, 7}},
      {6,
       4,
       "0123cd 01245d 024567 34567e 34568c 3569ac 359abf 249abf 289abe 0789ab 189abd 168bdf "
       "17bcdf 01cdef",
       {0, 3, 9, 14}},
      {6,
       5,
       "0123hi 1245hi 124567 04567j 34567g 345efg 345cdg 4589cd 4589ab 089abg 1289ab 689abh "
       "789abi 389abj 89abef abcdef 0cdefj 7cdefh 6cdefi 12cdef 12cegj 12ghij",
       {0, 3, 9, 16, 22}},
      {6,
       6,
       "012345 234567 456789 6789ab 189abc 13abcd 13abef 02abef 028def 09cdef 5cdefk 6cdefl "
       "47cdef cdefmn dfghmn dfghij 4aghij 06ghij 8eghij 17ghij 5bghij 39ghij 2cghij ghijkl "
       "ijklmn 4bklmn 16klmn 29klmn 38klmn 5aklmn 07klmn",
       {0, 2, 4, 10, 16, 31}},
      {6,
       7,
       "0123pr 13gkpr 134hkp 134ilp 3456ip 3456mo 4567no 24567q 567jkq 567jlr 6789jl 1789jm "
       "89ajmp 389ajn 389abq 489abr 9abcdr 15abcd 16bcde 7bcdep 37cdef 4cdefj 04defg 058efg "
       "059fgh 06afgh 07aghi 0bghij 2ghijo 28chio 28diko 29eiko 2aeklo 2bfklo 2bklmn 0cklmn "
       "cglmnq dhlmnq ehmnqr fimnqr 1fnpqr 01opqr",
       {0, 7, 15, 21, 28, 35, 42}},
      {6,
       8,
       "0123st 01gmst 14gnst 14hqst 45kqst 45lrst 4567lt 34567u 24567v 4567mo 5678mp 05678n "
       "06789q 16789r 789abr 289abu 389abv 89abos 9abeot 49abep 04abef 15abef 1bcdef cdefuv "
       "23cdef 6cdefs 7cdfis 8cdfit 48cdij 59cdij 5dghij 3ghiju 2ghijv 6aghij 6bghjk 7eghjk "
       "8eghkl 9fghkl 9hklmn 2klmnu 3klmnv acklmn adlmnq bilmnq eimnqr fjmnqr fnopqr opqruv "
       "23opqr cgopqr 0chopr 0dkopr 01ikop 01jlop 01jpst 01stuv",
       {0, 7, 15, 23, 31, 39, 47, 56}},
  };
  return lists;
}

}  // namespace

HeldList::HeldList(std::uint64_t k, std::uint64_t t) : n_(k - 2), t_(t), first_groups_(t) {
  const WrittenHeldList* rest = nullptr;
  for (const WrittenHeldList& each : written_held_lists()) {
    if (each.k == k && each.t <= t && (rest == nullptr || each.t > rest->t)) {
      rest = &each;
    }
  }
  if (rest != nullptr) {
    found_ = short_blocks(rest->blocks);
    first_groups_ = t - rest->t;
  }
  // If the number of later elements is odd, one pair comes before the position.
  for (std::uint64_t group = 0; group < first_groups_; ++group) {
    positions_.push_back(first_blocks_ + later(group) % 2);
    first_blocks_ += (later(group) + 1) / 2;
  }
  for (std::size_t i = 0; rest != nullptr && i < rest->positions.size(); ++i) {
    positions_.push_back(first_blocks_ + rest->positions[i]);
  }
}

// Beside a group pass pairs of the later elements, the first two of the next group last, for they
// stay. If their number is odd, the last one comes first, with the first one.
void HeldList::write(std::uint64_t i, std::span<Element> block) const {
  if (i >= first_blocks_) {
    std::ranges::transform(
        found_[static_cast<std::size_t>(i - first_blocks_)], block.begin(),
        [this](Element x) { return static_cast<Element>(x + n_ * first_groups_); });
    return;
  }
  std::uint64_t group =
      static_cast<std::uint64_t>(std::ranges::upper_bound(positions_, i) - positions_.begin());
  // A block before its position belongs to the group of that position.
  if (group == 0 || (group < first_groups_ && i + 1 == position(group) && later(group) % 2 == 1)) {
    ++group;
  }
  --group;
  const std::uint64_t next = (group + 1) * n_;
  const std::uint64_t odd = later(group) % 2;
  const std::uint64_t number = i + odd - position(group);  // of the group
  const std::uint64_t pairs = later(group) / 2;
  std::uint64_t one = next;
  std::uint64_t two = next + 1;
  if (odd == 1 && number == 0) {
    two = t_ * n_ - 1;
  } else if (number + 1 - odd < pairs) {
    one = next + 2 * (number + 1 - odd);
    two = one + 1;
  }
  std::iota(block.begin(), block.begin() + static_cast<std::ptrdiff_t>(n_),
            static_cast<Element>(group * n_));
  block[block.size() - 2] = static_cast<Element>(one);
  block[block.size() - 1] = static_cast<Element>(two);
}

}  // namespace changeover
