#include "changeover/curator/curator.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "catalog/store/spool.hpp"
#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "construct/trusted_entry.hpp"
#include "io/scan/input_lines.hpp"
#include "io/scan/place.hpp"

namespace changeover {
namespace {

// The entries of a file, line by line.
class EntryLines {
 public:
  EntryLines(Input& input, std::size_t longest) : lines_(input, longest) {
    if (lines_.next() != InputLines::Next::line) {
      throw BadInput(
          fmt::format("{}: the file is empty; name one that catalog export wrote", input.name()));
    }
    shared_ = shared_from_header(lines_.line(), input.name());
  }

  // Goes to the next line; false at the end. @throws BadInput if a line is too long, after which
  // reading cannot go on.
  bool next() {
    for (;;) {
      const InputLines::Next found = lines_.next();
      if (found == InputLines::Next::too_long) {
        throw BadInput(where() + "the line is too long for an entry; remove it");
      }
      if (found == InputLines::Next::end) {
        return false;
      }
      // Concatenated files have byte order marks inside.
      if (!without_byte_order_mark(lines_.line()).empty()) {
        return true;
      }
    }
  }

  // @throws BadInput as entry_from_line().
  [[nodiscard]] CatalogEntry entry() const {
    return entry_from_line(lines_.line(), lines_.name(), lines_.number(), shared_);
  }
  [[nodiscard]] std::string where() const {
    return fmt::format("{}:{}: ", lines_.name(), lines_.number());
  }

