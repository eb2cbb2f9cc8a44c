// The question of a systems programmer as plain data: which pairs are to be in memory together, in
// how much room, by how many workers.
//
//     LoadRequest request{.items = 64, .room = 16, .workers = 4};
//     to_json(request);  // {"format":"changeover-load-request/1","items":64,"room":16,"workers":4}
//     const CheckedLoads asked = checked_loads(request, Door::document);
//     const WorkerSplit split = split_load_order(asked.items(), asked.room(), *request.workers);
//
// The document, format "changeover-load-request/1": the keys of load_table(). "pairs" is an array
// of rows [a, b], {"file": its path}, or {"text": what a file would hold}
// (loadorder/wanted_pairs.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "changeover/io/request.hpp"
#include "changeover/loadorder/schedule.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// What can be asked of load orders; what each key means is said by load_table().
struct LoadRequest {
  std::optional<std::uint64_t> items = {};
  std::optional<std::uint64_t> room = {};
  RequestList pairs = {};
  std::optional<std::uint64_t> against = {};
  std::optional<std::uint64_t> done_items = {};
  std::optional<std::uint64_t> fast_room = {};
  std::optional<std::uint64_t> item_bytes = {};
  RequestList sizes = {};
  std::optional<std::uint64_t> memory = {};
  std::optional<std::uint64_t> workers = {};
  std::optional<std::uint64_t> worker = {};
  std::optional<std::uint64_t> from_step = {};
  bool balance = false;
  bool first_holder = false;
  RequestList pair_cost = {};
  std::optional<std::uint64_t> epochs = {};
  bool verify_beside = false;
  bool disjoint = false;
  bool write_back = false;
  bool prefetch = false;
  bool new_pairs = false;
  bool ordered = false;
  bool self = false;
  bool shuffle = false;
  bool spread = false;
  std::optional<double> seconds = {};
  std::optional<std::uint64_t> threads = {};
  std::optional<std::uint64_t> seed = {};

  bool operator==(const LoadRequest&) const = default;
};

/// All options of load orders, in the order of the help, and the rules between them.
[[nodiscard]] const RequestTable<LoadRequest>& load_table();

/// One line of JSON that load_request() reads back as the same request.
[[nodiscard]] std::string to_json(const LoadRequest& request);

/// A request from its document; `name` is that of the file it is from, or empty. No file that it
/// names is opened. The server's older key "bytes_per_item" is not one of it. @throws BadInput with
/// one line, with a place if there is a file, for what is no such document.
[[nodiscard]] LoadRequest load_request(std::string json, std::string name = "");

/// A JSON Schema (draft 2020-12) of the document.
[[nodiscard]] std::string load_request_schema();

/// What two keys cannot mean together, and what is out of range, before any list is read. @throws
/// BadOption in the words of the door.
void check_options(const LoadRequest& request, Door door);

/// A request of which everything was read and found possible: only checked_loads() makes one.
class CheckedLoads {
 public:
  [[nodiscard]] const WantedPairs& wanted() const { return wanted_; }
  [[nodiscard]] std::uint64_t items() const { return wanted_.items(); }
  /// Of items with sizes the most that fit.
  [[nodiscard]] std::uint64_t room() const { return room_; }
  /// Null if all items have the same size.
  [[nodiscard]] const std::shared_ptr<const ItemSizes>& sizes() const { return sizes_; }
  /// What a pair costs; empty if all cost the same.
  [[nodiscard]] const std::function<double(Element, Element)>& pair_cost() const { return cost_; }

 private:
  friend CheckedLoads checked_loads(const LoadRequest& request, Door door,
                                    std::shared_ptr<const PairGraph> pairs);
  CheckedLoads() = default;
  WantedPairs wanted_;
  std::uint64_t room_ = 0;
  std::shared_ptr<const ItemSizes> sizes_;
  std::function<double(Element, Element)> cost_;
};

/// Reads the pairs of a request and checks all of it, for every door. `pairs` are those of a caller
/// who has them in memory already, in place of the request's. @throws BadOption, in the words of
/// the door, for keys that are wrong; BadInput for pairs that are; MissingResource for a file that
/// cannot be read. O(pairs · log pairs).
[[nodiscard]] CheckedLoads checked_loads(const LoadRequest& request, Door door,
                                         std::shared_ptr<const PairGraph> pairs = nullptr);

}  // namespace changeover
