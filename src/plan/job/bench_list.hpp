// Benches from a list.
//
//     bench,test cost,hours,start
//     North,2.5,8,"Xeon 6334, Disk A"
//     South,,16,
#pragma once

#include <string>
#include <vector>

#include "changeover/plan/benches.hpp"

namespace changeover {

/// The columns of a list of benches, as documents call them: name, at_once, test_cost,
/// change_factor, slots, mounted, start, own, without, hours, down.
[[nodiscard]] const std::vector<std::string_view>& bench_columns();

/// The benches in the order of their rows; what a field says nothing of, a bench has from the job.
/// The first row names the columns, with blanks or underscores in any case, `bench` for the name; a
/// list of one column may have names alone. Fields of several parts have commas between them, slots
/// are written as CPU=1,disk=2..4. Names that are none of the parts are left out and added to
/// `gone`, each once, if that is given. @throws BadInput with a place for what cannot be read, an
/// unknown column, more than max_benches; MissingResource if reading fails.
[[nodiscard]] std::vector<Bench> read_benches(Input& input, const std::vector<std::string>& names,
                                              std::vector<std::string>* gone = nullptr);

/// The bench of this name, or of this number from 1; a name wins. Nothing if there is none.
[[nodiscard]] std::optional<std::size_t> find_bench(const std::vector<Bench>& benches,
                                                    const std::string& word);

}  // namespace changeover
