// The parts of the report, a section of the paper each, so that a test can falsify one and run it
// alone.
//
//     Paper falsified = printed_paper();
//     falsified.eleven[0].b = 36;
//     // Now the item on DCCD(15,3,36) differs:
//     auto items = check_corollaries({falsified, Registry::standard(), {}});
//
// Each function returns its items in the order of the paper and reads nothing but its argument.
#pragma once

#include <vector>

#include "paper/report.hpp"

namespace changeover {

/// What a check works on; must not outlive its parts.
struct PaperContext {
  const Paper& paper;
  const Registry& registry;
  PaperReportOptions options;
};

/// Abstract and Section 1: counts of designs, the recursion's parameters, the example of costs.
[[nodiscard]] std::vector<PaperItem> check_introduction(const PaperContext& context);

/// Section 2.1: Table 1.
[[nodiscard]] std::vector<PaperItem> check_history(const PaperContext& context);

/// Section 2.1, the rest: what the paper cites from other works.
[[nodiscard]] std::vector<PaperItem> check_cited(const PaperContext& context);

/// Section 2.2: Theorem 1, Table 2, Figures 1 and 2.
[[nodiscard]] std::vector<PaperItem> check_preliminaries(const PaperContext& context);

/// Section 2.2: what is said of tight and economical designs.
[[nodiscard]] std::vector<PaperItem> check_tightness(const PaperContext& context);

/// Theorem 3: the part of its proof that leans on it. Among the items of check_doubling().
[[nodiscard]] std::vector<PaperItem> check_proof_for_odd_k(const PaperContext& context);

/// Section 3.1: Theorem 2, Table 3.
[[nodiscard]] std::vector<PaperItem> check_recursion(const PaperContext& context);

/// Section 3.2, to Theorem 8: designs from single-change designs, Tables 4 to 7.
[[nodiscard]] std::vector<PaperItem> check_doubling(const PaperContext& context);

/// Section 3.2, to Example 12: cyclic designs, Tables 8 to 11, Figures 3 and 4.
[[nodiscard]] std::vector<PaperItem> check_cyclic(const PaperContext& context);

/// Section 3.2, the rest: Proposition 13 to Table 12.
[[nodiscard]] std::vector<PaperItem> check_corollaries(const PaperContext& context);

/// Section 4: what is said to have been done, and the open questions.
[[nodiscard]] std::vector<PaperItem> check_conclusion(const PaperContext& context);

/// Blocks of a table: the print verified, and compared block by block with `rebuilt`, elements by
/// name.
/// @param how one phrase that says how it was rebuilt.
[[nodiscard]] PaperItem check_blocks(const PrintedTable& table, const Design& rebuilt,
                                     const std::string& how);

/// Marks of a table: every asterisk, caret and highlight compared with the blocks.
[[nodiscard]] PaperItem check_marks(const PrintedTable& table);

/// The kind that a caption names: all of them if it names some, and only those; one at least if it
/// names none.
[[nodiscard]] PaperItem check_kind(const PrintedTable& table);

/// The blocks of a table from each other: each block again from all the others alone, by trying
/// every k-subset.
[[nodiscard]] PaperItem check_each_block(const PrintedTable& table);

/// The number of blocks of a table against the lower bound, and against designs that are built
/// without the print.
[[nodiscard]] PaperItem check_least(const PaperContext& context, const PrintedTable& table);

/// The parameters that a place writes once more, against designs of the statement that they belong
/// to.
[[nodiscard]] PaperItem check_again(const PaperContext& context, std::string_view place);

}  // namespace changeover
