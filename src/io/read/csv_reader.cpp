#include "changeover/io/formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <unordered_set>

#include "io/read/collector.hpp"
#include "io/read/declared.hpp"
#include "io/scan/place.hpp"
#include "io/scan/token_table.hpp"
#include "io/write/csv_cell.hpp"

namespace changeover {
namespace {

struct Field {
  std::string text;  // without quotes and the blanks around it
  std::size_t offset = 0;
};

// Splits text into records of fields.
class Records {
 public:
  Records(std::string_view text, const std::string& name) : text_(text), name_(&name) {
    separator_ = find_separator();
  }

  // The next record that is not blank or a comment; false at the end.
  bool next(std::vector<Field>& fields) {
    for (;;) {
      if (at_ >= text_.size()) {
        return false;
      }
      count_ = 0;
      if (text_[at_] == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1;
        continue;
      }
      read(fields);
      fields.resize(count_);
      if (std::any_of(fields.begin(), fields.end(),
                      [](const Field& field) { return !field.text.empty(); })) {
        return true;
      }
    }
  }

  [[noreturn]] void fail(std::size_t offset, std::string_view what) const {
    changeover::fail(*name_, place(offset), what);
  }
  Place place(std::size_t offset) const { return place_of(text_, offset); }
  std::size_t here() const { return at_; }

 private:
  char find_separator() const {
    std::size_t start = 0;
    while (start < text_.size() && text_[start] == '#') {
      start = std::min(text_.find('\n', start), text_.size() - 1) + 1;
    }
    const std::size_t found = text_.find_first_of(",;\n", start);
    return found != std::string_view::npos && text_[found] == ';' ? ';' : ',';
  }

  // Reads fields up to the line end and takes that, too.
  void read(std::vector<Field>& fields) {
    for (;;) {
      if (count_ == fields.size()) {
        fields.emplace_back();
      }
      Field& field = fields[count_++];
      field.text.clear();
      skip_blanks();
      field.offset = at_;
      if (at_ < text_.size() && text_[at_] == '"') {
        read_quoted(field);
      } else {
        read_plain(field);
      }
      skip_blanks();
      if (at_ >= text_.size()) {
        return;
      }
      const char c = text_[at_++];
      if (c == separator_) {
        continue;
      }
      if (c == '\n') {
        return;
      }
      if (c == '\r' && (at_ == text_.size() || text_[at_] == '\n')) {
        at_ += at_ < text_.size() ? 1U : 0U;
        return;
      }
      fail(at_ - 1, c == '\r' ? "carriage return inside a line; end lines with LF or CR LF"
                              : "text after a closing quote; double each quote within quotes");
    }
  }

  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) {
      ++at_;
    }
  }

  void read_plain(Field& field) {
    while (at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\n' &&
           text_[at_] != '\r') {
      take(field);
    }
    const std::size_t last = field.text.find_last_not_of(" \t");
    field.text.resize(last == std::string::npos ? 0 : last + 1);
  }

  void read_quoted(Field& field) {
    for (++at_;;) {
      if (at_ >= text_.size()) {
        fail(field.offset, "a quote is opened and not closed; close it");
      }
      if (text_[at_] == '"') {
        ++at_;
        if (at_ >= text_.size() || text_[at_] != '"') {
          return;
        }
      }
      take(field);
    }
  }

  void take(Field& field) {
    const auto byte = static_cast<unsigned char>(text_[at_]);
    if ((byte < 0x20 && byte != '\t') || byte == 0x7f) {
      fail(at_, byte == '\n' || byte == '\r'
                    ? std::string("a line end within quotes; close them before it")
                    : control_byte_defect(text_[at_]));
    }
    if (field.text.size() > max_token_bytes) {
      fail(field.offset,
           fmt::format("a field of more than {} bytes; use shorter names", max_token_bytes));
    }
    field.text += text_[at_++];
  }

  std::string_view text_;
  const std::string* name_;
  char separator_ = ',';
  std::size_t at_ = 0;
  std::size_t count_ = 0;
};

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return result;
}

// "element_3", "element 3", "Element3".
bool is_element_column(std::string_view name) {
  if (!name.starts_with("element")) {
    return false;
  }
  name.remove_prefix(std::string_view("element").size());
  name.remove_prefix(name.starts_with('_') || name.starts_with(' ') ? 1 : 0);
  return plain_number(name).has_value();
}

constexpr std::array<std::string_view, 6> constants = {"v",    "k",        "change",
                                                       "kind", "strength", "elements"};

