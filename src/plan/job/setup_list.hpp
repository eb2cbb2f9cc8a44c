// Lists of set-ups with the lines where they stand, and what is wrong with one.
#pragma once

#include <optional>
#include <string>

#include "changeover/plan/job.hpp"

namespace changeover {

/// The set-ups and their results. If `forgiving`, parts of a run sheet that are none any more are left out. @throws as
/// read_setups() and read_done().
[[nodiscard]] DoneList read_list(Input& input, const std::vector<std::string>& names,
                                 std::uint64_t at_once, bool forgiving);

/// Why no list may hold this set-up, whose parts are parts of the job, none twice: without a place. Nothing if one may.
[[nodiscard]] std::optional<std::string> setup_defect(const Job& job, const Block& setup);

/// Takes out the triples that some of these set-ups hold; needed are then the pairs of the others. Nothing without triples.
void drop_met_triples(Job& job, const std::vector<Block>& setups);

}  // namespace changeover
