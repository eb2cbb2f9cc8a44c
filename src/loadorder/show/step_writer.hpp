// Writes a schedule, one step per line, for --json, --format csv and --format text.
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

/// A part of a step, with its column name.
enum class Column : std::uint8_t {
  worker,
  epoch,
  step,
  load,
  evict,
  store,
  new_pairs,  ///< computed pairs
  before,     ///< or, if loads overlap computation, the pairs computed first
  compute,    ///< and those computed then
  evict_first,
  evict_late,
  fast_evict,
  fast_load
};

/// Writes a schedule in a format: a head, then a line for each step. Empty lists are omitted in
/// text. For COLMAP only the computed pairs are written, two names per line, with an empty line
/// between steps.
class StepWriter {
 public:
  /// Items are written as `names`, if there are any.
  StepWriter(Sink& out, const std::string& format, const std::vector<std::string>* names,
             std::vector<Column> columns)
      : out_(out),
        json_(format == "jsonl"),
        csv_(format == "csv"),
        colmap_(format == "colmap"),
        names_(names != nullptr && !names->empty() ? names : nullptr),
        columns_(std::move(columns)) {}

  /// The head in JSON or in text; in CSV the header. @throws BadInput for names that COLMAP cannot
  /// read
  void begin(const std::string& json, const std::string& text);

  void write(const Step& step);

  void end();

 private:
  void check_names_for_colmap() const;
  void write_for_colmap(const std::vector<ItemPair>& pairs);
  void add(Element item);
  void add(const ItemPair& pair);
  void number(Column column, std::uint64_t value);
  template <typename Members>
  void list(Column column, const Members& members);

  Sink& out_;
  bool json_;
  bool csv_;
  bool colmap_;
  const std::vector<std::string>* names_;
  std::vector<Column> columns_;
  std::string text_;
  bool is_first_block_ = true;
  std::size_t head_ = 0;  // end of the numbers of the line, where its lists begin
};

}  // namespace changeover
