// A design that was chosen, built and verified, with all that it is shown with.
//
//     ChosenDesign chosen = built(offer);
//     write_design(*chosen.source, chosen.exhibit, "text", sink);
#pragma once

#include <cstdint>
#include <memory>

#include "answer/design/show_design.hpp"
#include "changeover/catalog/entry.hpp"

namespace changeover::cli {

struct ChosenDesign {
  Offer offer;
  std::shared_ptr<BlockSource> source;
  Exhibit exhibit;
  bool judged = true;  ///< if not: only JudgedWhileRead may hand its blocks on
};

/// Whether a design that takes long to read may be left unread, to be verified while it is written.
enum class Unread : std::uint8_t { never, may_be_left };

/// What was offered. @throws InternalError if it does not keep its promise.
[[nodiscard]] ChosenDesign built(const Offer& offer, Unread unread = Unread::never);

/// A design of the catalog, elements by their numbers, as the checksum has them. @throws BadInput
/// if its recipe makes other blocks than those that were published.
[[nodiscard]] ChosenDesign built(const CatalogEntry& entry);

/// Builds the entry's recipe once. @throws BadInput as built(entry).
void check_published_blocks(const CatalogEntry& entry);

}  // namespace changeover::cli
