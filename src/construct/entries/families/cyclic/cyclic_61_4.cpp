// The tight circular DCCD(61, 4, 366): six base blocks over Z_61, as printed.
//
// The last base block contains k−2 = 2, so that {1,2} is kept on the way to the next six. No
// expansion set exists, for k−2 = 2 does not divide 61.
#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover::cyclic_61_4_entry {
namespace {

constexpr Parameters served{61, 4, 2, Kind::circular, 2};

BaseBlocks base() {
  return {
      served,
      {{0, 1, 4, 19}, {0, 1, 6, 22}, {0, 1, 8, 25}, {0, 1, 10, 48}, {0, 1, 12, 32}, {0, 1, 2, 28}}};
}

constexpr Description description{
    .name = "cyclic-61-4",
    .summary = "six base blocks over Z_61, developed",
    .preconditions = "circular, m = 2, v = 61, k = 4",
    .guarantee = "a tight circular DCCD(61,4,366)",
    .cited = "ChafeeStevens2025",
    .place = "Proposition 16",
};

class Cyclic61x4 final : public Described<Family, description> {
 public:
  std::optional<BaseBlocks> base_blocks(const Recipe& recipe) const override {
    (void)required(recipe);
    return base();
  }

 protected:
  std::optional<Promise> promise(const Parameters& p) const override {
    return p == served ? std::optional(Promise{366, true, true}) : std::nullopt;
  }

  std::unique_ptr<BlockSource> blocks(const Parameters&) const override {
    return std::make_unique<DevelopedSource>(base());
  }

  std::string explanation(const Parameters&) const override {
    return "Develop the base blocks {0,1,4,19}, {0,1,6,22}, {0,1,8,25}, {0,1,10,48}, {0,1,12,32}, "
           "{0,1,2,28} over Z_61.";
  }
};

}  // namespace

const Construction& construction() { return only<Cyclic61x4>(); }

}  // namespace changeover::cyclic_61_4_entry
