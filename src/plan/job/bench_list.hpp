// Reads benches from a list.
//
//     bench,test cost,hours,start
//     North,2.5,8,"Xeon 6334, Disk A"
//     South,,16,
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/benches.hpp"
#include "plan/job/part_finder.hpp"

namespace changeover {

/// The columns of a list of benches, named as in documents: name, at_once, test_cost,
/// change_factor, slots, mounted, start, own, without, hours, down.
[[nodiscard]] const std::vector<std::string_view>& bench_columns();

/// Reads the benches in the order of their rows; an empty field takes the value of the job. The
/// first row names the columns, with blanks or underscores, in any case; `bench` stands for the
/// name. A list with one column may have names only. Several parts in a field are separated by
/// commas or semicolons; slots are written as CPU=1,disk=2..4. If `gone` is given, unknown parts
/// are left out and each name with its place is added to it once. Columns of other kinds are passed
/// over, with a line in `notes` if that is given. @throws BadInput with a place for malformed
/// fields, a misspelled column, more than max_benches; MissingResource if reading fails.
[[nodiscard]] std::vector<Bench> read_benches(Input& input, const PartNames& names,
                                              std::vector<std::string>* gone = nullptr,
                                              std::vector<std::string>* notes = nullptr);

/// As parse_amount(), of a "cost", a "factor", a "number of hours". @throws the same, but always
/// BadInput, in its own words, for what is no cost.
[[nodiscard]] Amount parse_measure(std::string_view text, std::string_view what);

/// The bench with this name, or with this number from 1; a name takes precedence. Nullopt if there
/// is none.
[[nodiscard]] std::optional<std::size_t> find_bench(const std::vector<Bench>& benches,
                                                    const std::string& word);

}  // namespace changeover
