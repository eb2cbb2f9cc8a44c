// Run sheets as workbooks.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>
#include <xlsxwriter.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <initializer_list>
#include <new>
#include <string>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/tables.hpp"
#include "core/utf8.hpp"
#include "io/workbook/cell_text.hpp"
#include "plan/sheet/sheet_words.hpp"
#include "plan/sheet/slot_columns.hpp"

namespace changeover {
namespace {

// A file without a name: the library writes files only, and this one cannot be left behind.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("workbook", MFD_CLOEXEC)) {
    if (descriptor_ < 0) {
      throw MissingResource("no memory for the workbook; close other programs");
    }
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }
  [[nodiscard]] std::string bytes() const { return read_to_end(*open_input(path())); }

 private:
  int descriptor_;
};

void check(lxw_error error) {
  if (error == LXW_ERROR_MEMORY_MALLOC_FAILED) {
    throw std::bad_alloc();
  }
  if (error != LXW_NO_ERROR) {
    throw MissingResource(fmt::format("cannot make the workbook: {}; make room for temporary files",
                                      lxw_strerror(error)));
  }
}

class Workbook {
 public:
  Workbook() : book_(workbook_new(file_.path().c_str())) {
    if (book_ == nullptr) {
      throw std::bad_alloc();
    }
    text = format([](lxw_format* f) { format_set_num_format(f, "@"); });  // stays text when edited
    wrapped = format([](lxw_format* f) {
      format_set_num_format(f, "@");
      format_set_text_wrap(f);
    });
    bold = format([](lxw_format* f) {
      format_set_num_format(f, "@");
      format_set_bold(f);
    });
    head = format([](lxw_format* f) {
      format_set_bold(f);
      format_set_text_wrap(f);
      format_set_bottom(f, LXW_BORDER_MEDIUM);
    });
    title = format([](lxw_format* f) {
      constexpr double large = 14;
      format_set_bold(f);
      format_set_font_size(f, large);
    });
  }
  ~Workbook() {
    if (book_ != nullptr) {
      lxw_workbook_free(book_);
    }
  }
  Workbook(const Workbook&) = delete;
  Workbook& operator=(const Workbook&) = delete;

  template <typename Set>
  lxw_format* format(Set&& set) {
    lxw_format* const made = workbook_add_format(book_);
    if (made == nullptr) {
      throw std::bad_alloc();
    }
    format_set_align(made, LXW_ALIGN_VERTICAL_TOP);
    set(made);
    return made;
  }

  lxw_worksheet* sheet(const char* name) {
    lxw_worksheet* const made = workbook_add_worksheet(book_, name);
    if (made == nullptr) {
      throw std::bad_alloc();
    }
    return made;
  }

  // The same plan makes the same bytes: the date is that of the members of the archive.
  void describe(const std::string& what) {
    std::string words = what.substr(0, longest_property(what));
    lxw_doc_properties properties = {};
    properties.title = words.data();
    std::tm date = {};
    date.tm_year = 80;
    date.tm_mday = 1;
    properties.created = timegm(&date);
    check(workbook_set_properties(book_, &properties));
  }

  std::string bytes() {
    lxw_workbook* const book = std::exchange(book_, nullptr);
    check(workbook_close(book));  // and frees it
    return file_.bytes();
  }

  lxw_format* text;
  lxw_format* wrapped;
  lxw_format* bold;
  lxw_format* head;
  lxw_format* title;

 private:
  // At most so many bytes, and whole letters.
  static std::size_t longest_property(const std::string& text) {
    constexpr std::size_t most = 200;
    std::size_t end = 0;
    while (end < text.size()) {
      const std::size_t next = end + first_code_point(std::string_view(text).substr(end)).bytes;
      if (next > most) {
        break;
      }
      end = next;
    }
    return end;
  }

  MemoryFile file_;
  lxw_workbook* book_;
};

// Writes cells of one sheet and remembers how wide its columns must be.
class SheetWriter {
 public:
  SheetWriter(Workbook& book, const char* name, unsigned decimals)
      : book_(&book), sheet_(book.sheet(name)) {
    const std::string code = decimals == 0 ? "#,##0" : "#,##0." + std::string(decimals, '0');
    money_ = book.format([&](lxw_format* f) { format_set_num_format(f, code.c_str()); });
    count_ = book.format([](lxw_format* f) { format_set_num_format(f, "0"); });
  }

