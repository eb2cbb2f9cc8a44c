#include "io/workbook/merged_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "changeover/core/error.hpp"
#include "io/scan/xml_events.hpp"
#include "io/workbook/cell_text.hpp"

namespace changeover {
namespace {

constexpr std::string_view element = "mergeCell";
constexpr std::size_t most_ranges = 100'000;

// "B2:B4"; a range that is none has no row.
MergedRange range_in(std::string_view ref) {
  const std::size_t colon = ref.find(':');
  const auto first = cell_place(ref.substr(0, colon));
  const auto last = colon == std::string_view::npos ? first : cell_place(ref.substr(colon + 1));
  const bool is_range = first && last && first->row <= last->row && first->column <= last->column;
  return is_range ? MergedRange{.first_column = first->column,
                                .first_row = first->row,
                                .last_column = last->column,
                                .last_row = last->row}
                  : MergedRange{};
}

class Ranges final : public XmlHandler {
 public:
  explicit Ranges(std::string place) : place_(std::move(place)) {}

  void begin(std::string_view name, const XmlAttributes& attributes) override {
    if (name != element) {
      return;
    }
    const MergedRange range = range_in(attributes.find("ref").value_or(""));
    if (range.last_row == 0) {
      throw BadInput(place_ + ": merged cells without a range; save it again");
    }
    ranges_.push_back(range);
    if (ranges_.size() > most_ranges) {
      throw BadInput(
          fmt::format("{}: more than {} merged ranges; separate these cells", place_, most_ranges));
    }
  }
  void end(std::string_view /*name*/) override {}
  void text(std::string_view /*piece*/) override {}

  [[nodiscard]] std::vector<MergedRange>& ranges() { return ranges_; }

 private:
  std::string place_;
  std::vector<MergedRange> ranges_;
};

// Whether a sheet speaks of merged cells at all, without looking at its elements.
bool mentions_them(ZipArchive::Member member) {
  std::string end_before;
  for (std::string piece = member.next(); !piece.empty(); piece = member.next()) {
    const std::string joint = end_before + piece.substr(0, element.size());
    if (piece.find(element) != std::string::npos || joint.find(element) != std::string::npos) {
      return true;
    }
    end_before += piece;
    end_before.erase(0, end_before.size() - std::min(end_before.size(), element.size()));
  }
  return false;
}

}  // namespace

std::vector<MergedRange> merged_ranges(const ZipArchive& archive, const std::string& member,
                                       std::uint64_t most_bytes, const std::string& place) {
  auto sheet = archive.open(member, most_bytes);
  if (!sheet || !mentions_them(*std::move(sheet))) {
    return {};
  }
  Ranges found(place);
  XmlReader reader(place, found);
  sheet = archive.open(member, most_bytes);
  for (std::string piece = sheet->next(); !piece.empty(); piece = sheet->next()) {
    reader.feed(piece);
  }
  reader.finish();
  return std::move(found.ranges());
}

std::string range_name(const MergedRange& range) {
  return cell_name(range.first_column, range.first_row) + ":" +
         cell_name(range.last_column, range.last_row);
}

MergedCells::MergedCells(std::vector<MergedRange> ranges, std::string place)
    : ranges_(std::move(ranges)), place_(std::move(place)) {
  std::ranges::stable_sort(ranges_, {}, &MergedRange::first_row);
}

std::uint64_t MergedCells::fill(SheetRow& row) {
  std::erase_if(open_, [&](const auto& each) { return each.second.range.last_row < row.number; });
  std::uint64_t added = 0;
  const auto at = [&](std::uint64_t column) {
    return std::ranges::lower_bound(row.cells, column, {}, &SheetCell::column);
  };
  for (const auto& [column, open] : open_) {
    const auto cell = at(column);
    if (cell == row.cells.end() || cell->column != column) {
      if (!open.text.empty()) {
        row.cells.insert(cell, {.column = column, .text = open.text});
        added += open.text.size();
      }
    } else if (cell->text != open.text) {
      throw BadInput(
          fmt::format("{}!{}: it is hidden by the merged cells {}, and says something "
                      "else; separate them",
                      place_, cell_name(column, row.number), range_name(open.range)));
    }
  }
  for (; next_ < ranges_.size() && ranges_[next_].first_row <= row.number; ++next_) {
    const MergedRange& range = ranges_[next_];
    if (range.last_row < row.number) {
      continue;
    }
    const auto cell = at(range.first_column);
    const bool says = range.first_row == row.number && cell != row.cells.end() &&
                      cell->column == range.first_column;
    open_.insert_or_assign(range.first_column,
                           Open{.range = range, .text = says ? cell->text : ""});
  }
  for (const auto& [column, open] : open_) {
    if (open.range.last_column > column) {
      row.across.push_back(open.range);
    }
  }
  return added;
}

}  // namespace changeover
