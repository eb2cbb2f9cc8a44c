// Several sheets of one workbook with tests that were done: what they say of the same test.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "changeover/io/input.hpp"
#include "changeover/plan/job.hpp"

namespace changeover {

/// Whether a list is a sheet of earlier tests, by its name or heads: they may have numbers of their
/// own.
[[nodiscard]] bool is_of_earlier_tests(Input& input);

/// Makes each test count once that is on two of these lists, those of the inputs, with the same
/// bench, step and set-up; notes say so, and which steps of the sheet `Done` are other tests. Of
/// tests without a step, alike in all else, all count; a note says which.
/// O(rows · log rows). @throws BadInput, with both places, if their results differ or two run
/// sheets have one step with different parts; for a list that has no part of the job
void make_agree(const std::vector<std::unique_ptr<Input>>& inputs, std::vector<DoneList>& lists,
                std::vector<std::string>& notes);

/// A note where no list has some steps of one bench that follow this one, but later steps: their
/// rows were deleted, and what they had done is planned again. O(rows · log rows)
void note_lost_steps(const std::string& book, std::uint64_t last_step,
                     const std::vector<DoneList>& lists, std::vector<std::string>& notes);

}  // namespace changeover
