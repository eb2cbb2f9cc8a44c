#include "io/workbook/workbook_sheet.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <random>

#include "changeover/core/error.hpp"
#include "io/workbook/zip_archive.hpp"
#include "message_of.hpp"
#include "zip_files.hpp"

namespace changeover::workbook_sheet_test {
namespace {

using test::Members;
using test::workbook_of;
using test::zipped;
using testing::HasSubstr;
using testing::StartsWith;

// "A1=Pump B1=2 | A3=…"
std::string said(const std::string& bytes, const std::optional<std::string>& name = {}) {
  WorkbookSheet sheet(bytes, "f.xlsx", name);
  std::string text;
  while (const auto row = sheet.next()) {
    text += text.empty() ? "" : " |";
    for (const SheetCell& cell : row->cells) {
      const std::string place = sheet.place(cell.column, row->number);
      text += " " + place.substr(place.find('!') + 1) + "=" + cell.text;
    }
  }
  return text;
}

std::string fault(const std::string& bytes, const std::optional<std::string>& name = {}) {
  try {
    return "no fault: " + said(bytes, name);
  } catch (const BadInput& bad) {
    return bad.what();
  }
}

std::string one_sheet(const std::string& cells, const std::string& texts = "",
                      const std::string& styles = "") {
  return zipped(workbook_of({{"Costs", cells}}, texts, styles));
}

TEST(WorkbookSheet, CellsOfEveryType) {
  EXPECT_EQ(said(one_sheet(
                "<row r='1'><c r='A1' t='s'><v>0</v></c><c r='C1' t='s'><v>1</v></c></row>"
                "<row r='3'><c t='inlineStr'><is><t>in</t><r><t>line</t></r></is></c>"
                "<c t='b'><v>1</v></c><c><v>12.50</v></c><c s='1'><v>45413</v></c>"
                "<c s='2'><v>3</v></c><c t='str'><f>A1&amp;\"x\"</f><v>Pumpx</v></c>"
                "<c><f>1+1</f><v>2</v></c><c t='d'><v>2024-05-01</v></c><c s='0'/></row>",
                "<si><t>Pump</t></si><si><r><t>Val</t></r><r><t xml:space='preserve'>ve </t></r>"
                "<rPh><t>aloud</t></rPh></si>",
                "<numFmts><numFmt numFmtId='170' formatCode='dd/mm/yyyy'/></numFmts>"
                "<cellStyleXfs><xf numFmtId='14'/></cellStyleXfs>"
                "<cellXfs><xf numFmtId='0'/><xf numFmtId='170'/><xf numFmtId='4'/></cellXfs>")),
            " A1=Pump C1=Valve  | A3=inline B3=TRUE C3=12.5 D3=2024-05-01 E3=3 F3=Pumpx G3=2 "
            "H3=2024-05-01");
}

TEST(WorkbookSheet, LineEndsInACellAreBlanks) {
  EXPECT_EQ(said(one_sheet("<row><c t='s'><v>0</v></c></row>",
                           "<si><t>change\n cost_x000D__x000A_x</t></si>")),
            " A1=change  cost x");
}

TEST(WorkbookSheet, SheetsByName) {
  Members book = workbook_of({{"A", "<row><c><v>1</v></c></row>"},
                              {"B &amp; b", "<row><c><v>2</v></c></row>"},
                              {"C", "<row><c><v>3</v></c></row>"}});
  EXPECT_EQ(said(zipped(book)), " A1=1");
  EXPECT_EQ(said(zipped(book), "b & B"), " A1=2");
  EXPECT_EQ(fault(zipped(book), "D"), "f.xlsx: there is no sheet 'D'; there is 'A', 'B & b', 'C'");
  std::string& xml = book["xl/workbook.xml"];
  xml.replace(xml.find("name=\"A\""), 8, "name=\"A\" state=\"hidden\"");
  EXPECT_EQ(said(zipped(book)), " A1=2") << "hidden sheets are not the first";
  EXPECT_EQ(said(zipped(book), "A"), " A1=1");
}

TEST(WorkbookSheet, PrefixesOfNameSpacesAndOtherPathsAreFine) {
  Members book = workbook_of({{"A", ""}});
  book.erase("xl/worksheets/sheet1.xml");
  std::string& relations = book["xl/_rels/workbook.xml.rels"];
  relations.replace(relations.find("worksheets/sheet1.xml"), 21, "./x/../Sheets//one.xml");
  book["xl/sheets/ONE.xml"] =
      "<x:worksheet xmlns:x='urn:x'><x:sheetData><x:row><x:c><x:v>5</x:v></x:c></x:row>"
      "</x:sheetData></x:worksheet>";
  EXPECT_EQ(said(zipped(book)), " A1=5");
}

TEST(WorkbookSheet, OneLineForEachFault) {
  const auto cell = [](const std::string& xml) {
    return fault(one_sheet("<row>" + xml + "</row>"));
  };
  EXPECT_THAT(cell("<c/><c><f>A1+1</f></c>"),
              StartsWith("f.xlsx:Costs!B1: the value of this formula is not stored in the file"));
  EXPECT_EQ(cell("<c t='e'><f>1/0</f><v>#DIV/0!</v></c>"),
            "f.xlsx:Costs!A1: the formula here results in '#DIV/0!'; correct it");
  EXPECT_THAT(cell("<c t='s'><v>7</v></c>"), HasSubstr("a text that the workbook does not have"));
  EXPECT_THAT(cell("<c t='s'><v>-1</v></c>"), HasSubstr("a text that the workbook does not have"));
  EXPECT_THAT(cell("<c t='z'><v>1</v></c>"), HasSubstr("unknown type 'z'"));
  for (const char* number : {"much", "nan", "inf", "1e999", "1,5", "0x10", "1 2"}) {
    EXPECT_THAT(cell("<c><v>" + std::string(number) + "</v></c>"), HasSubstr("where a number"));
  }
  EXPECT_THAT(cell("<c r='B2'><v>1</v></c>"), HasSubstr("row 1 has a cell called 'B2'"));
  EXPECT_THAT(cell("<c r='B1'><v>1</v></c><c r='A1'/>"), HasSubstr("a cell called 'A1'"));
  EXPECT_THAT(cell("<c r='XFD1'/><c/>"), HasSubstr("beyond the last"));
  EXPECT_THAT(cell("<c t='str'><v>" + std::string(140'000, 'x') + "</v></c>"),
              HasSubstr("more than 32,767 characters; this is not a list"));
  EXPECT_THAT(cell("<c>"), HasSubstr("not XML: mismatched tag"));
  EXPECT_THAT(cell("<c t='str'><v>&nbsp;</v></c>"), HasSubstr("not XML"));
  EXPECT_THAT(fault(one_sheet("<row r='2'/><row r='2'/>")), HasSubstr("misnumbered"));
  EXPECT_THAT(fault(one_sheet("<row r='1048577'/>")), HasSubstr("misnumbered"));
  EXPECT_THAT(fault(one_sheet("", "<si><t>" + std::string(140'000, 'x') + "</t></si>")),
              HasSubstr(": a cell of more than 32,767 characters; this is not a list"));
}

TEST(WorkbookSheet, OtherFilesAreNamed) {
  const std::string old = "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1";
  EXPECT_THAT(fault(old), HasSubstr("an old workbook (.xls); save it as"));
  std::string name;
  for (const char c : std::string("EncryptedPackage")) {
    name += c;
    name += '\0';
  }
  EXPECT_THAT(fault(old + name), HasSubstr("has a password"));
  EXPECT_THAT(fault("PK\x03\x04 and no more"),
              HasSubstr("looks like a zip archive, but cannot be read"));
  EXPECT_THAT(fault(zipped({{"a.txt", "b"}})), HasSubstr("a zip archive, but no workbook"));
  EXPECT_THAT(fault(zipped({{"mimetype", "application/vnd.oasis.opendocument.spreadsheet"}})),
              HasSubstr("an OpenDocument file"));
  EXPECT_THAT(fault(zipped({{"xl/workbook.bin", "b"}})), HasSubstr("(.xlsb)"));
  const Members book = workbook_of({{"A", ""}});
  EXPECT_THAT(fault(zipped(book, "secret")),
              HasSubstr("f.xlsx: its members need a password; save it without one"));
  for (const char* part :
       {"xl/workbook.xml", "xl/sharedStrings.xml", "xl/styles.xml", "xl/worksheets/sheet1.xml"}) {
    Members less = book;
    less.erase(part);
    EXPECT_EQ(fault(zipped(less)),
              "f.xlsx: its part " + std::string(part) + " is missing; save it again");
  }
  Members none = book;
  none["xl/_rels/workbook.xml.rels"] = "<Relationships/>";
  EXPECT_THAT(fault(zipped(none)), HasSubstr("no sheet that can be read"));
}

TEST(WorkbookSheet, EntitiesAndBombsAreRefused) {
  Members book = workbook_of({{"A", ""}});
  const Members good = book;
  book["xl/worksheets/sheet1.xml"] =
      "<!DOCTYPE w [<!ENTITY a 'x'><!ENTITY b '&a;&a;'>]><w><sheetData><row><c "
      "t='str'><v>&b;</v></c></row></sheetData></w>";
  EXPECT_THAT(fault(zipped(book)), HasSubstr("an entity is declared"));
  book = good;
  book["xl/sharedStrings.xml"] = "<sst>" + std::string(65U << 20, ' ') + "</sst>";
  EXPECT_THAT(fault(zipped(book)), HasSubstr("more than 64 MiB when it is unpacked"));
  book = good;
  book["xl/worksheets/sheet1.xml"] = "<w a='" + std::string(2U << 20, 'x') + "'/>";
  EXPECT_THAT(fault(zipped(book)), HasSubstr("a tag of more than 1 MiB"));
  std::string deep;
  for (int i = 0; i < 300; ++i) {
    deep += "<a>";
  }
  book["xl/worksheets/sheet1.xml"] = deep;
  EXPECT_THAT(fault(zipped(book)), HasSubstr("nested more than 256 deep"));
  // A text of 100 KB, 200 times in a row.
  std::string cells;
  for (int i = 0; i < 200; ++i) {
    cells += "<c t='s'><v>0</v></c>";
  }
  EXPECT_THAT(fault(one_sheet("<row>" + cells + "</row>",
                              "<si><t>" + std::string(100'000, 'x') + "</t></si>")),
              HasSubstr("a row of more than 16 MiB"));
}

TEST(ZipArchive, UnpacksNoMoreThanItMay) {
  const ZipArchive archive(zipped({{"a/B.txt", std::string(100'000, 'x')}}), "f.zip");
  EXPECT_TRUE(archive.has("A/b.TXT"));
  EXPECT_FALSE(archive.open("c", 10));
  auto whole = archive.open("a/B.txt", 100'000);
  std::string text;
  for (std::string piece = whole->next(); !piece.empty(); piece = whole->next()) {
    text += piece;
  }
  EXPECT_EQ(text, std::string(100'000, 'x'));
  auto less = archive.open("a/B.txt", 99'999);
  EXPECT_REFUSAL(
      {
        while (!less->next().empty()) {
        }
      },
      BadInput, "f.zip: a/B.txt has more than 0 MiB when it is unpacked; this is not a list");
}

// Whatever is damaged, there is an answer or one line.
TEST(WorkbookSheet, DamagedBytes) {
  const std::string good = one_sheet(
      "<row><c t='s'><v>0</v></c><c s='1'><v>12.5</v></c></row><row><c t='b'><v>1</v></c></row>",
      "<si><t>Pump</t></si>", "<cellXfs><xf numFmtId='0'/><xf numFmtId='14'/></cellXfs>");
  ASSERT_THAT(said(good), StartsWith(" A1=Pump"));
  std::mt19937 random(1);
  std::size_t faults = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string bad = good;
    for (int times = 1 + i % 3; times > 0; --times) {
      bad[random() % bad.size()] = static_cast<char>(random());
    }
    if (i % 5 == 0) {
      bad.resize(random() % bad.size());
    }
    const std::string what = fault(bad);
    faults += what.starts_with("no fault") ? 0U : 1U;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
  EXPECT_GT(faults, 1000U);
}

}  // namespace
}  // namespace changeover::workbook_sheet_test
