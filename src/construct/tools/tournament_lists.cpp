#include "construct/tools/tournament_lists.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace changeover {
namespace {

struct WrittenTournament {
  std::uint64_t k;
  std::uint64_t least;
  std::int64_t shift;
  std::string_view blocks;
  std::vector<Passage> passages;
};

// A search in two stages found each: chains of orbits that cover each pair of orbits as often as
// needed, then residues for a chain.
const std::vector<WrittenTournament>& written_tournaments() {
  static const std::vector<WrittenTournament> lists = {
      {4,
       5,
       -2,
       "-2a 0a 2b 2c, -2a 2b 1c 0d, -2a -4d 0d 0e, -2a -3d -1d 0e, -1c 1c -1d 0e, 0b 1c -1d 1e, "
       "-1a 0b 2b -1d, -5a -1a 0b 0c",
       {{0, 0, -1, 3}, {1, 5, 1, 2}, {2, 4, 0, 2}, {3, 3, -2, 3}, {4, 7, 1, 1}}},
  };
  return lists;
}

}  // namespace

const std::vector<TournamentList>& tournament_lists() {
  static const std::vector<TournamentList> lists = [] {
    std::vector<TournamentList> all;
    std::ranges::transform(written_tournaments(), std::back_inserter(all), [](const auto& list) {
      return TournamentList{list.k, list.least, list.shift, orbit_blocks(list.blocks),
                            list.passages};
    });
    return all;
  }();
  return lists;
}

}  // namespace changeover
