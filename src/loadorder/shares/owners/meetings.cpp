#include "loadorder/shares/owners/meetings.hpp"

namespace changeover {

std::shared_ptr<const GroupOwners> owners_of(const GroupShares& shares, std::uint64_t items,
                                             double part) {
  auto owners =
      std::make_shared<GroupOwners>(ItemGroups{items, shares.groups}, shares.workers.size());
  for (std::uint64_t w = 0; w < shares.workers.size(); ++w) {
    const GroupShare& share = shares.workers[static_cast<std::size_t>(w)];
    for (std::size_t i = 0; i < share.held.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        owners->add(w, share.held[i], share.held[j], 0);
      }
      for (const Element streamed : share.streamed) {
        owners->add(w, share.held[i], streamed, 0);
      }
    }
  }
  owners->balance(part);
  return owners;
}

}  // namespace changeover
