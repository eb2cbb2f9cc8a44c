#include "serve/export/site.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <map>
#include <mutex>
#include <set>
#include <string_view>
#include <vector>

#include "answer/catalog/entry_words.hpp"
#include "answer/design/chosen_design.hpp"
#include "answer/design/recipe_tree.hpp"
#include "answer/known/known_table.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/version.hpp"
#include "changeover/run/control.hpp"
#include "core/each.hpp"
#include "io/write/json_writer.hpp"
#include "run/threads.hpp"
#include "serve/api/about.hpp"
#include "serve/api/atlas.hpp"
#include "serve/api/cells.hpp"
#include "serve/export/addresses.hpp"
#include "serve/export/citations.hpp"
#include "serve/export/packed_designs.hpp"
#include "serve/export/workshop.hpp"

namespace changeover::serve {
namespace {

// No page shows designs with more.
constexpr std::uint64_t most_exported_blocks = 200'000;

// The page says where its data are, and asks for nothing from elsewhere wherever it is put.
std::string static_index(std::string page, const std::string& address) {
  constexpr std::string_view head = "<head>";
  const std::size_t at = page.find(head);
  if (at == std::string::npos) {
    throw MissingResource("index.html of the pages has no <head>; name other pages with --assets");
  }
  const std::string feed = address.empty()
                               ? std::string()
                               : "\n    <link rel=\"alternate\" type=\"application/atom+xml\" "
                                 "title=\"New designs\" href=\"feed.xml\">";
  page.insert(at + head.size(), "\n    <meta http-equiv=\"Content-Security-Policy\" content=\"" +
                                    content_policy(page) +
                                    "\">\n    <meta name=\"changeover-data\" content=\"data/\">" +
                                    feed);
  return page;
}

std::string config_json(const Catalog& catalog, const SiteRange& range,
                        const std::string& sources) {
  const Catalog::Size size = catalog.size();
  JsonWriter json;
  json.begin_object().key("version").value(version);
  json.key("catalog").begin_object().key("designs").value(size.designs);
  json.key("cells").value(size.cells).key("version").value(size.latest).end_object();
  json.key("write").value(false).key("files").begin_array().end_array();
  json.key("static").value(true);
  if (!sources.empty()) {
    json.key("sources").value(sources);
  }
  json.key("range").begin_object().key("k_from").value(range.k.from).key("k_to").value(range.k.to);
  json.key("v_from").value(range.v.from).key("v_to").value(range.v.to);
  json.key("changes").value(range.changes).end_object().end_object();
  return json.take() + "\n";
}

// Files that only these pages read are compressed: any server can send them as they are.
std::string packed(std::string_view text) {
  constexpr int smallest = 9;
  return gzip(text, smallest);
}

// A cell without a recipe for each offer: the page names constructions only. What its designs have
// in common with it is not said again.
std::string shelved_cell(const Catalog& catalog, const Parameters& p) {
  return cell_json(catalog, p, CellWords::fewest);
}

class Site {
 public:
  Site(Workshop& workshop, const SiteRange& range, std::string address, const Catalog& catalog,
       RunControl& control)
      : workshop_(workshop),
        range_(range),
        address_(std::move(address)),
        catalog_(catalog),
        control_(control) {}

  void write_change(std::uint64_t change) {
    report_progress({.phase = fmt::format("planning change number {}", change), .unit = "files"});
    const cli::KnownTable table =
        cli::known_table({.k = range_.k, .v = range_.v, .change = change});
    for (const Kind kind : {Kind::circular, Kind::linear}) {
      const AtlasQuestion asked{.range = table.range(), .kind = kind};
      write_selection(fmt::format("{}.{}", change, to_string(kind)), asked, table.cells(kind));
    }
  }

