#include "changeover/curator/improve.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/version.hpp"
#include "changeover/curator/audit.hpp"
#include "changeover/run/scope.hpp"
#include "changeover/search/local_search.hpp"
#include "run/grace.hpp"

namespace changeover {
namespace {

using Seconds = std::chrono::duration<double>;

// A cell with something to gain.
struct Weak {
  Parameters parameters;
  std::uint64_t b = 0;
  std::uint64_t gap = 0;

  [[nodiscard]] bool before(const Weak& other) const {
    const double mine = static_cast<double>(gap) / static_cast<double>(b);
    const double theirs = static_cast<double>(other.gap) / static_cast<double>(other.b);
    return mine != theirs ? mine > theirs : parameters < other.parameters;
  }
};

std::vector<Weak> weakest(const Catalog& catalog, CatalogFilter filter) {
  filter.best_only = true;
  filter.gap = std::max<std::uint64_t>(filter.gap.value_or(1), 1);
  std::vector<Weak> cells;
  catalog.each(filter, [&](const CatalogEntry& entry) {
    cells.push_back({entry.parameters, entry.b, entry.b - entry.lower_bound});
    return true;
  });
  std::ranges::sort(cells, [](const Weak& a, const Weak& b) { return a.before(b); });
  return cells;
}

std::string command_of(const Parameters& p, const RunControl& control) {
  return fmt::format("changeover search {} {} --change {} --{}{} --seed {} --threads {}", p.v, p.k,
                     p.change, to_string(p.kind),
                     p.strength == 2 ? "" : fmt::format(" --strength {}", p.strength),
                     control.seed(), control.threads());
}

}  // namespace

std::vector<CatalogFind> improve_catalog(Catalog& catalog, const CatalogFilter& filter,
                                         RunControl& control, const CatalogSearch& search,
                                         const std::function<void(const CatalogFind&)>& found) {
  std::vector<CatalogFind> finds;
  std::vector<Weak> cells = weakest(catalog, filter);
  const double fiftieth = control.time_left().value_or(Seconds(3000)).count() / 50;
  Seconds each = search.each.value_or(Seconds(std::clamp(fiftieth, 1.0, 60.0)));
  for (; !cells.empty() && !control.stop_wanted(); each *= 2) {
    for (Weak& cell : cells) {
      if (control.stop_wanted()) {
        break;
      }
      ImproveResult result;
      try {
        RunControl here(control, each);
        result = improve(cell.parameters, {}, here);
      } catch (const Stopped&) {
        continue;  // Before it had a design to start from.
      }
      if (!result.design || result.design->block_count() >= cell.b) {
        continue;
      }
      // What was found is verified and kept, however little time is left.
      const RunGrace to_the_end(control);
      Design design = result.design->design();
      Introduction introduction = search.introduction;
      if (result.how != "best recipe") {
        design.recipe = literal_recipe(design);
        introduction.credit.command = command_of(cell.parameters, control);
      }
      introduction.credit.program = fmt::format("changeover {}", version);
      const Newcomer newcomer = newcomer_of(design, introduction);
      if (!newcomer.entry) {
        throw InternalError("a search handed out a list of blocks that is no design: " +
                            newcomer.refused);
      }
      catalog.add(*newcomer.entry);
      const CatalogEntry& entry = *newcomer.entry;
      finds.push_back({entry.label(), cell.parameters, cell.b, entry.b, result.how});
      cell.b = entry.b;
      cell.gap = entry.b - entry.lower_bound;
      if (found) {
        found(finds.back());
      }
    }
    std::erase_if(cells, [](const Weak& cell) { return cell.gap == 0; });
  }
  return finds;
}

Submission write_submission(const Catalog& catalog, Sink& sink) {
  Submission submission;
  const Registry constructions(registry_entries());
  sink.write(header_line({}) + "\n");
  catalog.each({.users_only = true}, [&](const CatalogEntry& entry) {
    stop_if_asked();
    const std::string label = entry.label();
    const auto is_as_good = [&](const CatalogEntry& other) {
      return other.retracted.empty() && other.b <= entry.b && catalog.is_shipped(other.label());
    };
    const auto is_made = [&](const Offer& offer) {
      return offer.recipe.construction != "found" && offer.b <= entry.b;
    };
    if (catalog.is_shipped(label) ||
        std::ranges::any_of(catalog.cell(entry.parameters), is_as_good) ||
        (entry.carries_blocks() &&
         std::ranges::any_of(constructions.offers(entry.parameters), is_made))) {
      return true;
    }
    if (const std::string fault = fault_of_entry(entry); !fault.empty()) {
      submission.left_out.push_back(fmt::format("{}: {}", label, fault));
      return true;
    }
    sink.write(line_of(entry, {}) + "\n");
    ++submission.entries;
    return true;
  });
  return submission;
}

}  // namespace changeover
