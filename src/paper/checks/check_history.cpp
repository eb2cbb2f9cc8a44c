// Section 2.1: Table 1, from its blocks alone, and against what is built without it.
#include "paper/checks/checks.hpp"

namespace changeover {

std::vector<PaperItem> check_history(const PaperContext& context) {
  const PrintedTable& table = table_at(context.paper, "Table 1");
  return {check_each_block(table), check_least(context, table), check_marks(table),
          check_kind(table)};
}

}  // namespace changeover