  // For larger strengths: what the range has of the little that is known.
  void write_strength(std::uint64_t change, std::uint32_t strength) {
    const auto common = [](const cli::Range& a, const cli::Range& b) {
      return cli::Range{std::max(a.from, b.from), std::min(a.to, b.to)};
    };
    const cli::TableRange all = atlas_range(change, strength);
    const cli::TableRange range{
        .k = common(all.k, range_.k), .v = common(all.v, range_.v), .change = change};
    if (range.k.from > range.k.to || range.v.from > range.v.to) {
      return;
    }
    for (const Kind kind : {Kind::circular, Kind::linear}) {
      const AtlasQuestion asked{.range = range, .kind = kind, .strength = strength};
      const std::deque<KnownCell> held = cells_of_strength(asked);
      Cells cells;
      for (const KnownCell& cell : held) {
        cells.push_back(&cell);
      }
      write_selection(fmt::format("{}.{}.t{}", change, to_string(kind), strength), asked, cells);
    }
  }

  // Where the site will be is known: then addresses of all that it has can be named.
  void write_addresses() {
    std::vector<std::string> maps;
    const auto write = [&](const std::string& name, const std::vector<std::string>& addresses) {
      for (std::size_t from = 0, part = 1; from < addresses.size();
           from += most_addresses, ++part) {
        const auto end = std::min(addresses.size(), from + most_addresses);
        const std::string file = fmt::format("sitemap-{}-{}.xml.gz", name, part);
        workshop_.write(file,
                        packed(sitemap({addresses.begin() + static_cast<std::ptrdiff_t>(from),
                                        addresses.begin() + static_cast<std::ptrdiff_t>(end)})));
        maps.push_back(address_ + file);
      }
    };
    std::ranges::sort(named_cells_);
    write("cells", named_cells_);
    std::vector<std::string> designs;
    designs.reserve(written_.size());
    for (const std::string& label : written_) {
      designs.push_back(address_of_design(address_, label));
    }
    write("designs", designs);
    workshop_.write("sitemap.xml", sitemap_index(maps));
    workshop_.write("robots.txt",
                    fmt::format("User-agent: *\nAllow: /\nSitemap: {}sitemap.xml\n", address_));
    workshop_.write("feed.xml", feed(address_, catalog_));
  }

  void write_citations() {
    workshop_.write("data/citations.json.gz", packed(citations_.json() + "\n"));
  }

  [[nodiscard]] std::uint64_t cells() const { return cells_; }
  [[nodiscard]] std::uint64_t designs() const { return written_.size() + made_; }

 private:
  void write_selection(const std::string& name, const AtlasQuestion& asked, const Cells& cells) {
    workshop_.write("data/atlas/" + name + ".json.gz",
                    packed(atlas_json(asked.cells(), cells, asked.strength)));
    workshop_.write("data/groups/" + name + ".json.gz", packed(groups_json(asked, cells)));
    write_cells(name, cells);
  }

  // A file for each k: an object by v; and one with the designs. What is no list of blocks at all,
  // with k > v, is in the atlas only.
  void write_cells(const std::string& name, Cells cells) {
    std::erase_if(cells, [](const KnownCell* cell) {
      const Parameters& p = cell->parameters;
      return p.k > p.v || p.change > p.k;
    });
    std::vector<std::string> documents(cells.size());
    std::vector<std::vector<CatalogEntry>> entries(cells.size());
    std::map<std::uint64_t, PackedDesigns> designs;
    for (const KnownCell* const cell : cells) {
      designs[cell->parameters.k];
    }
    in_parallel(control_, cells.size(), [&](std::size_t i) {
      entries[i] = catalog_.cell(cells[i]->parameters);
      documents[i] = document_of(*cells[i], entries[i], designs.at(cells[i]->parameters.k));
      report_progress({.phase = "writing the site", .steps = ++cells_, .unit = "cells"});
    });
    stop_if_asked();
    std::map<std::uint64_t, std::string> shelves;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Parameters& p = cells[i]->parameters;
      std::string& shelf = shelves[p.k];
      shelf += fmt::format("{}\"{}\":{},\"cite\":[{}]}}", shelf.empty() ? "{" : ",\n", p.v,
                           documents[i], joined(entries[i], ",", [&](const CatalogEntry& entry) {
                             return std::to_string(citations_.number(entry, cli::bibtex_of(entry)));
                           }));
      named_cells_.push_back(address_of_cell(address_, p));
    }
    for (const auto& [k, shelf] : shelves) {
      workshop_.write(fmt::format("data/cell/{}.{}.json.gz", name, k), packed(shelf + "}\n"));
      workshop_.write(fmt::format("data/design/{}.{}.gz", name, k), packed(designs.at(k).take()));
    }
  }