  void text(lxw_row_t row, std::size_t column, const std::string& words, lxw_format* format) {
    if (!words.empty()) {
      check(worksheet_write_string(sheet_, row, at(column), with_escapes(words).c_str(), format));
    }
  }

  // A column is as wide as what is written with this.
  void wide_text(lxw_row_t row, std::size_t column, const std::string& words, lxw_format* format) {
    text(row, column, words, format);
    widen(column, display_width(words));
  }

  // A line over the first seven columns, as high as it needs.
  void paragraph(lxw_row_t row, const std::string& words) {
    constexpr lxw_col_t last = 6;
    constexpr std::size_t letters_a_line = 90;
    constexpr double height = 15;
    check(worksheet_merge_range(sheet_, row, 0, row, last, with_escapes(words).c_str(),
                                book_->wrapped));
    check(worksheet_set_row(sheet_, row,
                            height * static_cast<double>(1 + display_width(words) / letters_a_line),
                            nullptr));
  }

  void count(lxw_row_t row, std::size_t column, std::uint64_t number) {
    check(worksheet_write_number(sheet_, row, at(column), static_cast<double>(number), count_));
    widen(column, std::to_string(number).size());
  }

  // Exactly: a cell has 15 digits, so more of them are written as text.
  void money(lxw_row_t row, std::size_t column, Amount amount, const std::string& words) {
    constexpr std::uint64_t most = 1'000'000'000'000'000;
    constexpr double millionths = 1e6;
    if (amount.millionths < most) {
      check(worksheet_write_number(sheet_, row, at(column),
                                   static_cast<double>(amount.millionths) / millionths, money_));
    } else {
      text(row, column, words, book_->text);
    }
    widen(column, words.size() + words.size() / 3);
  }

  void widen(std::size_t column, std::size_t letters_wide) {
    widths_.resize(std::max(widths_.size(), column + 1), least_width);
    widths_[column] = std::max(widths_[column], std::min(letters_wide, most_width));
  }

  // Pages as wide as the sheet, its first row on each.
  void print_set_up(const std::string& title, bool landscape, bool has_head) {
    constexpr std::uint8_t a4 = 9;
    for (std::size_t column = 0; column < widths_.size(); ++column) {
      check(worksheet_set_column(sheet_, at(column), at(column),
                                 static_cast<double>(widths_[column]) + 1.5, nullptr));
    }
    worksheet_set_paper(sheet_, a4);
    landscape ? worksheet_set_landscape(sheet_) : worksheet_set_portrait(sheet_);
    worksheet_fit_to_pages(sheet_, 1, 0);
    if (has_head) {
      worksheet_gridlines(sheet_, LXW_SHOW_ALL_GRIDLINES);
      worksheet_freeze_panes(sheet_, 1, 0);
      check(worksheet_repeat_rows(sheet_, 0, 0));
    }
    constexpr std::size_t longest_header = 200;
    std::string header = "&L";
    for (const char c : title) {
      header += c == '&' ? "&&" : std::string(1, c);
    }
    if (header.size() <= longest_header) {
      check(worksheet_set_header(sheet_, header.c_str()));
    }
    check(worksheet_set_footer(sheet_, "&CPage &P of &N"));
  }

  [[nodiscard]] lxw_worksheet* sheet() const { return sheet_; }
  [[nodiscard]] static lxw_col_t at(std::size_t column) { return static_cast<lxw_col_t>(column); }

 private:
  static constexpr std::size_t least_width = 4;
  static constexpr std::size_t most_width = 32;

  Workbook* book_;
  lxw_worksheet* sheet_;
  lxw_format* money_;
  lxw_format* count_;
  std::vector<std::size_t> widths_;
};

// A list to choose from; other words are taken, too.
void offer_results(lxw_worksheet* sheet, std::size_t column, std::size_t rows) {
  std::array<std::string, 3> words{"pass", "fail", "unclear"};
  std::array<char*, 4> list{words[0].data(), words[1].data(), words[2].data(), nullptr};
  lxw_data_validation choice = {};
  choice.validate = LXW_VALIDATION_TYPE_LIST;
  choice.value_list = list.data();
  choice.error_type = LXW_VALIDATION_ERROR_TYPE_INFORMATION;
  std::string title = "Result";
  std::string words_said = "pass and fail are used to find the faulty part; other words are kept";
  choice.error_title = title.data();
  choice.error_message = words_said.data();
  check(worksheet_data_validation_range(sheet, 1, SheetWriter::at(column),
                                        static_cast<lxw_row_t>(rows), SheetWriter::at(column),
                                        &choice));
}

