#include "serve/export/site.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "answer/catalog/completeness.hpp"
#include "answer/catalog/entry_words.hpp"
#include "answer/design/chosen_design.hpp"
#include "answer/design/recipe_tree.hpp"
#include "answer/known/planned_table.hpp"
#include "changeover/catalog/label.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/version.hpp"
#include "changeover/draw/heatmap.hpp"
#include "changeover/run/scope.hpp"
#include "core/printable.hpp"
#include "io/file/left_behind.hpp"
#include "io/write/json_writer.hpp"
#include "run/threads.hpp"
#include "serve/api/about.hpp"
#include "serve/api/cells.hpp"
#include "serve/api/selection.hpp"

namespace changeover::serve {
namespace {

namespace fs = std::filesystem;

constexpr const char* marker = ".changeover-explorer";
// In a folder that an export works in, and in an old site that it removes: may be removed by whoever finds it unlocked. A site
// that somebody wants to keep has none, whatever its name is.
constexpr const char* unfinished = ".changeover-unfinished";

// What is at the top of a site.
bool is_of_a_site(const std::string& name) {
  static const std::set<std::string> ours{marker,   unfinished, "index.html",
                                          "assets", "data",     "sources.sha256"};
  return ours.contains(name);
}

[[noreturn]] void cannot(const std::string& what, const fs::path& path, int why) {
  throw MissingResource(
      fmt::format("cannot {} {}: {}", what, printable(path.string()), std::strerror(why)));
}

// A descriptor of a folder, which may be locked by it; -1 if there is none.
class OpenFolder {
 public:
  OpenFolder() = default;
  explicit OpenFolder(const fs::path& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)) {}
  ~OpenFolder() {
    if (descriptor_ >= 0) {
      ::close(descriptor_);
    }
  }
  OpenFolder(OpenFolder&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  OpenFolder& operator=(OpenFolder&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  OpenFolder(const OpenFolder&) = delete;
  OpenFolder& operator=(const OpenFolder&) = delete;
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_ = -1;
};

constexpr std::string_view before_random = ".new-";
constexpr std::size_t random_letters = 6;  // of mkdtemp

// Removes a folder, its mark last: it can be killed.
void remove_marked(const fs::path& folder) {
  std::error_code fault;
  std::vector<fs::path> found;
  for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
    if (at->path().filename() != unfinished) {
      found.push_back(at->path());
    }
  }
  for (const fs::path& path : found) {
    fs::remove_all(path, fault);
  }
  fs::remove_all(folder, fault);
}

// Removes what exports to `place` left that were killed. Whoever makes a site has its folder locked, as the temporaries of files
// are (io/file/left_behind.hpp).
void remove_left_behind(const fs::path& place) {
  const std::string front = place.filename().string() + std::string(before_random);
  std::vector<fs::path> found;
  std::error_code fault;
  for (fs::directory_iterator at(place.parent_path(), fault), end; !fault && at != end;
       at.increment(fault)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with(front) && name.size() == front.size() + random_letters) {
      found.push_back(at->path());
    }
  }
  for (const fs::path& path : found) {
    const OpenFolder folder(path);
    if (folder.descriptor() < 0 || ::flock(folder.descriptor(), LOCK_EX | LOCK_NB) != 0) {
      continue;
    }
    bool nothing_else = true;
    bool empty = true;
    for (fs::directory_iterator at(path, fault), end; !fault && at != end; at.increment(fault)) {
      nothing_else = nothing_else && is_of_a_site(at->path().filename().string());
      empty = false;
    }
    std::error_code none;
    const bool marked = fs::is_regular_file(fs::symlink_status(path / unfinished, none));
    if (!fault && nothing_else && (marked || empty)) {
      remove_marked(path);
    }
  }
}

// A folder beside the place of the site, which goes away unless it is put there.
class Workshop {
 public:
  explicit Workshop(const std::string& place) : place_(fs::absolute(place).lexically_normal()) {
    if (!place_.has_filename()) {
      place_ = place_.parent_path();
    }
    std::error_code fault;
    const fs::file_status status = fs::status(place_, fault);
    there_ = fs::exists(status);
    if (there_ && !fs::is_directory(status)) {
      throw MissingResource(
          fmt::format("--export {}: it is no folder; name a new one", printable(place)));
    }
    if (there_) {
      place_ = fs::canonical(place_);
    }
    if (there_ && !fs::is_empty(place_) && !fs::exists(place_ / marker)) {
      throw MissingResource(
          fmt::format("--export {}: the folder holds other things; name a new one, or an empty one",
                      printable(place)));
    }
    if (there_) {
      refuse_what_was_added(place);
    }
    remove_left_behind(place_);
    do {
      std::string pattern =
          fmt::format("{}{}{}", place_.string(), before_random, std::string(random_letters, 'X'));
      if (::mkdtemp(pattern.data()) == nullptr) {
        cannot("make a folder beside", place_, errno);
      }
      work_ = pattern;
      folder_ = OpenFolder(work_);
      if (folder_.descriptor() < 0 && errno != ENOENT) {
        cannot("open", work_, errno);
      }
      // Another export may have taken it for one that was left.
    } while (folder_.descriptor() < 0 || !claim_temporary(folder_.descriptor(), work_.string()));
    constexpr auto as_folders_are = fs::perms::owner_all | fs::perms::group_read |
                                    fs::perms::group_exec | fs::perms::others_read |
                                    fs::perms::others_exec;
    fs::permissions(work_, as_folders_are);
    mark(work_);
  }
  // An earlier export is replaced whole; what others put beside it would be gone.
  void refuse_what_was_added(const std::string& place) const {
    for (const fs::directory_entry& entry : fs::directory_iterator(place_)) {
      if (const std::string added = entry.path().filename().string(); !is_of_a_site(added)) {
        throw MissingResource(fmt::format(
            "--export {}: {} there is not of an earlier export and would be lost; export to a new "
            "folder and copy it",
            printable(place), printable(added)));
      }
    }
  }