  // With how it is made; not yet at its end.
  std::string document_of(const KnownCell& cell, const std::vector<CatalogEntry>& entries,
                          PackedDesigns& designs) {
    std::string document = shelved_cell(catalog_, cell.parameters);
    document.pop_back();
    document += ",\"tree\":" + (cell.best ? cli::tree_json(cell.best->recipe) : "null");
    for (const CatalogEntry& entry : entries) {
      const std::string label = entry.label();
      if (entry.retracted.empty() && is_new(label)) {
        stop_if_asked();
        const cli::ChosenDesign chosen = cli::built(entry);
        Design design = read_all(*chosen.source);
        design.set_labels(chosen.exhibit.header.labels);
        designs.add(label, design, chosen.exhibit.judgement.verdict);
      }
    }
    if (cell.best && cell.best->b <= most_exported_blocks && label_of(*cell.best).empty()) {
      write_made(*cell.best, designs);
    }
    return document;
  }

  // A best design of a construction, which the catalog does not keep: no link to it leads nowhere.
  void write_made(const Offer& best, PackedDesigns& designs) {
    stop_if_asked();
    const cli::ChosenDesign chosen = cli::built(best);
    Design design = read_all(*chosen.source);
    design.set_labels(chosen.exhibit.header.labels);
    designs.add(cell_label(best.recipe.parameters), design, chosen.exhibit.judgement.verdict);
    ++made_;
  }

  bool is_new(const std::string& label) {
    const std::scoped_lock lock(mutex_);
    return written_.insert(label).second;
  }

  Workshop& workshop_;
  const SiteRange& range_;
  std::string address_;
  const Catalog& catalog_;
  RunControl& control_;
  std::atomic<std::uint64_t> cells_ = 0;
  std::atomic<std::uint64_t> made_ = 0;
  std::vector<std::string> named_cells_;
  CitationForms citations_;
  std::mutex mutex_;
  std::set<std::string> written_;
};

}  // namespace

SiteSummary export_site(const std::string& folder, const SiteRange& range, const SiteLinks& links,
                        const Pages& pages, const Catalog& catalog, RunControl& control) {
  const auto index = pages.find("index.html");
  if (!index) {
    throw MissingResource("this program was built without pages; give --assets DIR");
  }
  for (const std::uint64_t change : range.changes) {
    cli::check_table({.k = range.k, .v = range.v, .change = change});
  }
  Workshop workshop(folder);
  for (const std::string& path : pages.paths()) {
    const auto page = pages.find(path);
    if (page && path != "index.html") {
      workshop.write(path, *page->body);
    }
  }
  workshop.write("index.html", static_index(*index->body, links.address));
  workshop.write("data/config.json", config_json(catalog, range, links.sources));
  workshop.write("data/constructions.json", constructions_json());
  workshop.write("data/theorems.json", theorems_json());
  workshop.write("data/completeness.json",
                 cli::completeness_json(cli::completeness(catalog, {.best_only = true})) + "\n");
  Site site(workshop, range, links.address, catalog, control);
  for (const std::uint64_t change : range.changes) {
    site.write_change(change);
    for (std::uint32_t strength = 3; strength <= max_strength; ++strength) {
      site.write_strength(change, strength);
    }
  }
  site.write_citations();
  if (!links.address.empty()) {
    site.write_addresses();
  }
  const auto kept = workshop.put_in_place();
  return {.kept = kept,
          .files = workshop.files(),
          .bytes = workshop.bytes(),
          .cells = site.cells(),
          .designs = site.designs()};
}

}  // namespace changeover::serve
