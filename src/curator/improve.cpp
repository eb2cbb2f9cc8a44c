#include "changeover/curator/curator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/version.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/local_search.hpp"
#include "curator/by_base_blocks.hpp"
#include "curator/weakest.hpp"
#include "run/grace.hpp"

namespace changeover {
namespace {

using Seconds = std::chrono::duration<double>;

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
  WeakestFirst cells = [&] {
    const RunScope scope(control);
    return WeakestFirst(catalog, filter);
  }();
  const double fiftieth = control.time_left().value_or(Seconds(3000)).count() / 50;
  Seconds each = search.each.value_or(Seconds(std::clamp(fiftieth, 1.0, 60.0)));
  for (std::uint64_t pass = 0; !control.stop_wanted(); ++pass, each *= 2) {
    // Other random numbers in each pass: those of the last pass found nothing.
    RunControl::Settings settings = control.settings();
    settings.seed += pass;
    settings.time = control.time_left();
    settings.found_elsewhere = [&control] { return control.stop_wanted(); };
    RunControl control_of_pass(std::move(settings));
    cells.begin_pass();
    auto next = cells.next();
    if (!next) {
      break;
    }
    for (; next && !control.stop_wanted(); next = cells.next()) {
      const Parameters p = *next;
      ImproveResult result;
      try {
        RunControl here(control_of_pass, each);
        result = improve(p, {}, here);
      } catch (const Stopped&) {
        continue;  // It stopped before it had a design to start from.
      }
      const auto before = catalog.fewest(p);
      if (!result.design || !before || result.design->block_count() >= before->b) {
        continue;
      }
      // A find is verified and kept even if the time is up.
      const RunGrace to_the_end(control);
      Design design = result.design->design();
      cells.improved(p, design.block_count());
      Introduction introduction = search.introduction;
      const bool is_found = result.how != "best recipe";
      if (is_found) {
        design = by_base_blocks(design).value_or(design);
        if (!design.recipe || design.recipe->construction != "developed") {
          design.recipe = literal_recipe(design);
        }
        introduction.credit.command = command_of(p, control_of_pass);
      }
      introduction.credit.program = fmt::format("changeover {}", version);
      const Newcomer newcomer = newcomer_of(design, introduction);
      if (!newcomer.entry) {
        throw InternalError("a search returned blocks that are not a design: " + newcomer.refused);
      }
      const CatalogEntry& entry = *newcomer.entry;
      if (!is_found && entry.recipe != design.recipe) {
        continue;  // The closure rules make it from the user's designs.
      }
      catalog.add(entry);
      finds.push_back({entry.label(), p, before->b, entry.b, result.how});
      if (found) {
        found(finds.back());
      }
    }
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
    submission.labels.push_back(label);
    return true;
  });
  return submission;
}

}  // namespace changeover
