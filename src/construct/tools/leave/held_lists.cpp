#include "construct/tools/leave/held_lists.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>

#include "construct/tools/short_blocks.hpp"

namespace changeover {
namespace {

struct WrittenHeldList {
  std::uint64_t change;
  std::uint64_t k;
  std::uint64_t t;
  std::string_view blocks;
  std::vector<std::uint64_t> positions;
};

// For m = 2 designs of the catalog, and two that a search with --expansion-set found, with elements
// renamed; for m = 3 found by SAT, most of them with the fewest blocks that there can be.
const std::vector<WrittenHeldList>& written_held_lists() {
  static const std::vector<WrittenHeldList> lists{
      {2, 4, 2, "0123", {0, 1}},
      {2, 4, 3, "0123 2345 0145", {0, 1, 3}},
      {2, 4, 4, "0147 0237 1236 2345 0456 1567", {0, 2, 4, 6}},
      {2, 4, 5, "0123 2345 1458 0459 4567 1679 0678 2367 2389", {0, 1, 2, 5, 9}},
      {2,
       4,
       6,
       "01ab 46ab 23ab 2347 2356 0238 0458 1459 1389 0129 0167 6789 89ab 57ab",
       {0, 3, 7, 11, 12, 14}},
      {2,
       4,
       7,
       "0128 0239 236a 237b 24bc 245d 3458 1459 147a 0467 567c 689c 789d 89ab 05ab 0acd 13cd "
       "16bd",
       {0, 2, 6, 10, 12, 14, 16}},
      {2,
       4,
       8,
       "01ae 123a 234b 2468 2459 45af 158f 19bf 167f 3679 389e 089c 89ad 78ab 6abc 6bde 056b "
       "035d 3cdf 14cd 27cd 57ce 047e 02ef",
       {0, 2, 5, 9, 11, 14, 19, 24}},
      {2,
       4,
       9,
       "01ag 18cg 123g 238a 23ce 239f 236d 023b 237h 2345 459g 145b 045h 4568 678f 1679 67bg "
       "067e 089e 89dh 8abd 9abc 6ach 57ac 47cd 0cdf 5def befh 4aef 1efg 1dgh",
       {0, 3, 10, 15, 19, 21, 25, 27, 31}},
      {2, 5, 3, "01236 12378 12345 34578 03456 03678", {0, 3, 6}},
      {2,
       5,
       5,
       "0123c 1346c 3457c 3458d 2459d 256ad 267bd 2678e 06789 1789a 89abc 39abe 04abe 015be "
       "01cde",
       {0, 3, 8, 11, 15}},
      {2,
       5,
       6,
       "0126f 012cg 0129d 0127a 0128e 012bh 013bf 0145b 12345 3456h 3489h 3478a 4678e 678bd "
       "679bc 69abg 9abef 59ade acdeh 3cdeg 4cdfg 58cfg 57fgh",
       {0, 9, 13, 16, 19, 23}},
      {2, 6, 2, "012345 012367 014567", {0, 3}},
      {2, 6, 3, "012389 0123ab 0145ab 014567 234567 456789 6789ab", {0, 4, 7}},
      {2,
       6,
       4,
       "0123cd 01245d 024567 34567e 34568c 3569ac 359abf 249abf 289abe 0789ab 189abd 168bdf "
       "17bcdf 01cdef",
       {0, 3, 9, 14}},
      {2,
       6,
       5,
       "0123hi 1245hi 124567 04567j 34567g 345efg 345cdg 4589cd 4589ab 089abg 1289ab 689abh "
       "789abi 389abj 89abef abcdef 0cdefj 7cdefh 6cdefi 12cdef 12cegj 12ghij",
       {0, 3, 9, 16, 22}},
      {2,
       6,
       6,
       "012345 234567 456789 6789ab 189abc 13abcd 13abef 02abef 028def 09cdef 5cdefk 6cdefl "
       "47cdef cdefmn dfghmn dfghij 4aghij 06ghij 8eghij 17ghij 5bghij 39ghij 2cghij ghijkl "
       "ijklmn 4bklmn 16klmn 29klmn 38klmn 5aklmn 07klmn",
       {0, 2, 4, 10, 16, 31}},
      {2,
       6,
       7,
       "0123pr 13gkpr 134hkp 134ilp 3456ip 3456mo 4567no 24567q 567jkq 567jlr 6789jl 1789jm "
       "89ajmp 389ajn 389abq 489abr 9abcdr 15abcd 16bcde 7bcdep 37cdef 4cdefj 04defg 058efg "
       "059fgh 06afgh 07aghi 0bghij 2ghijo 28chio 28diko 29eiko 2aeklo 2bfklo 2bklmn 0cklmn "
       "cglmnq dhlmnq ehmnqr fimnqr 1fnpqr 01opqr",
       {0, 7, 15, 21, 28, 35, 42}},
      {2,
       6,
       8,
       "0123st 01gmst 14gnst 14hqst 45kqst 45lrst 4567lt 34567u 24567v 4567mo 5678mp 05678n "
       "06789q 16789r 789abr 289abu 389abv 89abos 9abeot 49abep 04abef 15abef 1bcdef cdefuv "
       "23cdef 6cdefs 7cdfis 8cdfit 48cdij 59cdij 5dghij 3ghiju 2ghijv 6aghij 6bghjk 7eghjk "
       "8eghkl 9fghkl 9hklmn 2klmnu 3klmnv acklmn adlmnq bilmnq eimnqr fjmnqr fnopqr opqruv "
       "23opqr cgopqr 0chopr 0dkopr 01ikop 01jlop 01jpst 01stuv",
       {0, 7, 15, 23, 31, 39, 47, 56}},
      {3, 5, 3, "01236 23457 01456", {0, 1, 2}},
      {3, 5, 4, "01457 02367 12345 04567 12367", {0, 2, 3, 4}},
      {3, 5, 6, "01235 234ab 0456a 24589 1689b 12467 36789 0189a 057ab", {0, 1, 3, 6, 7, 9}},
      {3,
       5,
       7,
       "01269 239ab 0237c 1238d 23459 4567a 3678d 0589d 4789c 178ab 045ab 6abcd 145cd",
       {0, 4, 5, 6, 8, 11, 13}},
      {3, 6, 3, "012345 345678 012678", {0, 1, 2}},
      {3, 6, 4, "012458 0129ab 3459ab 134567 023678 6789ab", {0, 3, 5, 6}},
      {3,
       6,
       6,
       "1247de 0124bf 01259h 019acg 037bcg 256bcg 45aceg 345def 34578g 13678h 6789af 469abh "
       "2389ab 09abde 068cde cdefgh",
       {2, 8, 10, 12, 15, 16}},
      {3, 7, 3, "0123579 345679a 145678b 012468a 02389ab", {0, 2, 5}},
      {3,
       7,
       4,
       "0123579 234567c 456789b 01689bc 12389ab 89abdef 014adef 235adef 67acdef",
       {0, 2, 5, 9}},
      {3, 8, 3, "0123489a 01256789 3456789e 35789bcd 1579acde 245abcde 016abcde", {0, 2, 7}},
      {3,
       8,
       4,
       "147bcdej 01234bde 0123489c 01345678 156789gh 256789ij 15789afi 589abdei 56abcdef "
       "abcdeghi 24acfghi 03afghij",
       {2, 5, 9, 12}},
      {3, 9, 3, "0123456ab 3456789ab 6789abcef 6789abdgh 012789dgh 012cdefgh 345cdefgh", {0, 2, 6}},
      {3,
       10,
       3,
       "23589bchjk 01235abhjk 0123456bik 0123456egh 01234567df 014678adfi 014789abcd 789abcdefg "
       "679cdefgij 47defghijk",
       {3, 7, 10}},
  };
  return lists;
}

}  // namespace

HeldList::HeldList(std::uint64_t k, std::uint64_t change, std::uint64_t t)
    : n_(k - change), m_(change), t_(t) {
  const WrittenHeldList* rest = nullptr;
  for (const WrittenHeldList& each : written_held_lists()) {
    if (each.k == k && each.change == change && each.t <= t &&
        (rest == nullptr || each.t > rest->t)) {
      rest = &each;
    }
  }
  const std::uint64_t first_groups = rest == nullptr ? t : t - rest->t;
  // If m-sets of the later elements leave some, these come before the position.
  for (std::uint64_t group = 0; group < first_groups; ++group) {
    starts_.push_back(first_blocks_);
    positions_.push_back(first_blocks_ + (later(group) % m_ != 0 ? 1 : 0));
    first_blocks_ += (later(group) + m_ - 1) / m_;
  }
  if (rest != nullptr) {
    found_ = short_blocks(rest->blocks);
    for (const std::uint64_t position : rest->positions) {
      positions_.push_back(first_blocks_ + position);
    }
  }
}

bool HeldList::is_seam(std::uint64_t i) const {
  return i == first_blocks_ || std::ranges::binary_search(starts_, i);
}

// Beside a group pass m-sets of the later elements, the first ones last, for if they are of the
// next group they stay. What is left over comes first of all, after the first one if m = 2, else
// before others. The order within a block matters: ways begin with the elements as they stand.
void HeldList::write(std::uint64_t i, std::span<Element> block) const {
  if (i >= first_blocks_) {
    std::ranges::transform(
        found_[static_cast<std::size_t>(i - first_blocks_)], block.begin(),
        [this](Element x) { return static_cast<Element>(x + n_ * starts_.size()); });
    return;
  }
  const std::uint64_t group =
      static_cast<std::uint64_t>(std::ranges::upper_bound(starts_, i) - starts_.begin()) - 1;
  const std::uint64_t next = (group + 1) * n_;
  const std::uint64_t left_over = later(group) % m_;
  const std::uint64_t sets = later(group) / m_;
  const std::uint64_t number = i - starts_[static_cast<std::size_t>(group)];
  const auto held = block.begin() + static_cast<std::ptrdiff_t>(n_);
  std::iota(block.begin(), held, static_cast<Element>(group * n_));
  if (left_over > 0 && number == 0) {
    if (m_ == 2) {
      *held = static_cast<Element>(next);
      *(held + 1) = static_cast<Element>(t_ * n_ - 1);
    } else {
      const auto others = held + static_cast<std::ptrdiff_t>(left_over);
      std::iota(held, others, static_cast<Element>(t_ * n_ - left_over));
      std::iota(others, block.end(), static_cast<Element>(t_ * n_));
    }
    return;
  }
  const std::uint64_t of_sets = number + (left_over > 0 ? 0 : 1);
  std::iota(held, block.end(), static_cast<Element>(next + (of_sets < sets ? m_ * of_sets : 0)));
}

}  // namespace changeover
