// The tabs of a workbook with a sheet for each bench say whose tests a sheet has.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/io/input.hpp"
#include "changeover/plan/benches.hpp"
#include "changeover/plan/job.hpp"

namespace changeover {

/// The bench whose sheet has such a tab, in whatever case; nothing if there is none.
[[nodiscard]] std::optional<std::size_t> bench_of_tab(const std::vector<Bench>& benches,
                                                      const std::string& tab);

/// Gives the tests of a sheet that name no bench the one that its tab says, if none of its tests
/// is of another; a note says so. A bench named in another case is that bench. The inputs are those
/// of the lists. @throws BadInput with the sheet for a run sheet with results none of which has a
/// bench, if its tab says none
void take_benches_of_tabs(const std::vector<std::unique_ptr<Input>>& inputs,
                          const std::vector<Bench>& benches, std::vector<DoneList>& lists,
                          std::vector<std::string>& notes);

}  // namespace changeover