// What each column of the file is.
class Columns {
 public:
  // Learns them from the first record; false if that is no list of names.
  bool learn(const std::vector<Field>& fields, const Records& records) {
    bool names = false;
    for (const Field& field : fields) {
      const std::string name = lower(field.text);
      names = names || name == "block" || is_element_column(name);
    }
    if (!names) {
      return false;
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::string name = lower(fields[i].text);
      if (is_element_column(name)) {
        elements_.push_back(i);
      }
      const auto constant = std::find(constants.begin(), constants.end(), name);
      if (constant != constants.end()) {
        std::optional<std::size_t>& column =
            constant_columns_[static_cast<std::size_t>(constant - constants.begin())];
        if (column) {
          records.fail(fields[i].offset, fmt::format("two columns {}; remove one", name));
        }
        column = i;
      }
    }
    if (elements_.empty()) {
      records.fail(fields[0].offset,
                   "no columns element_1, element_2, …; name those with elements");
    }
    named_ = true;
    return true;
  }

  // Adds the elements of a record to the block.
  void add_elements(const std::vector<Field>& fields, const Records& records,
                    Collector& collector) const {
    for (std::size_t i = 0; i < (named_ ? elements_.size() : fields.size()); ++i) {
      const std::size_t column = named_ ? elements_[i] : i;
      if (column >= fields.size() || fields[column].text.empty()) {
        continue;
      }
      const Field& field = fields[column];
      const std::string_view word = csv_text(field.text);
      auto defect = word_defect(word);
      defect = defect ? defect : collector.add(word);
      if (defect) {
        records.fail(field.offset, *defect);
      }
    }
  }

  // Compares what the record says of the whole design with what the first one said.
  void check_constants(const std::vector<Field>& fields, const Records& records, ReadOptions& found,
                       bool& labels, std::optional<std::size_t>& place) {
    for (std::size_t i = 0; i < constants.size(); ++i) {
      const auto column = constant_columns_[i];
      if (!column || *column >= fields.size() || fields[*column].text.empty()) {
        continue;
      }
      const Field& field = fields[*column];
      if (!said_[i].empty()) {
        if (field.text != said_[i]) {
          records.fail(field.offset, fmt::format("{} is {} here and {} in the rows before; make "
                                                 "them equal",
                                                 constants[i], shown(field.text), shown(said_[i])));
        }
        continue;
      }
      said_[i] = field.text;
      place = place.value_or(field.offset);
      if (constants[i] == "elements") {
        if (field.text != "labels" && field.text != "numbers") {
          records.fail(field.offset, "the column elements says neither labels nor numbers");
        }
        labels = field.text == "labels";
      } else if (const auto defect = declare(found, constants[i], field.text)) {
        records.fail(field.offset, *defect);
      }
    }
  }

  // The offset of element `which` (from 0) of a record.
  std::size_t offset_of(const std::vector<Field>& fields, std::uint64_t which) const {
    for (std::size_t i = 0; i < (named_ ? elements_.size() : fields.size()); ++i) {
      const std::size_t column = named_ ? elements_[i] : i;
      if (column < fields.size() && !fields[column].text.empty() && which-- == 0) {
        return fields[column].offset;
      }
    }
    return fields[0].offset;
  }

 private:
  bool named_ = false;
  std::vector<std::size_t> elements_;
  std::array<std::optional<std::size_t>, constants.size()> constant_columns_;
  std::array<std::string, constants.size()> said_;
};

}  // namespace

Design read_csv(Input& input, const ReadOptions& options) {
  const std::string bytes = read_to_end(input);
  const std::string_view text = without_byte_order_mark(bytes);
  Records records(text, input.name());
  if (const auto defect = table_defect(text.substr(0, 1U << 16))) {
    records.fail(0, *defect);
  }
  Columns columns;
  std::vector<Field> fields;
  bool more = records.next(fields);
  const bool header = more && columns.learn(fields, records);
  more = header ? records.next(fields) : more;

  Collector collector;
  ReadOptions found;
  bool labels = false;
  std::size_t k = 0;
  std::optional<std::size_t> place;
  for (; more; more = records.next(fields)) {
    columns.check_constants(fields, records, found, labels, place);
    columns.add_elements(fields, records, collector);
    k = k != 0 ? k : collector.block_size();
    if (const auto defect = collector.end_block()) {
      records.fail(fields.back().offset, *defect);
    }
  }
  Collector::Context context{.name = input.name(),
                             .declared = merged(input.name(), options, found),
                             .labels = std::nullopt,
                             .labels_place = {},
                             .place = records.place(place.value_or(0)),
                             .named = labels,
                             .place_of_word = [&](std::uint64_t word) {
                               Records again(text, input.name());
                               std::vector<Field> row;
                               for (std::uint64_t i = 0; i <= word / k + (header ? 1 : 0); ++i) {
                                 again.next(row);
                               }
                               return again.place(columns.offset_of(row, word % k));
                             }};
  return collector.finish(context);
}

}  // namespace changeover
