// The inside of a Catalog: the program's shelf, the user's shelf, and what is known about them.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "catalog/store/database.hpp"
#include "catalog/store/shelf.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/core/error.hpp"

namespace changeover {

class Catalog::Store {
 public:
  explicit Store(Files files) : user_path(std::move(files.user)) {
    if (!files.shipped.empty()) {
      shipped.emplace(Database::of_image(files.shipped));
    }
  }

  // The user's file, if it is there and can be read.
  Shelf* users() {
    if (!user && !user_path.empty() && problem.empty() && time_to_look()) {
      try {
        if (is_file(user_path)) {
          open_user();
        }
      } catch (const Error& fault) {
        problem = fault.what();
      }
    }
    return user && problem.empty() ? &*user : nullptr;
  }

  // Reads from the user's file; if it is damaged, goes on as if it were not there.
  template <typename Result, typename Read>
  Result from_users(Result otherwise, Read&& read) {
    if (Shelf* const shelf = users()) {
      try {
        return read(*shelf);
      } catch (const InternalError&) {
        throw;
      } catch (const Error& fault) {
        if (writing) {
          throw;
        }
        problem = fault.what();  // It stays open: a caller further up may be reading from it.
      }
    }
    return otherwise;
  }

  // Why an entry is retracted, in either database; empty if it is not.
  std::string retraction(std::string_view label) {
    if (const auto place = distrusted.find(label); place != distrusted.end()) {
      return place->second;
    }
    if (shipped) {
      if (auto why = shipped->retraction(label)) {
        return *why;
      }
    }
    return from_users(std::string(),
                      [&](Shelf& shelf) { return shelf.retraction(label).value_or(""); });
  }

  CatalogEntry read(Shelf& shelf, const Statement& row) {
    CatalogEntry entry = shelf.read(row);
    entry.retracted = retraction(entry.label());
    return entry;
  }

  // As Catalog::best().
  std::optional<CatalogEntry> best(const Parameters& p) {
    // A damaged entry shuts the user's file; the next try is without it.
    for (int tries = 0; tries < 3; ++tries) {
      const auto known = fewest(p, false);
      auto entry = known ? exact(known->label) : std::nullopt;
      if (!known || (entry && entry->retracted.empty())) {
        return entry;
      }
    }
    return std::nullopt;
  }

  // As Catalog::fewest(). O(n) for n designs of the cell with as few blocks.
  std::optional<Known> fewest(const Parameters& p, bool carries_blocks) {
    const auto look = [&](Shelf& shelf) -> std::optional<Known> {
      std::optional<Known> best;
      Statement& rows = shelf.counts(p);
      const ResetLater later(rows);
      while (rows.step()) {
        if (best && rows.integer(1) != best->b) {
          break;
        }
        const bool carries = rows.integer(2) != 0;
        if ((best && carries) || (carries_blocks && !carries) ||
            !retraction(rows.view(0)).empty()) {
          continue;
        }
        const auto label = parse_design_label(rows.view(0));
        if (!label || label->parameters != p || label->b != rows.integer(1)) {
          throw BadInput(fmt::format("{}: the entry {} is damaged; restore a copy",
                                     shelf.database().name(), rows.view(0)));
        }
        best = Known{rows.text(0), label->b};
        if (carries == carries_blocks) {
          break;  // No other entry precedes it.
        }
      }
      return best;
    };
    std::optional<Known> best = shipped ? look(*shipped) : std::nullopt;
    auto own = from_users(std::optional<Known>(), look);
    return own && (!best || own->b < best->b) ? own : best;
  }

  std::optional<CatalogEntry> exact(std::string_view label) {
    const auto read_it = [&](Shelf& shelf) {
      Statement& row = shelf.entry(label);
      const ResetLater later(row);
      return row.step() ? std::optional(read(shelf, row)) : std::nullopt;
    };
    if (shipped) {
      if (auto entry = read_it(*shipped)) {
        return entry;
      }
    }
    return from_users(std::optional<CatalogEntry>(), read_it);
  }

  // The label that an alias leads to; empty if there is no such alias. An alias that reads as a
  // label, which an older program allowed, is not used.
  std::string behind_alias(std::string_view text) {
    const auto look = [&](Shelf& shelf) { return shelf.alias(text).value_or(""); };
    std::string label = shipped ? look(*shipped) : "";
    label = label.empty() ? from_users(std::string(), look) : label;
    if (label.empty() || !reads_as_label(text)) {
      return label;
    }
    remark = fmt::format(
        "{}: the alias {} is not used, because it reads as a label; remove it with changeover "
        "catalog alias --remove {}",
        user_path, text, text);
    return "";
  }

  // The user's file, checked and open for writing; made if it is not there.
  Shelf& to_write();

  // The same within one task, for which it was checked before. @throws MissingResource if another
  // file has its name by now.
  Shelf& still_to_write();

  // Adds entries in one transaction. The best of their cells before is looked up once and kept in
  // `fewest_of`.
  std::vector<Added> put(Shelf& own, std::span<const CatalogEntry> entries,
                         std::map<Parameters, std::uint64_t>& fewest_of);

  std::optional<Shelf> shipped;
  std::optional<Shelf> user;
  std::string user_path;
  std::string problem;
  std::string remark;
  bool writing = false;  // A failure to read then is reported as one of writing.
  std::map<std::string, std::string, std::less<>> distrusted;  // label, why
  std::mutex mutex;

 private:
  void open_user();

  // Whether a missing file may exist by now. A check takes eight system calls, and a table asks
  // thousands of times.
  bool time_to_look() {
    constexpr auto pause = std::chrono::milliseconds(10);
    const auto now = std::chrono::steady_clock::now();
    if (looked_ && now - *looked_ < pause) {
      return false;
    }
    looked_ = now;
    return true;
  }

  std::optional<std::chrono::steady_clock::time_point> looked_;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> checked_;  // device and number of the file
};

}  // namespace changeover
