// Reads change costs by what is replaced from a square table.
#include <fmt/format.h>

#include "changeover/plan/job.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/part_finder.hpp"
#include "plan/job/parts/cost_reader.hpp"

namespace changeover {
namespace {

// The part that heads a row or a column; no part may head two.
Element head(const PartFinder& finder, const RowReader& reader, const Field& field,
             const std::string& what, std::vector<bool>& seen) {
  if (field.text.empty()) {
    reader.fail(field, fmt::format("a {} without a part at its head; name it", what));
  }
  const auto part = finder.find(field.text);
  if (!part) {
    reader.fail(field, finder.complaint(field.text));
  }
  if (seen[*part]) {
    reader.fail(field, fmt::format("{} heads two {}s; remove one", shown(field.text), what));
  }
  seen[*part] = true;
  return *part;
}

// Checks that every part heads one.
void require_all(const RowReader& reader, const Field& where, const std::vector<bool>& seen,
                 const std::vector<std::string>& names, const std::string& what) {
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i]) {
      reader.fail(where, fmt::format("no {} for {}; give every part a row and a column", what,
                                     shown(names[i])));
    }
  }
}

}  // namespace

std::vector<Amount> read_change_costs(Input& input, const std::vector<std::string>& names,
                                      const std::vector<std::uint32_t>& slot_of,
                                      std::vector<std::string>* gone) {
  RowReader reader(input);
  PartFinder finder(names, numbers_in(reader));
  CostReader cost_of(reader);
  const std::size_t v = names.size();
  std::vector<Amount> costs(v * v);
  const auto header = reader.next();
  if (!header) {
    fail(input.name(), {}, "no cost is listed; write ,A,B in the first line, and A,,5 below it");
  }
  std::vector<bool> seen(v, false);
  std::vector<std::optional<Element>> columns;  // nullopt for a part that no longer exists
  for (std::size_t i = 1; i < header->size(); ++i) {
    const Field& field = (*header)[i];
    columns.push_back(finder.some_gone({&field, 1}, reader, gone)
                          ? std::nullopt
                          : std::optional(head(finder, reader, field, "column", seen)));
  }
  require_all(reader, header->front(), seen, names, "column");
  seen.assign(v, false);
  while (const auto row = reader.next()) {
    if (finder.some_gone({&row->front(), 1}, reader, gone)) {
      continue;
    }
    const Element out = head(finder, reader, row->front(), "row", seen);
    if (row->size() > columns.size() + 1) {
      reader.fail(
          (*row)[columns.size() + 1],
          fmt::format("more than {} costs in this row; give one for each column", columns.size()));
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (!columns[i]) {
        continue;
      }
      const Element in = *columns[i];
      const bool given = i + 1 < row->size() && !(*row)[i + 1].text.empty();
      if (in == out) {
        if (given) {
          reader.fail((*row)[i + 1], fmt::format("{} does not replace itself; leave this field "
                                                 "empty",
                                                 shown(names[in])));
        }
      } else if (!slot_of.empty() && slot_of[in] != slot_of[out]) {
        continue;  // they are in different slots, so neither replaces the other
      } else if (!given) {
        reader.fail(i + 1 < row->size() ? (*row)[i + 1] : row->back(),
                    fmt::format("no cost of putting in {} where {} was taken out; give one",
                                shown(names[in]), shown(names[out])));
      } else {
        costs[out * v + in] = cost_of.read((*row)[i + 1]);
      }
    }
  }
  require_all(reader, header->front(), seen, names, "row");
  return costs;
}

}  // namespace changeover
