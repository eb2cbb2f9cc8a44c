#include "serve/export/site.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <set>
#include <string_view>
#include <vector>

#include "answer/catalog/completeness.hpp"
#include "answer/catalog/entry_words.hpp"
#include "answer/design/chosen_design.hpp"
#include "answer/design/recipe_tree.hpp"
#include "answer/known/known_table.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/version.hpp"
#include "changeover/draw/draw.hpp"
#include "changeover/run/control.hpp"
#include "io/write/json_writer.hpp"
#include "run/threads.hpp"
#include "serve/api/about.hpp"
#include "serve/api/cells.hpp"
#include "serve/api/selection.hpp"
#include "serve/export/workshop.hpp"

namespace changeover::serve {
namespace {

// The page says where its data are, and asks for nothing from elsewhere wherever it is put.
std::string static_index(std::string page) {
  constexpr std::string_view head = "<head>";
  const std::size_t at = page.find(head);
  if (at == std::string::npos) {
    throw MissingResource("index.html of the pages has no <head>");
  }
  page.insert(at + head.size(),
              "\n    <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
              "script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src "
              "'self'; base-uri 'none'; form-action 'none'\">"
              "\n    <meta name=\"changeover-data\" content=\"data/\">");
  return page;
}

std::string config_json(const Catalog& catalog) {
  const Catalog::Size size = catalog.size();
  JsonWriter json;
  json.begin_object().key("version").value(version);
  json.key("catalog").begin_object().key("designs").value(size.designs);
  json.key("cells").value(size.cells).key("version").value(size.latest).end_object();
  json.key("write").value(false).key("files").begin_array().end_array();
  json.key("static").value(true).end_object();
  return json.take() + "\n";
}

class Site {
 public:
  Site(Workshop& workshop, const SiteRange& range, const Catalog& catalog, RunControl& control)
      : workshop_(workshop), range_(range), catalog_(catalog), control_(control) {}

  void write_change(std::uint64_t change) {
    report_progress({.phase = fmt::format("planning change number {}", change), .unit = "files"});
    const cli::KnownTable table = cli::known_table({.k = range_.k, .v = range_.v, .change = change});
    for (const Kind kind : {Kind::circular, Kind::linear}) {
      const cli::Cells cells = table.cells(kind);
      const std::string name = fmt::format("{}.{}", change, to_string(kind));
      workshop_.write("data/table/" + name + ".json", cli::table_json(cells, true) + "\n");
      write_heatmaps(name, cells);
      write_cells(name, cells);
    }
  }

  [[nodiscard]] std::uint64_t cells() const { return cells_; }
  [[nodiscard]] std::uint64_t designs() const { return written_.size(); }

 private:
  void write_heatmaps(const std::string& name, const cli::Cells& cells) {
    std::vector<KnownCell> owned;
    for (const KnownCell* const cell : cells) {
      owned.push_back(*cell);
    }
    for (const HeatMeasure measure : {HeatMeasure::ratio, HeatMeasure::status, HeatMeasure::gap}) {
      const Picture picture = draw_heatmap(owned, measure);
      for (const Theme theme : {Theme::light, Theme::dark}) {
        workshop_.write(
            fmt::format("data/heatmap/{}.{}.{}.svg", name, to_string(measure), to_string(theme)),
            svg(picture, theme));
      }
    }
  }

  // A file for each k: an object by v. What is no list of blocks at all, with k > v, is in the table only.
  void write_cells(const std::string& name, cli::Cells cells) {
    std::erase_if(cells, [](const KnownCell* cell) {
      const Parameters& p = cell->parameters;
      return p.k > p.v || p.change > p.k;
    });
    std::vector<std::string> documents(cells.size());
    in_parallel(control_, cells.size(), [&](std::size_t i) {
      documents[i] = document_of(*cells[i]);
      report_progress({.phase = "writing the site", .steps = ++cells_, .unit = "cells"});
    });
    stop_if_asked();
    std::map<std::uint64_t, std::string> shelves;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Parameters& p = cells[i]->parameters;
      std::string& shelf = shelves[p.k];
      shelf += fmt::format("{}\"{}\":{}", shelf.empty() ? "{" : ",\n", p.v, documents[i]);
    }
    for (const auto& [k, shelf] : shelves) {
      workshop_.write(fmt::format("data/cell/{}.{}.json", name, k), shelf + "}\n");
    }
  }

  std::string document_of(const KnownCell& cell) {
    const Parameters& p = cell.parameters;
    std::string document = cell_json(catalog_, p);
    document.pop_back();
    document += ",\"explain\":" +
                (cell.best ? cli::explanation_json(cell.best->recipe) : std::string("null")) + "}";
    for (const CatalogEntry& entry : catalog_.cell(p)) {
      const std::string label = entry.label();
      if (entry.retracted.empty() && is_new(label)) {
        stop_if_asked();
        workshop_.write("data/design/" + label + ".json", design_json({cli::built(entry), label}));
        workshop_.write("data/cite/" + label + ".bib", cli::bibtex_of(entry));
      }
    }
    return document;
  }

  bool is_new(const std::string& label) {
    const std::scoped_lock lock(mutex_);
    return written_.insert(label).second;
  }

  Workshop& workshop_;
  const SiteRange& range_;
  const Catalog& catalog_;
  RunControl& control_;
  std::atomic<std::uint64_t> cells_ = 0;
  std::mutex mutex_;
  std::set<std::string> written_;
};

}  // namespace

SiteSummary export_site(const std::string& folder, const SiteRange& range, const Pages& pages,
                        const Catalog& catalog, RunControl& control) {
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
  workshop.write("index.html", static_index(*index->body));
  workshop.write("data/config.json", config_json(catalog));
  workshop.write("data/constructions.json", constructions_json());
  workshop.write("data/theorems.json", theorems_json());
  workshop.write("data/completeness.json",
                 cli::completeness_json(cli::completeness(catalog, {.best_only = true})) + "\n");
  Site site(workshop, range, catalog, control);
  for (const std::uint64_t change : range.changes) {
    site.write_change(change);
  }
  const auto kept = workshop.put_in_place();
  return {.kept = kept,
          .files = workshop.files(),
          .bytes = workshop.bytes(),
          .cells = site.cells(),
          .designs = site.designs()};
}

}  // namespace changeover::serve
