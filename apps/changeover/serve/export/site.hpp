// The explorer as files, for any web server: pages that look up what was written down, without this
// program.
//
//     const SiteSummary site =
//         export_site("public", {.k = {3, 8}, .v = {4, 40}}, {}, pages, catalog, control);
//
// docs/explorer.md has the rule by which addresses become files. The site is made beside its place
// and put there when it is whole: after a kill there is the old site or none. A folder that holds
// anything else is left alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/run/control.hpp"
#include "request/parameters.hpp"
#include "serve/pages/pages.hpp"

namespace changeover::serve {

/// All cells that the catalog comes with, unless others are asked for.
struct SiteRange {
  cli::Range k{3, 40};
  cli::Range v{4, 160};
  std::vector<std::uint64_t> changes{1, 2, 3};
};

/// Addresses on the web, each of which can be empty.
struct SiteLinks {
  std::string address;  ///< where the site will be; else it has no sitemap and no feed
  std::string sources;  ///< where the program can be got, for those who want to go on with it
};

struct SiteSummary {
  std::optional<std::string> kept = {};  ///< where what could not be removed of the earlier one is
  std::uint64_t files = 0;
  std::uint64_t bytes = 0;
  std::uint64_t cells = 0;
  std::uint64_t designs = 0;
};

/// Every design is verified before it is written. Uses the threads of the control.
/// @throws MissingResource if there are no pages, if the folder is not new, empty or a site that
/// was made here, or if it cannot be written; Stopped; cli::UsageError for a range that is too
/// large.
SiteSummary export_site(const std::string& folder, const SiteRange& range, const SiteLinks& links,
                        const Pages& pages, const Catalog& catalog, RunControl& control);

}  // namespace changeover::serve
