// The pieces that are written down. Each was found by annealing in which the cells of its parts
// were locked.
#include <vector>

#include "construct/tools/concatenation/pieces.hpp"

namespace changeover {

const std::vector<WrittenPiece>& open_pieces() {
  static const std::vector<WrittenPiece> pieces{
      // A tight SCCD(20,5,46).
      {5,
       20,
       16,
       46,
       "0123g 01236 0236a 02367 03467 0467c 4567c 4567e 4567d 467bd 4679d 4679f 46789 14789 "
       "1789a 189ab 89abg 589ab 2589b 0589b 089bi 089bj 89bcj 89bej 389be 89beh 8befh 8defh "
       "0defh cdefh 1cdef cdefg acdef 2cdef cdefi 3cdfi 3dfij 35fij 35hij 15hij 5ghij 7ghij "
       "6ghij 4ghij 4ahij 24hij",
       {8, 16, 33, 41}},
      // An SCCD(16,5,29) of waste 1/2.
      {5,
       16,
       12,
       29,
       "01235 12345 12456 24567 4567e 4567c 4567f 4567d 467bd 0467b 0467a 04679 46789 36789 "
       "3789b 1789b 189ab 589ab 289ab 28abc 28abf 2abef 2adef 3adef 3cdef 9cdef 1cdef 0cdef "
       "08def",
       {7, 18, 25}},
  };
  return pieces;
}

const std::vector<WrittenPiece>& closing_pieces() {
  static const std::vector<WrittenPiece> pieces{
      // One block more than a perfect one would have.
      {5,
       20,
       12,
       43,
       "2ghij 3ghij 13ghi 013gh 0134h 01234 0123d 01239 1239f 1239c 1238c 1238e 123ae 123ab "
       "135ab 1357a 13567 1567j 0567j 4567j 4567h 4567f 24567 4567c 4567i 4567d 4567g 4567e "
       "5679e 56789 6789b 689ab 89abg 89abh 89abj 489ab 89abd 89abi 08abi 08abf 0abcf 0bcef "
       "bcdef",
       {6, 27, 36}},
  };
  return pieces;
}

}  // namespace changeover
