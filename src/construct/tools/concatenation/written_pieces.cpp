#include "construct/tools/concatenation/pieces.hpp"

namespace changeover {

// The pieces that are written down. Each was found by annealing in which the cells of its parts
// were locked.

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
       "01235 12345 12456 24567 4567e 4567c 4567f 4567d 467bd 0467b 0467a 04679 46789 36789 3789b "
       "1789b 189ab 589ab 289ab 28abc 28abf 2abef 2adef 3adef 3cdef 9cdef 1cdef 0cdef 08def",
       {7, 18, 25}},
  };
  return pieces;
}

const std::vector<WrittenPiece>& closing_pieces() {
  static const std::vector<WrittenPiece> pieces{
      // Half a block more than a perfect one would have.
      {5,
       24,
       16,
       64,
       "01238 0123e 013ae 013ac 01aci 1acgi 1aghi 1ghij 5ghij 9ghij 3ghij 2ghij 4ghij ghijl "
       "7ghij 6ghij 68ghi 6bghi beghi efghi defgh cdefh cdefj 8cdef cdefm 2cdfm 2cdmn 2dkmn "
       "1dkmn 3dkmn dikmn 0dkmn 0hkmn 0gkmn 0jkmn ajkmn bjkmn 8jkmn 48kmn 78kmn 7klmn 5klmn "
       "6klmn 9klmn 9ekln 9fkln 9cfkl 9bcfl 39bfl 19bfl 09bfl 49bfl 49bdl 9abdl 29abl 89abl "
       "589ab 579ab 5679a 567af 4567a 4567d 4567e 4567c",
       {8, 22, 41, 56}},
      // One block more than a perfect one would have.
      {5,
       20,
       12,
       43,
       "2ghij 3ghij 13ghi 013gh 0134h 01234 0123d 01239 1239f 1239c 1238c 1238e 123ae 123ab 135ab "
       "1357a 13567 1567j 0567j 4567j 4567h 4567f 24567 4567c 4567i 4567d 4567g 4567e 5679e 56789 "
       "6789b 689ab 89abg 89abh 89abj 489ab 89abd 89abi 08abi 08abf 0abcf 0bcef bcdef",
       {6, 27, 36}},
  };
  return pieces;
}

const std::vector<WrittenPiece>& copied_pieces() {
  static const std::vector<WrittenPiece> pieces{
      // A tight SCCD(20,5,46).
      {5,
       20,
       12,
       46,
       "01234 1234g 134dg 134de 136de 13def 3defh 9defh bdefh bdefj adefj cdefj cdefi 8cdef 0cdef "
       "07def 27def 57def 57efg 567fg 4567f 4567c 457ch 47ach 17ach 17abc 19abc 9abcg 39abc 29abc "
       "269ab 069ab 059ab 089ab 89abi 489bi 489ij 789ij 378ij 358ij 158ij 258ij 28hij 68hij 8ghij "
       "0ghij",
       {12, 21, 34}},
  };
  return pieces;
}

const std::vector<WrittenPiece>& open_lists() {
  static const std::vector<WrittenPiece> lists{
      {5, 20, 0, 42,
       "0123e 0123a 01239 0139f 0169f 0149f 014bf 14bcf 45bcf 24bcf 47bcf 347bc 47bch 467bc 67abc "
       "67bci 67bce 67bcg 67bcj 78bcj 789bc 78bcd 078cd 0578d 1578d 2578d 2568d 3568d 568dh 58adh "
       "8adeh 8adef 48ade 48aei 48aeg 4aegj 9aegj 59egj 59gij 9dgij 9ghij fghij"},
      {5, 23, 0, 58,
       "0123h 0123d 1237d 137di 137ei 37cei 07cei 0cegi 2cegi ceghi ceghl cdehl 8cdeh cdehj cdehm "
       "5cdeh cdehk 6cehk 9cehk 9bceh 4bceh 4befh abefh 7abfh 67abf 78abf 8abfk 58abf 38abf 8abfl "
       "08abf 8abfi 28abf 8abfm 8abfj 18abf 1abcf 1abfg abdfg 9adfg 49adg 469dg 4689g 3469g 34569 "
       "4569l 24569 04569 4569m 14569 4569i 4569j 4579j 457jk 57gjk 7gjkm 7jklm ijklm"},
  };
  return lists;
}

}  // namespace changeover
