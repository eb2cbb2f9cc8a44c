#include "construct/trusted_entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <set>
#include <span>

#include "changeover/catalog/entry.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"
#include "core/words.hpp"

namespace changeover {

namespace {

// Blocks on their way to the digest, judged by the parameters of the entry; no more than one over
// the number that it names.
class Judged final : public BlockSource {
 public:
  Judged(BlockSource& blocks, const CatalogEntry& entry)
      : blocks_(&blocks), entry_(&entry), verdict_(entry.parameters) {}

  [[nodiscard]] const Parameters& parameters() const override { return entry_->parameters; }
  [[nodiscard]] Verdict verdict() { return verdict_.finish(); }

  std::span<const Element> read(std::span<Element> room) override {
    stop_if_asked();
    if (count_ > entry_->b) {
      return {};
    }
    const std::span<const Element> read_here = blocks_->read(room);
    verdict_.add(read_here);
    count_ += read_here.size() / entry_->parameters.k;
    return read_here;
  }

 private:
  BlockSource* blocks_;
  const CatalogEntry* entry_;
  RunningVerdict verdict_;
  std::uint64_t count_ = 0;
};

}  // namespace

std::string entry_defect(const CatalogEntry& entry) {
  try {
    const auto blocks = Registry::standard().build(entry.recipe);
    Judged judged(*blocks, entry);
    const DesignDigest digest = design_digest(judged);
    if (digest.b != entry.b) {
      return fmt::format("its recipe makes {}{} and not {}; correct the entry",
                         digest.b > entry.b ? "more than " : "",
                         count_of(std::min(digest.b, entry.b), "block"), entry.b);
    }
    if (digest.checksum != entry.checksum) {
      return "its blocks do not have the checksum of the entry; correct the entry";
    }
    return judged.verdict().valid() ? ""
                                    : "its blocks are not a design with these parameters; "
                                      "correct the entry";
  } catch (const InternalError&) {
    throw;
  } catch (const Error& fault) {
    return fault.what();
  }
}

std::optional<CatalogEntry> trusted_entry(const Catalog& catalog, const std::string& label) {
  static std::mutex mutex;
  static std::set<std::string> good;
  std::optional<CatalogEntry> entry = catalog.find(label);
  if (!entry || !entry->retracted.empty()) {
    return std::nullopt;
  }
  if (catalog.is_shipped(label)) {
    return entry;
  }
  {
    const std::lock_guard lock(mutex);
    if (good.contains(label)) {
      return entry;
    }
  }
  // Not under the lock: building may ask for other entries.
  const std::string defect = entry_defect(*entry);
  if (!defect.empty()) {
    catalog.distrust(label, defect);
    return std::nullopt;
  }
  const std::lock_guard lock(mutex);
  good.insert(label);
  return entry;
}

Design read_within_memory(BlockSource& source) {
  constexpr std::uint64_t elements_between = 1U << 18;
  Design design(source.parameters());
  const std::uint64_t between =
      elements_between / std::max<std::uint64_t>(source.parameters().k, 1) + 1;
  for_each_block(source, [&](std::span<const Element> block) {
    if (design.block_count() % between == 0) {
      stop_if_asked();
      // A vector that grows is there twice for a moment.
      require_memory(3 * sizeof(Element) * block.size() * design.block_count(),
                     "the " + name(source.parameters()));
    }
    design.append(block);
  });
  return design;
}

}  // namespace changeover