void write_steps(Workbook& book, const std::string& name, const SheetDocument& document,
                 unsigned decimals) {
  const Job& job = *document.job;
  const RunSheet& sheet = document.plan->sheet;
  const Money money(job, document.budget);
  const SlotColumns slots(job, sheet);
  SheetWriter writer(book, name.c_str(), decimals);
  std::vector<std::string> heads{"step", "take_out", "put_in"};
  heads.insert(heads.end(), slots.heads().begin(), slots.heads().end());
  const std::size_t numbers = heads.size();
  heads.insert(heads.end(), {"new_" + what_meets(job), "cost", "cost_so_far", "result", "notes"});
  for (std::size_t column = 0; column < heads.size(); ++column) {
    writer.wide_text(0, column, heads[column], book.head);
  }
  lxw_row_t row = 0;
  std::uint64_t number = job.tests_done;
  for (const RunStep& step : sheet.steps) {
    writer.count(++row, 0, ++number);
    writer.text(row, 1, parts_text(step.take_out, job.names), book.wrapped);
    writer.text(row, 2, parts_text(step.put_in, job.names), book.wrapped);
    std::size_t column = 3;
    for (const std::optional<Element> x : slots.row(step.setup)) {
      if (x) {
        const bool is_new = std::binary_search(step.put_in.begin(), step.put_in.end(), *x);
        writer.wide_text(row, column, job.names[*x], is_new ? book.bold : book.text);
      }
      ++column;
    }
    writer.count(row, numbers, new_here(job, step));
    writer.money(row, numbers + 1, step.cost, money(step.cost));
    writer.money(row, numbers + 2, step.cost_so_far, money(step.cost_so_far));
  }
  constexpr std::size_t of_lists = 24;
  constexpr std::size_t of_notes = 40;
  writer.widen(1, of_lists);
  writer.widen(2, of_lists);
  writer.print_set_up(document.title, numbers > 7, true);
  check(worksheet_set_column(writer.sheet(), SheetWriter::at(numbers + 4),
                             SheetWriter::at(numbers + 4), of_notes, book.wrapped));
  if (row > 0) {
    offer_results(writer.sheet(), numbers + 3, row);
    // Numbers that are names are meant as text.
    check(worksheet_ignore_errors(writer.sheet(), LXW_IGNORE_NUMBER_STORED_AS_TEXT,
                                  fmt::format("B2:XFD{}", row + 1).c_str()));
  }
}

void write_plan(Workbook& book, const SheetDocument& document, unsigned decimals) {
  const Job& job = *document.job;
  const RunPlan& plan = *document.plan;
  const RunSheet& sheet = plan.sheet;
  const Money money(job, document.budget);
  SheetWriter writer(book, "Plan", decimals);
  lxw_row_t row = 0;
  writer.text(row, 0, document.title, book.title);
  const auto count = [&](const char* what, std::uint64_t number) {
    writer.wide_text(++row, 0, what, book.text);
    writer.count(row, 1, number);
  };
  const auto cost = [&](const char* what, Amount amount) {
    writer.wide_text(++row, 0, what, book.text);
    writer.money(row, 1, amount, money(amount));
  };
  ++row;
  count("Parts", job.parts());
  count("At a time", job.at_once);
  count("Tests", sheet.steps.size());
  if (job.tests_done > 0) {
    count("Tests done before", job.tests_done);
  }
  count("Changes", sheet.changes);
  count("Pairs needed", sheet.pairs_needed);
  count("Pairs tested", sheet.pairs_tested);
  cost("Cost of one test", job.test_cost);
  cost("Cost of tests", sheet.cost - sheet.change_cost);
  cost("Cost of changes", sheet.change_cost);
  cost("Total cost", sheet.cost);
  cost("Lower bound for all pairs", plan.bound.cost);
  if (document.budget) {
    cost("Budget", *document.budget);
  }
  ++row;
  std::vector<std::string> lines = summary(document);
  if (!job.mounted.empty()) {
    lines.push_back("mounted all the time: " + joined(names_of(job, job.mounted)));
  }
  for (const std::string& line : lines) {
    writer.paragraph(++row, line);
  }
  row += 2;
  std::size_t column = 0;
  for (const char* head : {"plan", "tests", "changes", "cost", "pairs", "dearer by", "how"}) {
    writer.wide_text(row, column++, head, book.head);
  }
  for (const Candidate& candidate : plan.candidates) {
    writer.wide_text(++row, 0, candidate.name, book.text);
    writer.count(row, 1, candidate.tests());
    writer.count(row, 2, candidate.changes);
    writer.money(row, 3, candidate.cost, money(candidate.cost));
    writer.count(row, 4, candidate.pairs_tested);
    writer.wide_text(row, 5, difference(document, candidate), book.text);
    writer.wide_text(row, 6, candidate.how, book.text);
  }
  writer.print_set_up(document.title, true, false);
}

