// The source paper as data: what is printed in it, misprints included.
//
// [ChafeeStevens2025] has twelve tables, four figures, sixteen numbered statements and a worked
// example of costs. They are entered here as they stand in print, so that report.hpp can compare
// them, cell by cell, with what the library builds. Numbers of tables, figures and statements are
// those that LaTeX gives (theorems, propositions, corollaries and examples share one counter).
//
//     const Paper& paper = printed_paper();
//     const PrintedTable& table = table_at(paper, "Table 11");
//     ParsedTable read = parse(table);
//     read.blocks[25].name;                       // "B1,12"
//     read.blocks[25].cells[1].element;           // "1"
//     read.blocks[25].cells[1].introduced;        // true: printed with a superscript asterisk
//
// A table is kept in the layout of the print, a block a column:
//     B0   B1   B2         names of the blocks; the paper's B with subscripts
//     0    5*   1_s_       element, then * for introduced, _ for leaving,
//     a^   4!   8:3        ^ for a caret after the block, ! for highlighted, :n for the n-th colour
//     U    ^{2} . {0}      unchanged subsets by position, a caret before those in the expansion set
//     --                   a rule; the columns start again
// Not entered: colours that only tell neighbouring columns or runs apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/construct/one_factorization.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "paper/print/formula.hpp"

namespace changeover {

/// A table of blocks.
struct PrintedTable {
  std::string place;        ///< "Table 3", "Table 4 (left)"
  std::string caption;      ///< with the paper's macros written out
  Parameters parameters;    ///< kind: which convention the asterisks of its first block follow
  std::uint64_t b = 0;      ///< blocks, by the caption
  std::vector<Kind> kinds;  ///< what caption and text call it; empty if they name no kind
  bool tight = false;       ///< the caption says so
  bool minimum = false;     ///< the caption says so
  bool leaving = false;     ///< it marks leaving elements too
  std::vector<std::string> elements = {};  ///< names by number; empty if they are 0, …, v−1
  std::string layout;
};

struct PrintedCell {
  std::string element;
  bool introduced = false, leaving = false, caret = false, highlighted = false;
  unsigned colour = 0;  ///< 0: none
};

struct PrintedBlock {
  std::string name;  ///< empty if the table names no blocks
  std::vector<PrintedCell> cells;
};

/// An unchanged subset in a row of them; `elements` is empty where nothing is printed.
struct PrintedUnchanged {
  std::vector<std::string> elements;
  bool caret = false;
};

struct ParsedTable {
  std::vector<PrintedBlock> blocks;
  std::vector<PrintedUnchanged>
      unchanged;                    ///< by position from 0; empty if the table has no such row
  std::vector<std::size_t> carets;  ///< positions with a caret, from either notation
};

/// Reads the layout. @throws BadInput if columns have unequal lengths or a mark is unknown.
[[nodiscard]] ParsedTable parse(const PrintedTable& table);

/// The name of an element of the table.
[[nodiscard]] std::string element_name(const PrintedTable& table, Element element);

/// The printed blocks as a design of that kind, elements by number.
/// @throws BadInput if a block has not k distinct elements of the table.
[[nodiscard]] Design printed_design(const PrintedTable& table, Kind kind);

/// A 1-factorization, one factor per line: "a-b c-d".
struct PrintedFactorization {
  std::string place;
  std::vector<std::string> vertices;  ///< names by number
  std::string factors;
};

/// The factorization with vertices by number, factors and edges in the order of the print.
/// @throws BadInput if a vertex is unknown.
[[nodiscard]] OneFactorization parse(const PrintedFactorization& printed);

/// Two consecutive blocks drawn on a circle, with the newly covered pairs as chords.
struct PrintedCircle {
  std::string place;
  std::uint64_t v = 0;
  std::string first, second;              ///< the blocks, "0 1 2 5"
  std::string first_edges, second_edges;  ///< chords, "0-2 0-5"
  std::string black;                      ///< vertices of the unchanged subset drawn in black
  std::string first_only, second_only;    ///< vertices in the colour of one block
};

/// Base blocks A ∪ {…}, A = {0, …, k−3}, over Z_v with v = c(4k−6)+1: the two further elements of
/// each, two formulas in k: "2(k-2),5(k-2)+2".
struct PrintedBaseBlocks {
  std::string place;
  std::uint64_t c = 0;
  std::vector<std::string> further;
};

/// The base blocks of a row for block size k.
/// @throws BadInput if an entry cannot be read.
[[nodiscard]] std::vector<Block> base_blocks(const PrintedBaseBlocks& row, std::uint64_t k);

/// Formulas of v and b, in the LaTeX of the print (formula.hpp).
struct PrintedDesign {
  std::string place;
  std::string v, b;
};

/// A family DCCD(v, k, b) with one v for each k.
struct PrintedFamily {
  PrintedDesign design;
  std::uint64_t smallest_k = 0;
  bool even = false;  ///< for even k; otherwise for odd k
};

/// The parameters of a numbered statement as they are written once more, in the abstract or in
/// Section 4.
struct PrintedAgain {
  PrintedDesign design;
  std::string statement;  ///< "Theorem 3"
};

/// The differences ±d that a proof lists for c base blocks, for each of them the intervals of d,
/// ends as formulas.
struct PrintedDifferences {
  std::uint64_t c = 0;
  std::string v;  ///< "this is all the differences in Z_v"
  std::vector<std::vector<std::pair<std::string, std::string>>> blocks;
};

/// Formulas that are cited from other works: numbers of blocks, and of elements.
struct PrintedCited {
  std::string linear_b, circular_b;  ///< of minimum designs, with a \ceiling
  std::string k4_b;                  ///< of minimum DCCD(v,4,b)
  std::string minimum_v, minimum_b;  ///< "linear DCCD(…,k,…) are minimum"
  std::string prime_power_b;         ///< of minimum linear designs that exist only if …
  std::string prime_power_v;         ///< … v is at least this
  std::string no_fixed_from;         ///< no fixed elements in linear designs from this v on
  std::string fixed_at;  ///< fixed elements in circular designs if and only if v is this
  std::string pairs_b;   ///< of minimum DCCD(v,2,b)
  PrintedDesign single, single_cyclic;  ///< circular SCCDs of Section 3.2
  std::vector<std::uint64_t> single_k;  ///< block sizes for which all minimum SCCDs are constructed
  std::string room_v;                   ///< the least v for b > 1, in k and m
  std::string largest_difference;       ///< d of the differences ±d in Z_v
  std::uint64_t k4_from = 0, k4_to = 0;  ///< v of the minimum DCCD(v,4,b) that are constructed
  std::string circular_single_to;        ///< minimum circular SCCDs are known up to this v
};

struct PrintedTriple {
  std::uint64_t v = 0, k = 0, b = 0;

