#include "loadorder/show/step_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/each.hpp"
#include "io/scan/row_reader.hpp"
#include "io/write/csv_cell.hpp"
#include "io/write/json_writer.hpp"

namespace changeover {

namespace {

const char* name_of(Column column) {
  static constexpr const char* names[] = {
      "worker", "epoch",   "step",        "load",       "evict",      "store",    "new_pairs",
      "before", "compute", "evict_first", "evict_late", "fast_evict", "fast_load"};
  return names[static_cast<std::size_t>(column)];
}

}  // namespace

void StepWriter::begin(const std::string& json, const std::string& text) {
  if (colmap_) {
    check_names_for_colmap();
    return;
  }
  out_.write((json_ ? json : csv_ ? joined(columns_, ",", name_of) : text) + "\n");
}

// COLMAP skips empty lines and those that begin with #, and splits the others at blanks.
void StepWriter::check_names_for_colmap() const {
  if (names_ == nullptr) {
    return;
  }
  for (const std::string& name : *names_) {
    if (name.starts_with('#') || name.find_first_of(" \t\n\v\f\r") != std::string::npos) {
      throw BadInput(
          fmt::format("the name '{}' has a blank or begins with #: COLMAP cannot read it "
                      "in a list of pairs; rename the image",
                      name));
    }
  }
}

void StepWriter::write_for_colmap(const std::vector<ItemPair>& pairs) {
  if (pairs.empty()) {
    return;
  }
  text_ += std::exchange(is_first_block_, false) ? "" : "\n";
  const auto put = [&](Element item, char after) {
    text_ += names_ == nullptr ? std::to_string(item) : (*names_)[item];
    text_ += after;
  };
  for (const auto& [x, y] : pairs) {
    put(x, ' ');
    put(y, '\n');
  }
}

void StepWriter::write(const Step& step) {
  constexpr std::size_t piece = 1 << 16;
  if (colmap_) {
    write_for_colmap(step.compute);
    if (text_.size() >= piece) {
      end();
    }
    return;
  }
  const auto late = step.evict.end() - static_cast<std::ptrdiff_t>(step.late);
  for (const Column column : columns_) {
    switch (column) {
      case Column::worker:
        number(column, step.worker);
        break;
      case Column::epoch:
        number(column, step.epoch);
        break;
      case Column::step:
        number(column, step.number);
        break;
      case Column::load:
        list(column, step.load);
        break;
      case Column::evict:
        list(column, step.evict);
        break;
      case Column::store:
        list(column, step.store);
        break;
      case Column::new_pairs:
      case Column::before:
        list(column, step.compute);
        break;
      case Column::compute:
        list(column, step.overlap);
        break;
      case Column::evict_first:
        list(column, std::span(step.evict.begin(), late));
        break;
      case Column::evict_late:
        list(column, std::span(late, step.evict.end()));
        break;
      case Column::fast_evict:
        list(column, step.fast_evict);
        break;
      case Column::fast_load:
        list(column, step.fast_load);
        break;
    }
  }
  if (!json_ && !csv_ && text_.size() == head_) {
    text_ += " nothing to do";
  }
  text_ += json_ ? "}\n" : "\n";
  if (text_.size() >= piece) {
    end();
  }
}

void StepWriter::end() {
  out_.write(text_);
  text_.clear();
}

void StepWriter::add(Element item) {
  if (names_ == nullptr) {
    text_ += fmt::format_int(item).c_str();
  } else if (json_) {
    append_json_string(text_, (*names_)[item]);
  } else {
    text_ += quoted_among_blanks((*names_)[item]);
  }
}

void StepWriter::add(const ItemPair& pair) {
  // A name may have a hyphen.
  const char between = json_ ? ',' : names_ != nullptr ? '|' : '-';
  text_ += json_ ? "[" : "";
  add(pair.first);
  text_ += between;
  add(pair.second);
  text_ += json_ ? "]" : "";
}

void StepWriter::number(Column column, std::uint64_t value) {
  const bool first = column == columns_.front();
  text_ += first ? (json_ ? "{" : "") : (json_ || csv_ ? "," : " ");
  if (!csv_) {
    text_ += json_ ? "\"" : "";
    text_ += name_of(column);
    text_ += json_ ? "\":" : " ";
  }
  text_ += fmt::format_int(value).c_str();
  text_ += column == Column::step && !json_ && !csv_ ? ":" : "";
  head_ = text_.size();
}

template <typename Members>
void StepWriter::list(Column column, const Members& members) {
  if (json_) {
    text_ += ",\"";
    text_ += name_of(column);
    text_ += "\":[";
  } else if (csv_) {
    text_ += ',';
  } else if (members.empty()) {
    return;
  } else {
    std::string name = name_of(column);
    std::ranges::replace(name, '_', ' ');
    text_ += (text_.size() == head_ ? " " : "; ") + name + " ";
  }
  const std::size_t cell = text_.size();
  bool first = true;
  for (const auto& member : members) {
    text_ += first ? "" : json_ ? "," : " ";
    add(member);
    first = false;
  }
  if (csv_ && names_ != nullptr) {
    text_.replace(cell, std::string::npos, csv_cell(std::string_view(text_).substr(cell)));
  }
  text_ += json_ ? "]" : "";
}

}  // namespace changeover