  ~Workshop() { remove_marked(work_); }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  void write(const std::string& name, std::string_view bytes) {
    const fs::path path = work_ / name;
    std::error_code fault;
    fs::create_directories(path.parent_path(), fault);
    constexpr mode_t as_files_are = 0644;
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, as_files_are);
    if (file < 0) {
      cannot("write", path, errno);
    }
    for (std::string_view rest = bytes; !rest.empty();) {
      const ssize_t wrote = ::write(file, rest.data(), rest.size());
      if (wrote < 0 && errno != EINTR) {
        const int why = errno;
        ::close(file);
        cannot("write", path, why);
      }
      rest.remove_prefix(wrote > 0 ? static_cast<std::size_t>(wrote) : 0);
    }
    if (::close(file) != 0) {
      cannot("write", path, errno);
    }
    const std::scoped_lock lock(mutex_);
    ++files_;
    bytes_ += bytes.size();
  }

  // The old site, if there was one, is in the workshop afterwards.
  void put_in_place() {
    if (::syncfs(folder_.descriptor()) != 0) {
      cannot("write", work_, errno);
    }
    const unsigned how = there_ ? RENAME_EXCHANGE : RENAME_NOREPLACE;
    if (::renameat2(AT_FDCWD, work_.c_str(), AT_FDCWD, place_.c_str(), how) != 0) {
      cannot("put the site at", place_, errno);
    }
    std::error_code ignored;
    fs::remove(place_ / unfinished, ignored);
    if (there_) {
      mark(work_);
    }
  }

  [[nodiscard]] std::uint64_t files() const { return files_; }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

 private:
  static void mark(const fs::path& folder) {
    constexpr mode_t as_files_are = 0644;
    const int file = ::open((folder / unfinished).c_str(),
                            O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, as_files_are);
    if (file >= 0) {
      ::close(file);
    }  // Then it stays if it is killed.
  }

  fs::path place_;
  fs::path work_;
  OpenFolder folder_;  // of it, locked
  bool there_ = false;
  std::mutex mutex_;
  std::uint64_t files_ = 0;
  std::uint64_t bytes_ = 0;
};

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
    const cli::PlannedTable table =
        cli::plan_table({.k = range_.k, .v = range_.v, .change = change});
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
    std::vector<PlannedCell> owned;
    for (const PlannedCell* const cell : cells) {
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
    std::erase_if(cells, [](const PlannedCell* cell) {
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

  std::string document_of(const PlannedCell& cell) {
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
  workshop.write(marker, fmt::format("changeover {}\n", version));
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
  workshop.put_in_place();
  return {.files = workshop.files(),
          .bytes = workshop.bytes(),
          .cells = site.cells(),
          .designs = site.designs()};
}

}  // namespace changeover::serve
