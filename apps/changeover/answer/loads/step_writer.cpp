#include "answer/loads/step_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "io/scan/row_reader.hpp"
#include "io/write/csv_cell.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {

void StepWriter::begin(const std::string& json, const std::string& text,
                       const std::string& columns) {
  out_.write(json_ ? json + "\n" : csv_ ? columns + "\n" : text + "\n");
}

void StepWriter::write(const LoadStep& step, std::optional<std::uint64_t> worker,
                       const std::vector<ItemPair>* work, const std::vector<Element>* store) {
  start(step.number, worker);
  list("load", step.load);
  list("evict", step.evict);
  if (store != nullptr) {
    list("store", *store);
  }
  if (work != nullptr) {
    list("new_pairs", *work);
  }
  finish();
}

void StepWriter::write(const PrefetchStep& step) {
  start(step.number, {});
  list("load", step.load);
  if (json_) {  // the name that every order has
    std::vector<Element> all = step.evict_first;
    all.insert(all.end(), step.evict_late.begin(), step.evict_late.end());
    list("evict", all);
  }
  list("evict_first", step.evict_first);
  list("evict_late", step.evict_late);
  list("before", step.before);
  list("compute", step.overlap);
  finish();
}

void StepWriter::write(const TwoLevelStep& step, bool with_pairs) {
  start(step.number, {});
  list("fast_evict", step.fast_evict);
  list("evict", step.evict);
  list("load", step.load);
  list("fast_load", step.fast_load);
  if (with_pairs) {
    list("new_pairs", step.pairs);
  }
  finish();
}

void StepWriter::end() {
  out_.write(text_);
  text_.clear();
}

void StepWriter::add(Element item) {
  if (names_ == nullptr) {
    fmt::format_to(std::back_inserter(text_), "{}", item);
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

void StepWriter::start(std::uint64_t number, std::optional<std::uint64_t> worker) {
  if (worker) {
    text_ += json_ ? "{\"worker\":" : csv_ ? "" : "worker ";
    fmt::format_to(std::back_inserter(text_), "{}", *worker);
    text_ += json_ ? ",\"step\":" : csv_ ? "," : " step ";
  } else {
    text_ += json_ ? "{\"step\":" : csv_ ? "" : "step ";
  }
  fmt::format_to(std::back_inserter(text_), "{}", number);
  text_ += json_ || csv_ ? "" : ":";
}

template <typename Member>
void StepWriter::list(std::string name, const std::vector<Member>& members) {
  if (json_) {
    text_ += ",\"" + name + "\":[";
  } else if (csv_) {
    text_ += ',';
  } else if (members.empty()) {
    return;
  } else {
    std::replace(name.begin(), name.end(), '_', ' ');
    text_ += (text_.back() == ':' ? " " : "; ") + name + " ";
  }
  const std::size_t cell = text_.size();
  for (std::size_t i = 0; i < members.size(); ++i) {
    text_ += i == 0 ? "" : json_ ? "," : " ";
    add(members[i]);
  }
  if (csv_ && names_ != nullptr) {
    text_.replace(cell, std::string::npos, csv_cell(std::string_view(text_).substr(cell)));
  }
  text_ += json_ ? "]" : "";
}

void StepWriter::finish() {
  constexpr std::size_t piece = 1 << 16;
  text_ += json_ ? "}\n" : "\n";
  if (text_.size() >= piece) {
    end();
  }
}

}  // namespace changeover::cli
