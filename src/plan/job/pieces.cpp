// Several equal pieces of a part in one set-up.
#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "core/printable.hpp"
#include "plan/job/pair_numbers.hpp"

namespace changeover {
namespace {

// The same pairs, for more parts.
PairSet of_more_parts(const PairSet& pairs, std::uint64_t parts) {
  PairSet more(parts);
  pairs.for_each(all_of_them, [&](Element x, Element y) { more.insert(x, y); });
  return more;
}

void add_names(Job& job, const std::vector<std::uint64_t>& quantities) {
  const std::size_t listed = job.names.size();
  for (Element x = 0; x < listed; ++x) {
    const std::uint32_t slot = job.slots.empty() ? no_slot : job.slot_of[x];
    const std::uint64_t least = slot == no_slot ? 0 : job.slots[slot].least;
    for (std::uint64_t n = 2; n <= std::min(least, quantities[x]); ++n) {
      std::string name = fmt::format("{} #{}", job.names[x], n);
      if (std::ranges::find(job.names, name) != job.names.end()) {
        throw BadInput(fmt::format("{} is a part, and the name of piece {} of {}; rename it",
                                   shown(name), n, shown(job.names[x])));
      }
      if (job.names.size() == max_parts) {
        throw BadInput(
            fmt::format("more than {} parts with the pieces of each that slots may "
                        "need; plan for fewer at a time",
                        max_parts));
      }
      job.names.push_back(std::move(name));
      job.change_costs.push_back(job.change_costs[x]);
      job.slot_of.push_back(slot);
      job.piece_of.push_back(x);
    }
  }
}

// Distributes the quantity of a part over the pieces that a set-up can have.
void share_quantities(Job& job, const std::vector<std::uint64_t>& quantities) {
  std::vector<std::uint64_t> pieces(quantities.size(), 0);
  for (const Element part : job.piece_of) {
    ++pieces[part];
  }
  std::vector<std::uint64_t> given(quantities.size(), 0);
  for (const Element part : job.piece_of) {
    const std::uint64_t all = quantities[part];
    job.quantities.push_back(
        all == enough_for_all ? all
                              : all / pieces[part] + (given[part] < all % pieces[part] ? 1U : 0U));
    ++given[part];
  }
}

}  // namespace

std::uint64_t add_pieces(Job& job, const std::vector<std::uint64_t>& quantities) {
  const std::size_t listed = job.names.size();
  if (quantities.size() != listed) {
    throw BadInput("the quantities do not fit the number of parts; give one each");
  }
  Job more = job;
  more.piece_of.clear();
  more.quantities.clear();
  for (Element x = 0; x < listed; ++x) {
    more.piece_of.push_back(x);
  }
  add_names(more, quantities);
  share_quantities(more, quantities);
  const std::uint64_t added = more.names.size() - listed;
  if (added == 0) {
    more.piece_of.clear();
  }
  more.needed = of_more_parts(job.needed, more.parts());
  more.never = PairSet(more.parts());
  const auto part_of = [&](Element x) { return more.piece_of.empty() ? x : more.piece_of[x]; };
  for (Element x = 0; x < more.parts(); ++x) {
    for (Element y = 0; y < x; ++y) {
      if (part_of(x) != part_of(y) && job.never.contains(part_of(x), part_of(y))) {
        more.never.insert(x, y);
        more.why_never.set(x, y, job.why_never(part_of(x), part_of(y)));
      }
    }
  }
  if (job.replaces()) {
    more.replace_costs.clear();
    for (Element out = 0; out < more.parts(); ++out) {
      for (Element in = 0; in < more.parts(); ++in) {
        const bool alike = part_of(out) == part_of(in);
        more.replace_costs.push_back(out == in ? Amount{}
                                     : alike   ? more.change_costs[in]
                                               : job.replace_cost(part_of(out), part_of(in)));
      }
    }
  }
  job = std::move(more);
  return added;
}

}  // namespace changeover
