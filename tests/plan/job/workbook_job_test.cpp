// Lists of plan out of workbooks: the same rows as from a text.
#include <gmock/gmock.h>

#include "changeover/plan/job.hpp"
#include "core/each.hpp"
#include "message_of.hpp"
#include "run_program.hpp"
#include "zip_files.hpp"

namespace changeover::workbook_job_test {
namespace {

using test::workbook_of;
using test::zipped;
using testing::ElementsAre;
using testing::HasSubstr;

std::string text_cell(const std::string& text) {
  return "<c t='inlineStr'><is><t xml:space='preserve'>" + text + "</t></is></c>";
}
std::string number_cell(const std::string& number) { return "<c><v>" + number + "</v></c>"; }

std::unique_ptr<Input> book(const std::string& rows) {
  return input_from_text(zipped(workbook_of({{"S", rows}})), "f.xlsx");
}

TEST(WorkbookJob, Parts) {
  const PartList list = read_parts(
      *book("<row>" + text_cell("component") + text_cell("change\ncost") + "</row>" + "<row>" +
            text_cell("Valve, large") + number_cell("0.30000000000000004") + "</row><row r='7'>" +
            text_cell(" #5 ") + text_cell("12,50") + "</row>" + "<row>" + number_cell("1001") +
            "</row><row>" + text_cell("=1+1") + number_cell("3") + "</row>"));
  EXPECT_THAT(list.names, ElementsAre("Valve, large", "#5", "1001", "=1+1"));
  EXPECT_THAT(list.change_costs, ElementsAre(parse_amount("0.3"), parse_amount("12.5"),
                                             std::nullopt, parse_amount("3")));
  EXPECT_EQ(list.note,
            "f.xlsx: the first row is a header: names in 'component', change costs in 'change "
            "cost'");
}

TEST(WorkbookJob, SaysWhichCell) {
  const auto parts = [](const std::string& rows) {
    return message_of([&] { (void)read_parts(*book(rows)); });
  };
  const std::string head = "<row>" + text_cell("part") + text_cell("cost") + "</row>";
  EXPECT_EQ(parts(head + "<row r='4'>" + text_cell("A") + text_cell("much") + "</row>"),
            "f.xlsx:S!B4: 'much' is not a cost; write a number, such as 12 or 12.50");
  EXPECT_THAT(parts(head + "<row>" + text_cell("A") + "</row><row>" + text_cell("A") + "</row>"),
              HasSubstr("f.xlsx:S!A3: a second part is called 'A'"));
  EXPECT_THAT(parts(head + "<row>" +
                    text_cell("A\xE2\x80\xAE"
                              "B") +
                    "</row>"),
              HasSubstr("f.xlsx:S!A2: U+202E"));
  EXPECT_THAT(parts(head + "<row>" + text_cell("A") + number_cell("0.3333333333333333") + "</row>"),
              HasSubstr("f.xlsx:S!B2: "));
  EXPECT_THAT(parts(head + "<row>" + text_cell("A") + "<c r='ZZZ2'><v>1</v></c></row>"),
              HasSubstr("'ZZZ2'"));
  EXPECT_THAT(parts(head + "<row>" + text_cell("A") + "<c r='CZZ2'><v>1</v></c></row>"),
              HasSubstr("f.xlsx:S!CZZ2: a cell beyond column 2048"));
  EXPECT_THAT(parts(""), HasSubstr("no part is listed"));
  EXPECT_THAT(
      message_of([] {
        (void)read_pairs(*book("<row>" + text_cell("A") + text_cell("X") + "</row>"), {"A", "B"});
      }),
      HasSubstr("f.xlsx:S!B1: there is no part 'X'"));
}

TEST(WorkbookJob, PairsSlotsAndSetUps) {
  const std::vector<std::string> names{"A", " B ", "=C"};
  const std::string row = "<row>" + text_cell("A") + text_cell(" B ") + "</row><row>" +
                          number_cell("1") + text_cell("=C") + "</row>";
  const PairSet pairs = read_pairs(*book(row), names);
  EXPECT_EQ(pairs.size(), 2U);
  EXPECT_TRUE(pairs.contains(0, 1) && pairs.contains(0, 2));
  EXPECT_THAT(read_setups(*book(row), names), ElementsAre(Block{0, 1}, Block{0, 2}));
  const auto slots =
      read_slots(*book("<row>" + text_cell("CPU") + number_cell("1") + number_cell("2") +
                       "</row><row>" + text_cell("fan") + "<c/>" + number_cell("3") + "</row>"));
  ASSERT_EQ(slots.size(), 2U);
  EXPECT_EQ(slots[1].least, 0U);
  EXPECT_EQ(slots[1].most, 3U);
}

TEST(WorkbookJob, RowsOfARunSheetMayEndBeforeTheirLastColumn) {
  const DoneList list =
      read_done(*book("<row>" + text_cell("slot_1") + text_cell("slot_2") + text_cell("Result") +
                      "</row>" + "<row>" + text_cell("A") + "</row><row>" + text_cell("B") +
                      text_cell("A") + text_cell("fail") + text_cell("leaks\nbadly") + "</row>"),
                {"A", "B"});
  EXPECT_THAT(list.setups(), ElementsAre(Block{0}, Block{1, 0}));
  EXPECT_THAT(each_of<std::string>(list.rows, &DoneRow::result), ElementsAre("", "fail"));
}

TEST(WorkbookJob, OneSheetOfSeveral) {
  const test::TemporaryFolder folder;
  test::spit(folder.file("f.xlsx"),
             zipped(workbook_of({{"A", "<row>" + text_cell("x") + "</row>"},
                                 {"B", "<row>" + text_cell("y") + "</row>"}})));
  test::spit(folder.file("f.csv"), "a\nb\n");
  test::spit(folder.file("odd:name"), "c\n");
  const auto names = [&](const std::string& path) {
    return read_parts(*open_list(folder.file(path)), Header::none).names;
  };
  EXPECT_THAT(names("f.xlsx"), ElementsAre("x"));
  EXPECT_THAT(names("f.xlsx:b"), ElementsAre("y"));
  EXPECT_THAT(names("odd:name"), ElementsAre("c"));
  EXPECT_THAT(message_of([&] { names("f.csv:b"); }),
              HasSubstr("not a workbook (.xlsx), so it has no"));
  EXPECT_THAT(message_of([&] { names("f.xlsx:C"); }), HasSubstr("there is no sheet 'C'"));
  EXPECT_THROW(names("none.xlsx:b"), MissingResource);
  EXPECT_EQ(list_file(folder.file("f.xlsx:b")), folder.file("f.xlsx"));
  EXPECT_EQ(list_file(folder.file("odd:name")), folder.file("odd:name"));
}

}  // namespace
}  // namespace changeover::workbook_job_test
