#include "construct/tools/stretched_lists.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace changeover {
namespace {

struct WrittenList {
  std::uint64_t g;
  std::uint64_t h;
  std::uint64_t n;
  std::string_view blocks;
};

// Each was found by annealing. The moves change one point of the developed list, exchange two, or
// exchange the blocks at which two points leave; what counts is how many pairs are not yet covered.
constexpr WrittenList written_lists[] = {
    {5, 1, 7,
     "0a 2a 0b 0c 0d 0e, -3a 0a 0b 0c 0d 0e, 0a 0b 0c 0d 0e 1e, 0a 0b 0c 0d -3e 0e, 0a 0b 0c "
     "0d 0e 2e, 0a 0b -3c 0c 0d 0e, 0a 0b 0c 0d 2d 0e, 0a 1a 0c 0d 2d 0e, 0a 1a 2b 0c 0d 0e, "
     "0a 1a 0c 2c 0d 0e, 1a 0c 2c 0d 1d 0e, 1a 1b 0c 0d 1d 0e, 1a 1b 0c 1c 1d 0e, 1a -2b 1b 0c "
     "1c 1d, 1a -2b 0b 1b 1c 1d, 1a -2b 1b 1c 1d 1e, 1a 1b 1c -2d 1d 1e"},
    {3, 2, 15,
     "0a 1a 0b 1b -4c 0c 1c, 0a 1a 0b 1b -2c 0c 1c, 0a 1a -3b 0b 1b 0c 1c, 0a 1a -5b -3b 0b 1b "
     "1c, 1a -5b -3b 0b 1b 1c 2c, 1a 2a -5b 0b 1b 1c 2c, 1a 2a -5b 1b 2b 1c 2c, -3a 1a 2a 1b "
     "2b 1c 2c, 1a 2a 1b 2b -5c 1c 2c, -5a 1a 2a 1b 2b 1c 2c, -1a 1a 2a 1b 2b 1c 2c"},
};

StretchedList as_read(const WrittenList& list) {
  return {list.g, list.h, list.n, orbit_blocks(list.blocks)};
}

}  // namespace

const std::vector<StretchedList>& stretched_lists() {
  static const std::vector<StretchedList> lists = [] {
    std::vector<StretchedList> all;
    std::ranges::transform(written_lists, std::back_inserter(all), as_read);
    return all;
  }();
  return lists;
}

}  // namespace changeover
