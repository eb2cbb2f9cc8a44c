#include "changeover/search/exact.hpp"

#include <algorithm>
#include <exception>
#include <limits>
#include <tuple>
#include <utility>

#include "changeover/construct/best_known.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {
namespace {

auto place(const Parameters& p) { return std::tuple(p.strength, p.change, p.kind, p.k, p.v); }

bool before(const MinimaRow& row, const Parameters& p) { return place(row.parameters) < place(p); }

std::uint64_t limit_of(const MinimumOptions& options) {
  return options.exact.conflicts_per_step.value_or(std::numeric_limits<std::uint32_t>::max());
}

MinimaRow settle(const Parameters& p, const MinimumOptions& options, RunControl& control) {
  MinimaRow row{.parameters = p};
  std::optional<Design> known;
  if (const auto best = best_known(Registry::standard(), p)) {
    known = Registry::standard().build_design(best->recipe);
    row.by = best->recipe.construction;
  }
  const MinimumResult result = find_minimum(p, options, control, known);
  if (result.fault) {
    std::rethrow_exception(result.fault);
  }
  row.start = result.start.blocks;
  row.lower = result.lower;
  row.upper = result.upper();
  if (row.upper && (!known || *row.upper < known->block_count())) {
    row.by = "SAT";
  }
  for (const Decision& step : result.steps) {
    row.seconds += step.time.count();
    for (const CheckedPart& part : step.parts) {
      if (step.excluded()) {
        row.solve_seconds += part.solve_time.count();
        row.check_seconds += part.check_time.count();
        row.proof_bytes += part.proof_bytes;
        row.proof_steps += part.proof_steps;
      }
    }
  }
  row.limit = limit_of(options);
  return row;
}

// Constructions may have improved since the row was made. Returns whether they have.
bool lower_upper_end(MinimaRow& row) {
  const auto best = best_known(Registry::standard(), row.parameters);
  if (!best || (row.upper && *row.upper <= best->b)) {
    return false;
  }
  const Design design = Registry::standard().build_design(best->recipe);
  if (design.block_count() != best->b || !verify(design).valid()) {
    return false;
  }
  row.upper = best->b;
  row.by = best->recipe.construction;
  return true;
}

void fill(const MinimaRange& range, std::vector<MinimaRow>& rows, const MinimumOptions& options,
          RunControl& control, const std::function<void(const MinimaRow&)>& on_row) {
  const std::uint64_t limit = limit_of(options);
  for (std::uint64_t v = 2; v <= range.v_to; ++v) {
    for (const std::uint64_t m : range.changes) {
      for (const Kind kind : {Kind::linear, Kind::circular}) {
        for (std::uint64_t k = std::max<std::uint64_t>({range.k_from, range.strength, m});
             k <= range.k_to && k + m <= v; ++k) {
          stop_if_asked();
          const Parameters p{.v = v, .k = k, .change = m, .kind = kind, .strength = range.strength};
          auto at = std::lower_bound(rows.begin(), rows.end(), p, before);
          const bool there = at != rows.end() && at->parameters == p;
          if (impossibility(p)) {
            continue;
          }
          if (there && !at->settled() && lower_upper_end(*at)) {
            on_row(*at);
          }
          if (there && (at->settled() || at->limit >= limit)) {
            continue;
          }
          MinimaRow row = settle(p, options, control);
          if (!row.settled() && control.stop_wanted()) {
            continue;  // not tried with as many conflicts
          }
          at = there ? at : rows.insert(at, MinimaRow{});
          *at = std::move(row);
          on_row(*at);
        }
      }
    }
  }
}

}  // namespace

void fill_minima(const MinimaRange& range, std::vector<MinimaRow>& rows,
                 const MinimumOptions& options, RunControl& control,
                 const std::function<void(const MinimaRow&)>& on_row) {
  if (options.exact.wanted.any()) {
    throw InternalError("a table of minima is of all designs, not of those that have more");
  }
  try {
    fill(range, rows, options, control, on_row);
  } catch (const Stopped&) {
    // Rows that were filled in stay.
  }
}

}  // namespace changeover
