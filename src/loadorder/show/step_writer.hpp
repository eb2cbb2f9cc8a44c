// A schedule, one step per line: what --json, --format csv and --format text say of a step.
//
//     StepWriter writer(out, "jsonl", names, {Column::step, Column::load, Column::evict});
//     writer.begin(json, text);
//     writer.write(step);
//     writer.end();
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "changeover/io/output.hpp"
#include "changeover/loadorder/schedule.hpp"

namespace changeover {

/// What is said of a step, under this name.
enum class Column : std::uint8_t {
  worker,
  epoch,
  step,
  load,
  evict,
  store,
  new_pairs,  ///< what is computed,
  before,     ///< or, if loads overlap it, what is computed first,
  compute,    ///< and what then
  evict_first,
  evict_late,
  fast_evict,
  fast_load
};

/// Writes a schedule in a format: a head, then a line for each step. In text an empty list is not
/// mentioned.
class StepWriter {
 public:
  /// Items are called by `names` unless there are none.
  StepWriter(Sink& out, const std::string& format, const std::vector<std::string>* names,
             std::vector<Column> columns)
      : out_(out),
        json_(format == "jsonl"),
        csv_(format == "csv"),
        names_(names != nullptr && !names->empty() ? names : nullptr),
        columns_(std::move(columns)) {}

  /// The head in JSON or in text; in CSV the names of the columns.
  void begin(const std::string& json, const std::string& text);

  void write(const Step& step);

  void end();

 private:
  void add(Element item);
  void add(const ItemPair& pair);
  void number(Column column, std::uint64_t value);
  template <typename Members>
  void list(Column column, const Members& members);

  Sink& out_;
  bool json_;
  bool csv_;
  const std::vector<std::string>* names_;
  std::vector<Column> columns_;
  std::string text_;
  std::size_t head_ = 0;  // where the numbers of the line end, and its lists begin
};

}  // namespace changeover
