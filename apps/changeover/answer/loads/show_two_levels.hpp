// Load orders for two levels, as they are written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "changeover/io/output.hpp"
#include "changeover/loadorder/two_levels.hpp"

namespace changeover::cli {

/// The head, with bytes if it is known how many an item has, then the steps. @throws ImpossibleParameters if bytes exceed 64 bits
void show_two_levels(const TwoLevelOrder& order, const std::string& format,
                     std::optional<std::uint64_t> item_bytes, bool new_pairs, OutputFile& out);

}  // namespace changeover::cli
