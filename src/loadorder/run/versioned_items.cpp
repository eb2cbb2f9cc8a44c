#include "loadorder/run/versioned_items.hpp"

#include <utility>

namespace changeover {
namespace {

Checksum checksum_of(std::span<const std::byte> bytes) {
  Sha256 hash;
  hash.add(bytes.data(), bytes.size());
  return hash.finish();
}

}  // namespace

VersionedItems::VersionedItems(const std::string& data, const std::string& beside,
                               std::uint64_t items, std::uint64_t item_bytes,
                               const ResultsClaim& claim, std::function<void()> before_write)
    : item_bytes_(item_bytes),
      claim_(claim),
      data_(data),
      beside_(beside),
      before_write_(before_write ? std::move(before_write) : [] {}),
      committed_(static_cast<std::size_t>(items), 0),
      newest_(committed_),
      checksums_(committed_.size()) {
  data_.open(items * item_bytes, claim);
}

void VersionedItems::begin() { beside_.open(committed_.size() * item_bytes_, claim_); }

void VersionedItems::replay(const std::vector<Element>& stored) {
  for (const Element x : stored) {
    newest_[x] = 1 - committed_[x];
  }
  commit();
}

void VersionedItems::read_all() {
  std::vector<std::byte> bytes(static_cast<std::size_t>(item_bytes_));
  for (Element x = 0; x < committed_.size(); ++x) {
    read(x, bytes);
    checksums_[x] = checksum_of(bytes);
  }
}

void VersionedItems::read(Element x, std::span<std::byte> bytes) const {
  (newest_[x] == 0 ? data_ : beside_).read(bytes.data(), bytes.size(), offset_of(x));
}

void VersionedItems::store(Element x, std::span<const std::byte> bytes) {
  before_write_();
  newest_[x] = 1 - committed_[x];
  (newest_[x] == 0 ? data_ : beside_).write(bytes.data(), bytes.size(), offset_of(x));
  checksums_[x] = checksum_of(bytes);
}

Checksum VersionedItems::checksum() const {
  Sha256 hash;
  for (const Checksum& each : checksums_) {
    hash.add(each);
  }
  return hash.finish();
}

void VersionedItems::sync() const {
  data_.sync();
  beside_.sync();
}

void VersionedItems::commit() { committed_ = newest_; }

void VersionedItems::copy_back() {
  std::vector<std::byte> bytes(static_cast<std::size_t>(item_bytes_));
  for (Element x = 0; x < committed_.size(); ++x) {
    if (committed_[x] == 1) {
      read(x, bytes);
      before_write_();
      data_.write(bytes.data(), bytes.size(), offset_of(x));
    }
  }
  data_.sync();
}

}  // namespace changeover
