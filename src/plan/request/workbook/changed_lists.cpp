#include "plan/request/workbook/changed_lists.hpp"

#include "changeover/core/error.hpp"
#include "changeover/plan/model.hpp"
#include "core/each.hpp"
#include "io/workbook/workbook_sheet.hpp"
#include "plan/request/whole_question.hpp"

namespace changeover {
namespace {

// Whether two cells have the same text or number: spreadsheets format them differently.
bool is_same(const std::string& one, const std::string& other) {
  if (one == other) {
    return true;
  }
  try {
    return parse_amount(one) == parse_amount(other);
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

bool is_as_written(const RunWorkbook& book, const std::string& name, const Table& table) {
  WorkbookSheet sheet = book.rows(name);
  const auto is_row = [&](const SheetRow& row, auto&& text_of) {
    std::size_t cell = 0;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      const bool is_there = cell < row.cells.size() && row.cells[cell].column == c;
      const std::string text = is_there ? row.cells[cell].text : "";
      cell += is_there ? 1U : 0U;
      if (!(c == 0 ? text == text_of(c) : is_same(text, text_of(c)))) {
        return false;
      }
    }
    return cell == row.cells.size();
  };
  const auto head = sheet.next();
  if (!head || !is_row(*head, [&](std::size_t c) { return table.columns[c].head; })) {
    return false;
  }
  for (std::size_t i = 0; i < table.rows; ++i) {
    const auto row = sheet.next();
    if (!row ||
        !is_row(*row, [&](std::size_t c) { return joined(table.columns[c].cell(i).words); })) {
      return false;
    }
  }
  return !sheet.next();
}

RequestList changed_costs(Input& sheet, const Job& job) {
  Job changed = job;
  changed.replace_costs.clear();
  static_cast<void>(read_value_costs(sheet, changed));
  const std::size_t v = job.names.size();
  const bool says_more = changed.replaces();
  changed.replace_costs.resize(job.replaces() ? v * v : changed.replace_costs.size());
  for (Element out = 0; out < v && job.replaces(); ++out) {
    for (Element in = 0; in < v; ++in) {
      Amount& cost = changed.replace_costs[out * v + in];
      cost = says_more ? cost : changed.change_costs[in];
      const bool depends = job.replace_cost(out, in) != job.change_costs[in];
      cost = depends && cost == changed.change_costs[in] ? job.replace_cost(out, in) : cost;
    }
  }
  return value_cost_rows(changed);
}

}  // namespace changeover