 private:
  InputLines lines_;
  Credit shared_;
};

// Why an entry is not taken; empty if it is, with the bound of today.
std::string refusal(CatalogEntry& entry, const ForeignLimits& limits) {
  const Parameters& p = entry.parameters;
  if (p.v > limits.v || entry.b > limits.b) {
    return fmt::format(
        "more than {} elements or {} blocks, too many for an import; add the design itself",
        limits.v, limits.b);
  }
  const Bound bound = lower_bound(p);
  if (entry.lower_bound > bound.blocks) {
    return fmt::format("it claims the lower bound {}, but only {} is known; correct lower_bound",
                       entry.lower_bound, bound.blocks);
  }
  RunControl* const above = RunScope::current();
  RunControl::Settings settings;
  settings.memory_bytes = limits.memory_each;
  if (above != nullptr) {
    settings.memory_bytes =
        std::min(limits.memory_each, above->settings().memory_bytes.value_or(limits.memory_each));
    settings.found_elsewhere = [above] { return above->stop_wanted(); };
  }
  RunControl here(std::move(settings));
  RunControl control(here, limits.time_each);
  const RunScope scope(control);
  try {
    if (std::string defect = entry_defect(entry); !defect.empty()) {
      return defect;
    }
  } catch (const Stopped&) {
    if (above != nullptr && above->stop_wanted()) {
      throw;
    }
    return fmt::format("building and verifying it takes longer than {} s",
                       limits.time_each.count());
  }
  entry.lower_bound = bound.blocks;
  entry.reason = bound.reason;
  return "";
}

// Passes each good entry that is not in the catalog to take(). Returns the other results.
template <typename Take>
Foreign each_foreign(Input& input, const Catalog& catalog, const ForeignLimits& limits,
                     Take&& take) {
  Foreign foreign;
  EntryLines lines(input, limits.line);
  for (std::uint64_t count = 0; lines.next(); ++count) {
    stop_if_asked();
    if (count == limits.entries) {
      throw BadInput(fmt::format("{}more than {} entries; split the file", lines.where(), count));
    }
    std::string fault;
    try {
      CatalogEntry entry = lines.entry();
      const std::string label = entry.label();
      const auto there = catalog.find(label);
      Spool::Put put = there && there->checksum == entry.checksum ? Spool::Put::there_already
                                                                  : Spool::Put::label_of_another;
      std::string why;
      if (!there) {
        why = refusal(entry, limits);
        put = why.empty() ? take(std::move(entry)) : put;
      }
      if (!why.empty()) {
        fault = fmt::format("{}{}: {}", lines.where(), label, why);
      } else if (put == Spool::Put::label_of_another) {
        fault = fmt::format("{}{}: another design has that label", lines.where(), label);
      } else if (put == Spool::Put::there_already) {
        ++foreign.known;
      }
    } catch (const BadInput& malformed) {
      fault = malformed.what();
    } catch (const ImpossibleParameters& malformed) {
      fault = lines.where() + malformed.what();
    }
    if (!fault.empty()) {
      if (!limits.skip_bad) {
        throw BadInput(fault);
      }
      foreign.left_out.push_back(std::move(fault));
    }
    if (progress_due()) {
      report_progress(
          {.phase = "verifying " + input.name(), .steps = count + 1, .unit = "entries"});
    }
  }
  return foreign;
}

}  // namespace

std::uint64_t write_entries(const Catalog& catalog, const CatalogFilter& filter, Sink& sink) {
  std::uint64_t count = 0;
  sink.write(header_line({}) + "\n");
  const auto write = [&](const CatalogEntry& entry) {
    sink.write(line_of(entry, {}) + "\n");
    ++count;
    return true;
  };
  catalog.each(filter, write);
  if (filter.status.empty()) {
    CatalogFilter retracted = filter;
    retracted.status = "retracted";
    catalog.each(retracted, write);
  }
  return count;
}

Foreign read_foreign(Input& input, const Catalog& catalog, const ForeignLimits& limits) {
  std::vector<CatalogEntry> entries;
  std::map<std::string, Checksum> labels;
  Foreign foreign = each_foreign(input, catalog, limits, [&](CatalogEntry&& entry) {
    const auto [place, is_new] = labels.emplace(entry.label(), entry.checksum);
    if (is_new) {
      entries.push_back(std::move(entry));
      return Spool::Put::taken;
    }
    return place->second == entry.checksum ? Spool::Put::there_already
                                           : Spool::Put::label_of_another;
  });
  foreign.entries = std::move(entries);
  return foreign;
}

Imported import_foreign(Input& input, Catalog& catalog, const ForeignLimits& limits,
                        std::size_t batch) {
  Spool spool;
  Foreign foreign = each_foreign(input, catalog, limits,
                                 [&](const CatalogEntry& entry) { return spool.put(entry); });
  Imported imported;
  imported.known = foreign.known;
  imported.left_out = std::move(foreign.left_out);
  const auto next = [&, is_first = true]() mutable -> std::vector<CatalogEntry> {
    RunControl* const above = RunScope::current();
    const bool stops = !std::exchange(is_first, false) && above != nullptr && above->stop_wanted();
    return stops ? std::vector<CatalogEntry>() : spool.take(batch);
  };
  const auto count = [&](std::span<const Added> results) {
    for (const Added what : results) {
      imported.added += what == Added::already_there ? 0U : 1U;
      imported.improved += what == Added::improved ? 1U : 0U;
      imported.known += what == Added::already_there ? 1U : 0U;
    }
    if (progress_due()) {
      report_progress(
          {.phase = "adding " + input.name(), .steps = imported.added, .unit = "entries"});
    }
  };
  stop_if_asked();
  catalog.add_lists(next, count);
  imported.not_added = spool.waiting();
  return imported;
}

BestOfCells best_of_cells(Input& input) {
  BestOfCells best;
  for (EntryLines lines(input, longest_catalog_line); lines.next();) {
    const CatalogEntry entry = lines.entry();
    if (entry.retracted.empty()) {
      const auto [place, is_new] = best.emplace(entry.parameters, entry.b);
      place->second = std::min(place->second, entry.b);
    }
  }
  return best;
}

BestOfCells best_of_cells(const Catalog& catalog) {
  BestOfCells best;
  catalog.each({}, [&](const CatalogEntry& entry) {
    best.emplace(entry.parameters, entry.b);
    return true;
  });
  return best;
}

std::string_view CellChange::kind() const {
  if (before == 0 || after == 0) {
    return before == 0 ? "new" : "gone";
  }
  return after < before ? "better" : "worse";
}

std::vector<CellChange> compare_cells(const BestOfCells& before, const BestOfCells& after) {
  std::map<Parameters, CellChange> changes;
  for (const auto& [p, b] : before) {
    changes[p] = {p, b, 0};
  }
  for (const auto& [p, b] : after) {
    CellChange& change = changes[p];
    change.parameters = p;
    change.after = b;
  }
  std::vector<CellChange> different;
  for (const auto& [p, change] : changes) {
    if (change.before != change.after) {
      different.push_back(change);
    }
  }
  return different;
}

}  // namespace changeover
