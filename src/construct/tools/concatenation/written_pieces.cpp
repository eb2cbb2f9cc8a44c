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
      {5, 18, 0, 33,
       "0123a 013ab 0139b 1349b 134bd 145bd 45bdg 45bdh 457bd 2457d 0457d 0458d 058cd 0568c "
       "3568c 3678c 678cg 1678c 678ch 689ch 2689c 268bc 28bcf 8bcef 8acef 4acef 46aef 6adef "
       "9adef 79aef 59aef 9aefg aefgh"},
      {5, 19, 0, 38,
       "01235 0135c 035ac 0357c 0345c 0359c 035ce 0358c 058bc 05bcd 06bcd 26bcd 236bd 269bd "
       "29abd 19abd 1abde abdeh abdef abdeg abdei 4bdei 47bde 478de 2478e 4789e 4678e 4678a "
       "14678 4678f 4678g 478gh 78ghi 58ghi 56ghi 5fghi cfghi 9fghi"},
      {5, 20, 0, 42,
       "0123e 0123a 01239 0139f 0169f 0149f 014bf 14bcf 45bcf 24bcf 47bcf 347bc 47bch 467bc 67abc "
       "67bci 67bce 67bcg 67bcj 78bcj 789bc 78bcd 078cd 0578d 1578d 2578d 2568d 3568d 568dh 58adh "
       "8adeh 8adef 48ade 48aei 48aeg 4aegj 9aegj 59egj 59gij 9dgij 9ghij fghij"},
      {5, 23, 0, 58,
       "0123h 0123d 1237d 137di 137ei 37cei 07cei 0cegi 2cegi ceghi ceghl cdehl 8cdeh cdehj cdehm "
       "5cdeh cdehk 6cehk 9cehk 9bceh 4bceh 4befh abefh 7abfh 67abf 78abf 8abfk 58abf 38abf 8abfl "
       "08abf 8abfi 28abf 8abfm 8abfj 18abf 1abcf 1abfg abdfg 9adfg 49adg 469dg 4689g 3469g 34569 "
       "4569l 24569 04569 4569m 14569 4569i 4569j 4579j 457jk 57gjk 7gjkm 7jklm ijklm"},
      {5, 26, 0, 76,
       "01239 12389 1289b 1489b 1789b 1689b 189ab 89abc 89abd 89abe 89abf 89abg 89abh 89abi "
       "89abj 89abk 89abl 89abm 89abn 89abo 89abp 589ab 058ab 035ab 0357a 3567a 2567a 4567a "
       "4567h 467ch 46chn 046ch 46chm 46cho 46chp 4chlp 24chl 24ceh 24chi 24chj 4cfhj 34cfh "
       "34cgh 34chk 4cdhk 1cdhk 15cdk 15dfk 1dfgk 7dfgk dfgkl 2dfgk 6dfgk 0dfgk dfgik defik "
       "deijk 3deij 3eijl 0eijl eijlo 7eijl 6eijl 1eijl eijln 5ijln 5ijlm 5ijmp 5gjmp 5egmp "
       "5gmop gmnop fmnop 7mnop kmnop dmnop"},
      {5, 28, 0, 89,
       "01236 02369 02689 0689a 089ae 89aeg 89aeh 89aei 89aej 89aek 89ael 89aem 89aen 89aeo "
       "89aep 89aeq 89aer 89abe 89ace 18ace 8acef 38cef 3cdef 3bcdf bcdfg bcdfh bcdfi bcdfj "
       "bcdfk bcdfl bcdfm bcdfn bcdfo bcdfp bcdfq bcdfr 2bcdf 6bcdf 0bcdf 04bcf 07bcf 57bcf "
       "157bf 1579f 1579d 4579d 4578d 457ad 3457a 2457a 2457e 4567e 4567r 467jr 467hr 47hir "
       "47inr 47mnr 47kmr 47gkm 14gkm 1gikm giklm 2gikm 3gikm 6gikm 0gikm 05ikm 5ikmq 5ikmo "
       "ijkmo ijkmp hjkmp hjknp 5hjnp 5ghjn 5hjln 3hjln 0hjln 1hjln 2hjln hjlnq hlnoq 6lnoq "
       "6lopq 4lopq 7lopq lopqr gopqr"},
      {5, 31, 0, 111,
       "0123a 0123e 013be 013de 01deg 019de 01deh 0defh defhi defhj defhk defhl defhm defhn "
       "defho defhp defhq defhr defhs defht defhu 6defh adefh 7defh 27dfh 2bdfh 5bdfh 59bfh "
       "359fh 39fgh 39cfh 49cfh 48cfh 148cf 1458c 458cd 458ce 0458c 0456c 456cg 245cg 45acg "
       "4abcg abcgi abcgj abcgk abcgl abcgm abcgn abcgo abcgp abcgq abcgr abcgs abcgt abcgu "
       "7abcg 78abg 678ab 6789a 6789l 678lp 367lp 167lp 17ilp 47ilp 47lmp 47klp 7klpu 57klp "
       "7klps 7lpqs 7lnps 7lnpr 07lnp 7lnpt 7lopt 7jlop 2jlop 29jop 29jno 26jno 28jno 38jno "
       "34jno 4jnoq 1jnoq 1jkno 1jkmo 0jkmo 0ijkm 0ikmq 3ikmq 2ikmq 8ikmq ikmqr 9ikmq 6ikmq "
       "ikmqt 5imqt 5imqu 5imnu 5imsu 5iosu 5orsu 5jrsu jrstu 6rstu 8rstu 4rstu 9rstu"},
  };
  return lists;
}

}  // namespace changeover
