// A load order, a step a line: what --json, --format csv and --format text say of a step.
//
//     StepWriter writer(out, "jsonl", names);
//     writer.begin(json, text, "step,load,evict");
//     writer.write(step);
//     writer.end();
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/io/output.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/prefetch.hpp"
#include "changeover/loadorder/two_levels.hpp"

namespace changeover::cli {

/// Writes an order in a format: a head, then a line for each step. In text an empty list is not mentioned.
class StepWriter {
 public:
  /// Items are called by `names` unless there are none.
  StepWriter(OutputFile& out, const std::string& format, const std::vector<std::string>* names)
      : out_(out),
        json_(format == "jsonl"),
        csv_(format == "csv"),
        names_(names != nullptr && !names->empty() ? names : nullptr) {}

  /// The head in JSON or in text; in CSV the names of the columns.
  void begin(const std::string& json, const std::string& text, const std::string& columns);

  /// `worker` is nothing if there is only one, `work` if it is not to be said what is computed, `store` what is stored.
  void write(const LoadStep& step, std::optional<std::uint64_t> worker = {},
             const std::vector<ItemPair>* work = nullptr,
             const std::vector<Element>* store = nullptr);

  void write(const PrefetchStep& step);
  void write(const TwoLevelStep& step, bool with_pairs);

  void end();

 private:
  void add(Element item);
  void add(const ItemPair& pair);
  void start(std::uint64_t number, std::optional<std::uint64_t> worker);
  template <typename Member>
  void list(std::string name, const std::vector<Member>& members);
  void finish();

  OutputFile& out_;
  bool json_;
  bool csv_;
  const std::vector<std::string>* names_;
  std::string text_;
};

}  // namespace changeover::cli