void write_bench_plan(Workbook& book, const BenchDocument& document, unsigned decimals) {
  const BenchPlan& plan = *document.plan;
  const Money money(*document.job);
  SheetWriter writer(book, "Plan", decimals);
  lxw_row_t row = 0;
  writer.text(row++, 0, document.title, book.title);
  for (const std::string& line : bench_summary(document)) {
    writer.paragraph(++row, line);
  }
  if (!document.job->mounted.empty()) {
    writer.paragraph(++row, mounted_line(*document.job));
  }
  const auto table = [&](std::initializer_list<const char*> heads) {
    row += 2;
    std::size_t column = 0;
    for (const char* head : heads) {
      writer.wide_text(row, column++, head, book.head);
    }
  };
  table({"bench", "tests", "changes", "cost"});
  for (std::size_t bench = 0; bench < plan.sheets.size(); ++bench) {
    const RunSheet& sheet = plan.sheets[bench];
    writer.wide_text(++row, 0, fmt::format("Bench {}", bench + 1), book.text);
    writer.count(row, 1, sheet.steps.size());
    writer.count(row, 2, sheet.changes);
    writer.money(row, 3, sheet.cost, money(sheet.cost));
  }
  table({"plan", "tests", "changes", "largest", "together", "how"});
  for (const BenchCandidate& candidate : plan.candidates) {
    writer.wide_text(++row, 0, candidate.name, book.text);
    writer.count(row, 1, candidate.tests);
    writer.count(row, 2, candidate.changes);
    writer.money(row, 3, candidate.largest, money(candidate.largest));
    writer.money(row, 4, candidate.cost, money(candidate.cost));
    writer.wide_text(row, 5, candidate.how, book.text);
  }
  writer.print_set_up(document.title, true, false);
}

void write_parts(Workbook& book, const Job& job, const Money& money, const std::string& title) {
  const unsigned decimals = money.decimals();
  SheetWriter writer(book, "Parts", decimals);
  writer.wide_text(0, 0, "part", book.head);
  writer.wide_text(0, 1, "change_cost", book.head);
  if (!job.slots.empty()) {
    writer.wide_text(0, 2, "slot", book.head);
  }
  for (std::size_t i = 0; i < job.names.size(); ++i) {
    const auto row = static_cast<lxw_row_t>(i + 1);
    writer.wide_text(row, 0, job.names[i], book.text);
    writer.money(row, 1, job.change_costs[i], money(job.change_costs[i]));
    if (!job.slots.empty() && job.slot_of[i] != no_slot) {
      writer.wide_text(row, 2, job.slots[job.slot_of[i]].name, book.text);
    }
  }
  writer.print_set_up(title, false, true);
  if (!job.names.empty()) {
    check(worksheet_ignore_errors(writer.sheet(), LXW_IGNORE_NUMBER_STORED_AS_TEXT,
                                  fmt::format("A2:A{}", job.names.size() + 1).c_str()));
  }
}

}  // namespace

std::string sheet_as_xlsx(const SheetDocument& document) {
  const Money money(*document.job, document.budget);
  Workbook book;
  book.describe(document.title);
  write_steps(book, "Run sheet", document, money.decimals());
  write_plan(book, document, money.decimals());
  write_parts(book, *document.job, money, document.title);
  return book.bytes();
}

std::string benches_as_xlsx(const BenchDocument& document) {
  const Money money(*document.job);
  Workbook book;
  book.describe(document.title);
  for (std::size_t bench = 0; bench < document.plan->sheets.size(); ++bench) {
    const std::string name = fmt::format("Bench {}", bench + 1);
    RunPlan one;
    one.sheet = document.plan->sheets[bench];
    write_steps(
        book, name,
        {.job = document.job, .plan = &one, .title = fmt::format("{}: {}", document.title, name)},
        money.decimals());
  }
  write_bench_plan(book, document, money.decimals());
  write_parts(book, *document.job, money, document.title);
  return book.bytes();
}

}  // namespace changeover
