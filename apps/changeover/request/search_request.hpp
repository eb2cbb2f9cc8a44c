// What changeover search was asked: one request a way of searching, each a file of verbs/, that
// holds only what this way knows; and how all of them answer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "answer/answer.hpp"
#include "answer/design/judgement.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/core/design.hpp"
#include "changeover/io/input.hpp"
#include "changeover/search/base_block_search.hpp"
#include "changeover/search/local_search.hpp"
#include "request/run_request.hpp"

namespace changeover::cli {

/// What every way of searching is told.
struct SearchRequest {
  RunRequest run;
  OutputRequest output;
  bool leaving = false;                 ///< mark leaving elements too
  std::optional<std::uint64_t> blocks;  ///< how many the design may have
};

struct LocalSearch : SearchRequest {
  Parameters parameters;
  std::string checkpoint;  ///< or empty
};

/// What a design must have besides.
struct WantedRequest {
  Wanted wanted;              ///< but for the blocks of the file
  std::string contains_file;  ///< or empty
  ReadOptions reading;        ///< of that
  bool anew = false;          ///< no known design to begin with

  /// All of it. @throws as read_design().
  [[nodiscard]] Wanted read(const Parameters& p) const;
};

struct ExactSearch : SearchRequest, WantedRequest {
  Parameters parameters;
  std::string proof_directory;  ///< or empty
};

struct BaseBlockSearch : SearchRequest {
  Parameters parameters;
  BaseBlockOptions options;
};

/// The blocks of a file in another order, with `reading.change` changes per step or with the fewest
/// in all.
struct OrderSearch : SearchRequest {
  std::string file;
  Kind kind = Kind::linear;
  std::optional<std::uint64_t> change;
};

/// A design that begins with the blocks of a file.
struct ExtendSearch : SearchRequest {
  std::string file;
  ReadOptions reading;
};

/// A design of the blocks of a file.
struct RepairSearch : SearchRequest {
  std::string file;
  ReadOptions reading;
};

/// A design that has what constructions need.
struct LockedSearch : SearchRequest, WantedRequest {
  Parameters parameters;
};

/// A design that a search found, with what there is to say about it.
struct SearchFind {
  Design design;
  std::vector<std::string> lines;  ///< how it was found, shown below its title
  std::optional<Bound> proved =
      {};  ///< the lower bound that the lines prove, if that is what they are for
  std::vector<std::uint64_t> positions = {};  ///< of unchanged subsets to mark
};

/// What is known of a find: verified again, block by block. A bound that is no better than what the
/// lines prove gives way to that; one that rests on the built-in table of checked proofs says so.
/// @throws InternalError if it is not valid.
[[nodiscard]] Judgement judge(const SearchFind& find);

/// Shows a find in the format that was asked for, judged.
[[nodiscard]] Answer show_find(const SearchFind& find, const SearchRequest& request, int code);

/// The answer that there is none with the blocks that were asked for, or none at all, and why.
/// `what` is asked for besides, with a space before it.
[[nodiscard]] Answer none_for(const SearchRequest& request, const Parameters& p,
                              const std::string& reason, const std::string& what = {});

/// That there is none with the blocks that were asked for, or none at all, if that is known; else
/// `bound` is set to the lower bound, or to nothing if the search was stopped before that.
[[nodiscard]] std::optional<Answer> proved_none(const SearchRequest& request, const Parameters& p,
                                                RunControl& control, std::optional<Bound>& bound);

/// The options that say what is wanted: "--first 0,1 --expansion-set".
[[nodiscard]] std::string way_of(const Wanted& wanted, bool anew);

/// What is said of a design that has what is wanted: whether it was known, and where its unchanged
/// subsets are.
[[nodiscard]] std::vector<std::string> lines_as_wanted(const Wanted& wanted, bool known,
                                                       const std::vector<UnchangedSubset>& subsets);

/// The positions, to mark them.
[[nodiscard]] std::vector<std::uint64_t> positions_of(const std::vector<UnchangedSubset>& subsets);

/// The command line in one form, for provenance: "changeover 0.2.0: search 20 5 --linear --seed 1".
/// `way` are its own options.
[[nodiscard]] std::string provenance(const SearchRequest& request, const Parameters& p,
                                     const std::string& way);

/// Writes provenance to the recipe of a design from base blocks, where it names these.
void credit(Recipe& developed, const std::string& words);

/// The checkpoint of one of the processes that search together: FILE, FILE.1, FILE.2, …
[[nodiscard]] std::string checkpoint_of(const LocalSearch& request, std::uint64_t process);

/// A design as a message to another member of the team: all its elements, in order.
[[nodiscard]] std::string pack(const Design& design);
/// @throws InternalError if the message is none.
[[nodiscard]] Design unpack(const Parameters& p, std::string_view message);

[[nodiscard]] Answer search(const LocalSearch& request);
[[nodiscard]] Answer search(const ExactSearch& request);
[[nodiscard]] Answer search(const BaseBlockSearch& request);
[[nodiscard]] Answer search(const OrderSearch& request);
[[nodiscard]] Answer search(const ExtendSearch& request);
[[nodiscard]] Answer search(const RepairSearch& request);
[[nodiscard]] Answer search(const LockedSearch& request);

}  // namespace changeover::cli