  bool operator==(const PrintedTriple&) const = default;
};

/// "The pair {x,y} is covered in this block and not in those."
struct PrintedCovered {
  std::string table, x, y;
  std::vector<std::string> covered, not_covered;  ///< names of blocks
};

/// Unchanged subsets of Table 2 (block size 3) in the text.
struct PrintedUnchangedText {
  std::vector<std::string> between;      ///< U₁, …, U₆
  std::vector<std::string> first, last;  ///< what U₀ and U₇ can be in the linear design
  std::string closing;                   ///< U₀ = U₇ in the circular one
  std::string missing;                   ///< the element that is in no Uᵢ of the circular one
};

/// Costs in dollars of testing nine components three at a time.
struct PrintedCosts {
  std::uint64_t test = 0, change = 0;                 ///< of one test, of changing one component
  std::uint64_t covering = 0, single = 0, twice = 0;  ///< the covering as listed, SCCD, DCCD
};

/// A numbered statement, shortened to what it claims.
struct PrintedStatement {
  std::string place;  ///< "Theorem 2"
  std::string claim;
};

struct Paper {
  std::vector<PrintedStatement> statements;  ///< in the order of the print
  std::vector<PrintedTable> tables;
  std::vector<PrintedFactorization> factorizations;  ///< Figures 1 and 2, and K_4 of Table 7
  std::vector<PrintedCircle> circles;                ///< Figures 3, 4a and 4b
  std::vector<PrintedBaseBlocks> cyclic;             ///< Table 9
  PrintedBaseBlocks six_base_blocks;                 ///< Table 12, with c = 6 and k = 4
  std::uint64_t cyclic_up_to = 0;                    ///< c of Theorem 10
  std::vector<PrintedFamily> families;               ///< Theorems 3, 4 and 8
  PrintedDesign cyclic_family;                       ///< Theorem 10
  std::vector<PrintedDifferences> differences;       ///< the proof of Theorem 10
  PrintedDesign expanded;                            ///< Corollary 14, with l = (2c+1)/(k−2)
  std::vector<std::string>
      expansion_order;              ///< the proofs: how many subsets are in the expansion set
  std::vector<PrintedAgain> again;  ///< abstract and Section 4
  std::string linear_bound, circular_bound;  ///< g₁ and g₂ of Theorem 1
  std::vector<PrintedTriple> eleven;         ///< Corollary 15
  std::uint64_t count_in_abstract = 0;       ///< "twelve additional minimum DCCD"
  std::uint64_t count_in_corollary = 0;      ///< "the following eleven"
  std::uint64_t count_in_conclusion = 0;     ///< "eleven additional"
  std::string covering;                      ///< blocks of the introduction, one a line
  std::vector<PrintedCosts> costs;
  std::vector<PrintedDesign> recursion;  ///< v* and b*: abstract, Theorem 2, Section 4
  PrintedDesign single_recursion;        ///< Section 3.1: what is cited of single-change designs
  PrintedCovered covered;                ///< the example of Section 1
  PrintedUnchangedText unchanged;        ///< Section 2.2
  /// Base blocks of Example 12, "taken from Theorem 10 for c = 2, k = 3", one a line.
  std::string base_blocks_in_example;
  /// The proof of Proposition 13 lets 0 ≤ j < v/(k−2) − this.
  std::uint64_t range_short_by = 0;
  PrintedCited cited;  ///< Sections 2.1 and 3.2
};

/// The tables of blocks, in the order of the print.
[[nodiscard]] std::vector<PrintedTable> printed_tables();

/// The paper as printed.
[[nodiscard]] const Paper& printed_paper();

/// The table of that place. @throws BadInput if there is none.
[[nodiscard]] const PrintedTable& table_at(const Paper& paper, std::string_view place);

/// The family of that theorem. @throws BadInput if there is none.
[[nodiscard]] const PrintedFamily& family_at(const Paper& paper, std::string_view place);

/// The formulas of that place among some. @throws BadInput if there are none.
[[nodiscard]] const PrintedDesign& formulas_at(const std::vector<PrintedDesign>& designs,
                                               std::string_view place);

/// The claim of that numbered statement. @throws BadInput if there is none.
[[nodiscard]] const std::string& claim_at(const Paper& paper, std::string_view place);

/// Numbers or names in a line, split at white space.
[[nodiscard]] std::vector<std::string> words(std::string_view line);

/// The blocks in a text, one a line, elements as numbers. @throws BadInput unless all are numbers.
[[nodiscard]] std::vector<Block> blocks_in(std::string_view text);

}  // namespace changeover
