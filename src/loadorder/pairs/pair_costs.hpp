// Internal: reads the costs of pairs from a list: two items and a number per row, with the
// separators of a list of pairs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "changeover/io/input.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"
#include "io/scan/row_reader.hpp"

namespace changeover {

/// @throws BadInput with its place for what is no number, below 0 or too large
[[nodiscard]] double cost_in(const RowReader& rows, const Field& field);

/// Items have the numbers 0, …, items − 1, or the names that the wanted pairs give them. Pairs that
/// are not in the list cost 1. A first row of words over rows of numbers is a header, which `notes`
/// then receive. @throws BadInput with its place for an unknown item, a cost below 0, or a pair
/// that has a cost already
[[nodiscard]] std::function<double(Element, Element)> read_pair_costs(
    Input& input, const WantedPairs& wanted, std::vector<std::string>* notes = nullptr);

}  // namespace changeover
