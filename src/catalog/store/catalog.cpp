#include "changeover/catalog/catalog.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "catalog/store/store.hpp"

namespace changeover {
namespace {

// Where an entry stands in a list.
struct Row {
  std::array<std::uint64_t, 5> cell;  // change, strength, kind, k, v
  std::uint64_t b = 0;
  std::string label;
  bool users = false;
  bool carries_blocks = false;

  [[nodiscard]] auto name() const { return std::tie(cell, b, label); }
  [[nodiscard]] auto key() const { return std::tie(cell, b, label, users); }
  [[nodiscard]] auto rank() const {
    return std::tie(cell, b, users, carries_blocks, label);
  }  // as best() has it
};

// What no entry has.
bool is_beyond(const Parameters& p) {
  return std::max({p.v, p.k, p.change}) > std::numeric_limits<Element>::max();
}

}  // namespace

Catalog::Catalog(Files files) : store_(std::make_unique<Store>(std::move(files))) {}
Catalog::~Catalog() = default;

std::optional<CatalogEntry> Catalog::best(const Parameters& p) const {
  if (is_beyond(p)) {
    return std::nullopt;
  }
  const std::lock_guard lock(store_->mutex);
  return store_->best(p);
}

std::optional<Catalog::Known> Catalog::fewest(const Parameters& p, bool carries_blocks) const {
  if (is_beyond(p)) {
    return std::nullopt;
  }
  const std::lock_guard lock(store_->mutex);
  return store_->fewest(p, carries_blocks);
}

std::optional<CatalogEntry> Catalog::find(std::string_view label) const {
  const std::lock_guard lock(store_->mutex);
  if (const std::string behind = store_->behind_alias(label); !behind.empty()) {
    return store_->exact(behind);
  }
  if (auto entry = store_->exact(label)) {
    return entry;
  }
  const std::string wanted(label);
  // The beginning of a label: a cell, its number of blocks or the first of its digits.
  const std::size_t dot = wanted.rfind('.');
  if (dot == std::string::npos || parse_cell_label(wanted) ||
      !(parse_cell_label(std::string_view(wanted).substr(0, dot)) ||
        parse_cell_label(std::string_view(wanted).substr(0, wanted.rfind('.', dot - 1))))) {
    return std::nullopt;
  }
  const bool is_count = parse_cell_label(std::string_view(wanted).substr(0, dot)).has_value();
  const std::string beginning = is_count ? wanted + "." : wanted;
  std::set<std::string> labels;
  const auto collect = [&](Shelf& shelf) {
    Statement& rows = shelf.begins(beginning);
    const ResetLater later(rows);
    while (rows.step()) {
      labels.insert(rows.text(0));
    }
    return true;
  };
  if (store_->shipped) {
    collect(*store_->shipped);
  }
  store_->from_users(true, collect);
  if (labels.size() > 1) {
    throw BadInput(
        fmt::format("{} designs have a label that begins with {}, as {} and {}; write more of it",
                    labels.size(), wanted, *labels.begin(), *labels.rbegin()));
  }
  return labels.empty() ? std::nullopt : store_->exact(*labels.begin());
}

std::vector<CatalogEntry> Catalog::cell(const Parameters& p) const {
  std::vector<CatalogEntry> entries;
  if (is_beyond(p)) {
    return entries;
  }
  const std::lock_guard lock(store_->mutex);
  const auto collect = [&](Shelf& shelf) {
    std::vector<CatalogEntry> found;
    Statement& rows = shelf.cell(p);
    const ResetLater later(rows);
    while (rows.step()) {
      found.push_back(store_->read(shelf, rows));
    }
    return found;
  };
  if (store_->shipped) {
    entries = collect(*store_->shipped);
  }
  std::set<std::string> shipped;  // No label is twice in one file.
  for (const CatalogEntry& entry : entries) {
    shipped.insert(entry.label());
  }
  for (CatalogEntry& entry : store_->from_users(std::vector<CatalogEntry>(), collect)) {
    if (!shipped.contains(entry.label())) {
      entries.push_back(std::move(entry));
    }
  }
  std::ranges::stable_sort(entries, {}, &CatalogEntry::b);
  return entries;
}

void Catalog::each(const CatalogFilter& filter,
                   const std::function<bool(const CatalogEntry&)>& take) const {
  // First the labels in order, then the entries one by one, because the list may be long.
  std::vector<Row> rows;
  {
    const std::lock_guard lock(store_->mutex);
    std::string sql =
        "SELECT change, strength, kind, k, v, b, label, carries_blocks FROM design WHERE 1";
    const auto bound = [&](const char* condition, const auto& value) {
      if (value) {
        sql += fmt::format(" AND {} {}", condition, static_cast<std::uint64_t>(*value));
      }
    };
    bound("v >=", filter.v_from);
    bound("v <=", filter.v_to);
    bound("k >=", filter.k_from);
    bound("k <=", filter.k_to);
    bound("change =", filter.change);
    bound("strength =", filter.strength);
    if (filter.kind) {
      sql += fmt::format(" AND kind = {}", code_of(*filter.kind));
    }
    const auto collect = [&](Shelf& shelf, bool users) {
      for (Statement query = shelf.database().prepare(sql); query.step();) {
        rows.push_back({{query.integer(0), query.integer(1), query.integer(2), query.integer(3),
                         query.integer(4)},
                        query.integer(5),
                        query.text(6),
                        users,
                        query.integer(7) != 0});
      }
      return true;
    };
    if (store_->shipped && !filter.users_only) {
      collect(*store_->shipped, false);
    }
    store_->from_users(true, [&](Shelf& shelf) { return collect(shelf, true); });
  }
  std::ranges::sort(rows, {}, &Row::key);
  const auto twins = std::ranges::unique(rows, {}, &Row::name);
  rows.erase(twins.begin(), twins.end());
  std::ranges::sort(rows, {}, &Row::rank);
  const bool wants_retracted = filter.status == "retracted";
  const decltype(Row::cell)* taken = nullptr;  // the cell whose best was passed on
  for (const Row& row : rows) {
    if (filter.best_only && !wants_retracted && taken != nullptr && *taken == row.cell) {
      continue;
    }
    std::optional<CatalogEntry> entry;
    {
      const std::lock_guard lock(store_->mutex);
      entry = store_->exact(row.label);
    }
    if (!entry || entry->retracted.empty() == wants_retracted) {
      continue;
    }
    taken = &row.cell;
    const bool passes =
        (filter.status.empty() || entry->status() == filter.status) &&
        (filter.construction.empty() || entry->recipe.construction == filter.construction) &&
        (filter.since.empty() || entry->credit.date >= filter.since) &&
        (!filter.gap || entry->b >= entry->lower_bound + *filter.gap);
    if (passes && !take(*entry)) {
      return;
    }
  }
}

std::vector<Improvement> Catalog::history(const Parameters& p) const {
  std::vector<CatalogEntry> entries = cell(p);
  std::erase_if(entries, [](const CatalogEntry& entry) { return !entry.retracted.empty(); });
  // Entries of one day: the better ones last.
  std::ranges::stable_sort(entries, [](const CatalogEntry& a, const CatalogEntry& b) {
    return std::tuple(a.credit.date, b.b) < std::tuple(b.credit.date, a.b);
  });
  std::vector<Improvement> steps;
  for (const CatalogEntry& entry : entries) {
    if (steps.empty() || entry.b < steps.back().b) {
      const Credit& credit = entry.credit;
      std::string how = credit.command.empty() ? entry.recipe.construction : credit.command;
      if (!entry.cites.empty()) {
        std::string from = fmt::format("[{}]", fmt::join(entry.cites, ", "));
        how = credit.command.empty() ? std::move(from) : fmt::format("{}; {}", from, how);
      }
      for (const std::string& more : {entry.note, credit.who, credit.program}) {
        how += more.empty() ? "" : "; " + more;
      }
      steps.push_back({entry.label(), entry.b, credit.date, std::move(how)});
    }
  }
  return steps;
}

Catalog::Size Catalog::size() const {
  const std::lock_guard lock(store_->mutex);
  Size size;
  auto& shipped = store_->shipped;
  if (shipped) {
    // Tens of thousands of rows: all of it is in the index and the few credits.
    const Database& database = shipped->database();
    size.designs = database.integer("SELECT count(*) FROM design");
    size.cells = database.integer(
        "SELECT count(*) FROM (SELECT DISTINCT k, v, change, kind, strength FROM design)");
    for (Statement rows = database.prepare(
             "SELECT coalesce(max(json_extract(json, '$.credit.date')), '') FROM credit");
         rows.step();) {
      size.latest = rows.text(0);
    }
  }
  return store_->from_users(size, [&](Shelf& shelf) {
    Size both = size;
    std::set<Parameters> cells;
    for (Statement rows = shelf.database().prepare("SELECT label, date FROM design");
         rows.step();) {
      const std::string label = rows.text(0);
      both.designs += shipped && shipped->has(label) ? 0U : 1U;
      both.latest = std::max(both.latest, std::string(rows.text(1)));
      if (const auto parsed = parse_design_label(label)) {
        cells.insert(parsed->parameters);
      }
    }
    for (const Parameters& p : cells) {
      both.cells += shipped && shipped->has_cell(p) ? 0U : 1U;
    }
    return both;
  });
}

std::optional<std::uint64_t> Catalog::largest_users_v() const {
  const std::lock_guard lock(store_->mutex);
  const std::uint64_t v = store_->from_users(std::uint64_t{0}, [](Shelf& shelf) {
    return shelf.database().integer("SELECT coalesce(max(v), 0) FROM design");
  });
  return v == 0 ? std::nullopt : std::optional(v);
}

std::string Catalog::problem() const {
  const std::lock_guard lock(store_->mutex);
  store_->users();
  if (store_->problem.empty() && !store_->distrusted.empty()) {
    const auto& [label, why] = *store_->distrusted.begin();
    return fmt::format("{}: {} is left out: {}", store_->user_path, label, why);
  }
  return store_->problem;
}

std::string Catalog::remark() const {
  const std::lock_guard lock(store_->mutex);
  return store_->remark;
}

void Catalog::distrust(const std::string& label, const std::string& why) const {
  const std::lock_guard lock(store_->mutex);
  store_->distrusted.emplace(label, why);
}

bool Catalog::is_shipped(std::string_view label) const {
  const std::lock_guard lock(store_->mutex);
  return store_->shipped && store_->shipped->has(label);
}

const std::string& Catalog::user_path() const { return store_->user_path; }

}  // namespace changeover
