// What changeover search was asked, and how its ways of searching answer. Each way is one file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/closure.hpp"
#include "changeover/core/design.hpp"
#include "request/request.hpp"
#include "request/run_request.hpp"

namespace changeover::cli {

struct SearchRequest {
  std::optional<std::uint64_t> v;
  std::optional<std::uint64_t> k;
  std::optional<std::uint64_t> change;
  std::optional<std::uint64_t> strength;
  std::optional<std::uint64_t> blocks;  ///< how many the design may have
  bool circular = false;
  bool linear = false;
  bool exact = false;
  bool base_blocks = false;
  bool tight = false;
  std::string proof_directory;
  std::string order_file;
  std::string extend_file;
  std::string repair_file;
  std::string checkpoint;
  std::optional<std::uint64_t> cycle_length;  ///< n
  std::optional<std::uint64_t> fixed_points;  ///< f
  RunRequest run;
  OutputRequest output;
  bool leaving = false;

  /// What is asked; linear unless it says circular, for a circular design is a linear one as well.
  /// @throws UsageError, ImpossibleParameters.
  [[nodiscard]] Parameters parameters(Kind kind_by_default = Kind::linear) const;

  /// The command line in one form, for provenance: "changeover 0.2.0: search 20 5 --linear --seed 1".
  [[nodiscard]] std::string provenance(const Parameters& p, const std::string& options) const;
};

/// A design that a search found, with what there is to say about it.
struct SearchFind {
  Design design;
  std::vector<std::string> lines;    ///< how it was found, shown below its title
  std::optional<Bound> proved = {};  ///< a lower bound that the lines prove
};

/// Shows a find in the format that was asked for, after verifying it again, block by block.
/// @throws InternalError if it is not valid.
void show_find(const SearchFind& find, const SearchRequest& request);

/// The checkpoint of one of the processes that search together: FILE, FILE.1, FILE.2, …
[[nodiscard]] std::string checkpoint_of(const SearchRequest& request, std::uint64_t process);

/// Shows that there is no design, or none yet. The JSON document goes where the answer was to go; words go to
/// standard output, for they do not replace a file of designs.
void show_none(const SearchRequest& request, const std::string& words, const std::string& json);
/// With a document that says found: false and the words as the explanation.
void show_none(const SearchRequest& request, const std::string& words);

/// A design as a message to another member of the team: all its elements, in order.
[[nodiscard]] std::string pack(const Design& design);
/// @throws InternalError if the message is none.
[[nodiscard]] Design unpack(const Parameters& p, std::string_view message);

int search_exactly(const SearchRequest& request);
int search_locally(const SearchRequest& request);
int search_base_blocks(const SearchRequest& request);
int search_repair(const SearchRequest& request);
int search_extend(const SearchRequest& request);
int search_order(const SearchRequest& request);

}  // namespace changeover::cli
