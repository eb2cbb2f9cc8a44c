// Searches that the server runs: started, watched, stopped, and what they find kept.
//
//     SearchJobs jobs(catalog, events, {.at_once = 2});
//     const std::uint64_t id = jobs.start({.parameters = p, .seconds = 60});
//     jobs.list_json();                          // state, best so far, …
//     jobs.stop(id);
//     jobs.keep(id).label;                       // into the user's catalog
//
// A search is `changeover search` with the same way, limits and seed, and its result is verified.
// Each has a thread that gives way to those that answer. The last 50 searches that ended are
// remembered.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "changeover/catalog/catalog.hpp"
#include "changeover/core/design.hpp"
#include "changeover/search/local_search.hpp"
#include "serve/http/events.hpp"
#include "serve/jobs/job_list.hpp"

namespace changeover::serve {

/// How a search goes about it, as the options of changeover search have it.
enum class SearchWay : std::uint8_t {
  local,  ///< fewer blocks, by annealing from the best that is known
  exact,  ///< the minimum, number of blocks by number of blocks, each excluded with a checked proof
  base_blocks,  ///< designs with an automorphism
  locked        ///< designs with elements or subsets in their place: `wanted`
};

[[nodiscard]] std::string_view to_string(SearchWay way);

struct SearchOrder {
  Parameters parameters;
  SearchWay way = SearchWay::local;
  Wanted wanted = {};                        ///< of a locked search, or of an exact one
  bool anew = false;                         ///< these begin with no known design
  std::optional<std::uint64_t> blocks = {};  ///< so many are enough
  double seconds = 60;
  unsigned threads = 1;
  std::uint64_t seed = 1;
};

/// What became of a design that was to be kept.
struct Kept {
  std::string label;
  bool already = false;  ///< it was there, or the same by other names of elements
};

/// A design into the user's catalog, verified and credited with today. @throws Refusal 422 if it is
/// no change covering design; MissingResource if the catalog cannot be written, or is damaged.
[[nodiscard]] Kept keep_in_catalog(Catalog& catalog, const Design& design);

class SearchJobs {
 public:
  struct Settings {
    unsigned at_once = 2;
    std::uint64_t memory_bytes = 0;  ///< of each
  };

  SearchJobs(Catalog& catalog, EventHub& events, const Settings& settings);
  /// Stops all and waits for them.
  ~SearchJobs();
  SearchJobs(const SearchJobs&) = delete;
  SearchJobs& operator=(const SearchJobs&) = delete;

  /// Begins a search and returns its number. @throws Refusal 429 if as many run as may, 400 if no
  /// such design exists.
  std::uint64_t start(const SearchOrder& order);

  /// Asks a search to stop; it keeps what it has. @throws Refusal 404, as all below.
  void stop(std::uint64_t id);

  /// Asks all to stop and waits so long; whether all have.
  bool stop_all(std::chrono::duration<double> patience);

  /// The best design of a search that has ended. @throws Refusal 404 also if it has none yet.
  [[nodiscard]] std::shared_ptr<const Design> design_of(std::uint64_t id) const;

  /// Puts that into the user's catalog. @throws as keep_in_catalog()
  [[nodiscard]] Kept keep(std::uint64_t id);

  /// An array of all, latest first; one with its points.
  [[nodiscard]] std::string list_json() const;
  [[nodiscard]] std::string one_json(std::uint64_t id) const;

 private:
  struct Job;
  struct Found;
  void run(Job& job);
  void search(Job& job);
  static Found search_locally(const Job& job);
  Found search_exactly(Job& job);
  static Found search_for_base_blocks(const Job& job);
  static Found search_with_locked_cells(const Job& job);
  static void finish(Job& job, Found found);
  void publish(const Job& job);

  Catalog& catalog_;
  EventHub& events_;
  Settings settings_;
  std::unique_ptr<JobList<Job>> jobs_;
};

}  // namespace changeover::serve
