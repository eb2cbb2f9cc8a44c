// A request for load orders as plain data: which pairs must be in memory together, with how much
// room, and by how many workers.
//
//     LoadRequest request{.items = 64, .room = 16, .workers = 4};
//     to_json(request);  // {"format":"changeover-load-request/1","items":64,"room":16,"workers":4}
//     const CheckedLoads asked = checked_loads(request, Door::document);
//     const WorkerSplit split = split_load_order(asked.items(), asked.room(), *request.workers);
//
// The document, format "changeover-load-request/1": the keys of load_table(). "pairs" is an array
// of rows [a, b] or [a, b, cost], {"file": its path}, or {"text": what a file would hold}; "groups"
// the same with rows [a, b, …] (loadorder/wanted_pairs.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/io/request.hpp"
#include "changeover/loadorder/schedule.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// The keys of a request; load_table() says what each one means.
struct LoadRequest {
  std::optional<std::uint64_t> items = {};
  std::optional<std::uint64_t> room = {};
  RequestList pairs = {};
  RequestList groups = {};
  std::optional<std::uint64_t> against = {};
  std::optional<std::uint64_t> done_items = {};
  std::optional<std::uint64_t> fast_room = {};
  std::optional<std::uint64_t> item_bytes = {};
  RequestList sizes = {};
  std::optional<std::uint64_t> memory = {};
  std::optional<std::uint64_t> fast_memory = {};
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
  RequestPlaces places = {};

  bool operator==(const LoadRequest&) const = default;
};

/// All options of load orders, in the order of the help text, and the rules between them.
[[nodiscard]] const RequestTable<LoadRequest>& load_table();

/// Writes one line of JSON that load_request() reads back as the same request.
[[nodiscard]] std::string to_json(const LoadRequest& request);

/// Reads a request document; `name` is the name of its file, or empty; `door` says how messages
/// spell its keys. Files that it names are not opened. The older name "bytes_per_item" of
/// "item_bytes", which the server accepts, is unknown here. @throws BadInput with one line, and a
/// place in the file if there is one, if the document is invalid.
[[nodiscard]] LoadRequest load_request(std::string json, std::string name = "",
                                       Door door = Door::document);

/// Returns a JSON Schema (draft 2020-12) of the document.
[[nodiscard]] std::string load_request_schema();

/// Checks ranges and combinations of keys, before any list is read. @throws BadOption, naming
/// options as the door does.
void check_options(const LoadRequest& request, Door door);

/// A request that was read and checked completely; only checked_loads() makes one.
class CheckedLoads {
 public:
  [[nodiscard]] const LoadRequest& request() const { return request_; }
  /// Where it came from.
  [[nodiscard]] Door door() const { return door_; }
  [[nodiscard]] const WantedPairs& wanted() const { return wanted_; }
  [[nodiscard]] std::uint64_t items() const { return wanted_.items(); }
  /// How many items fit in memory; if items have sizes, the most that fit at once.
  [[nodiscard]] std::uint64_t room() const { return room_; }
  /// Null if all items have the same size.
  [[nodiscard]] const std::shared_ptr<const ItemSizes>& sizes() const { return sizes_; }
  /// The cost of a pair; empty if all pairs cost the same.
  [[nodiscard]] const std::function<double(Element, Element)>& pair_cost() const { return cost_; }
  /// What was guessed of the lists: that a first row was read as names of columns, or as a pair
  /// though numbers follow, with its place.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  friend CheckedLoads checked_loads(LoadRequest request, Door door,
                                    std::shared_ptr<const PairGraph> pairs);
  CheckedLoads() = default;
  LoadRequest request_;
  Door door_ = Door::document;
  WantedPairs wanted_;
  std::uint64_t room_ = 0;
  std::shared_ptr<const ItemSizes> sizes_;
  std::function<double(Element, Element)> cost_;
  std::vector<std::string> notes_;
};

/// Reads the pairs of a request and checks all of it, for every door. `pairs`, if given, replace
/// those of the request. @throws BadOption, naming options as the door does, for wrong keys;
/// BadInput for wrong pairs; MissingResource for a file that cannot be read. O(pairs · log pairs).
[[nodiscard]] CheckedLoads checked_loads(LoadRequest request, Door door,
                                         std::shared_ptr<const PairGraph> pairs = nullptr);

/// Whether a request can be written in this format: that of Marius has one buffer, that of COLMAP
/// each pair once, and text and CSV pairs of names as a|b. @throws BadOption, naming options as the
/// door does, if it cannot; BadInput for more items than a list for COLMAP has, and for a name with
/// a '|'.
void check_format(const CheckedLoads& asked, std::string_view format);

}  // namespace changeover
