// changeover plan with workbooks, as it is run.
#include <gmock/gmock.h>

#include "cases.hpp"
#include "zip_files.hpp"

namespace changeover::test::plan_workbook_test {
namespace {

using testing::HasSubstr;

const std::string fast = " --quiet --threads 1 --steps 20000";

// What a person does with a run sheet: a word in the column `result` of some rows.
std::string filled_in(const std::string& bytes, const std::string& column,
                      const std::map<int, std::string>& results) {
  Members members = unzipped(bytes);
  std::string& sheet = members["xl/worksheets/sheet1.xml"];
  for (const auto& [row, word] : results) {
    const std::size_t start = sheet.find("<row r=\"" + std::to_string(row) + "\"");
    sheet.insert(sheet.find("</row>", start), "<c r=\"" + column + std::to_string(row) +
                                                  "\" t=\"inlineStr\"><is><t>" + word +
                                                  "</t></is></c>");
  }
  return zipped(members);
}

TEST(PlanWorkbook, FromThePartsToTheFaultyOne) {
  const TemporaryFolder folder;
  spit(folder.file("parts.csv"), "part,cost\n=1+1,2.50\nPump,1\n\"a, b\",2\nFan,1\nBelt,3\n");
  const std::string rest = " -k 3 --test-cost 4" + fast;
  expect({{"$changeover plan parts.csv -o run.xlsx" + rest + " && $changeover plan run.xlsx:Parts" +
               rest,
           0, "5 parts, 3 at a time: 4 tests"},
          {"$changeover plan parts.csv -o run.xlsx" + rest +
               " && $changeover plan run.xlsx:Parts --done run.xlsx" + rest,
           0, "nothing is left to test"}},
         folder);
  spit(folder.file("filled.xlsx"),
       filled_in(slurp(folder.file("run.xlsx")), "J", {{2, "pass"}, {3, "fail"}}));
  expect({{"$changeover plan parts.csv --done filled.xlsx" + rest, 0,
           "filled.xlsx: 2 of 4 tests have a result and are done"},
          {"$changeover plan parts.csv --done filled.xlsx --diagnose -k 3 --test-cost 4", 0,
           "Diagnosis of 2 tests: 1 passed, 1 failed"},
          {"$changeover plan parts.csv --done filled.xlsx -o more.xlsx" + rest +
               " && $changeover plan parts.csv --done more.xlsx --done-first 1 --json" + rest,
           0, "\"tests_done\":1"}},
         folder);
}

TEST(PlanWorkbook, SaysInOneLineWhatIsWrong) {
  const TemporaryFolder folder;
  spit(folder.file("parts.csv"), "part,cost\nA,2\nB,1\nC,3\n");
  spit(folder.file("good.xlsx"),
       zipped(workbook_of({{"Costs",
                            "<row><c t='str'><v>part</v></c></row><row><c t='e'><v>#REF!"
                            "</v></c></row>"}})));
  spit(folder.file("old.xls"), "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1");
  spit(folder.file("cut.xlsx"), "PK\x03\x04");
  const std::string rest = " -k 2 --test-cost 1 --change-cost 1" + fast;
  expect(
      {{"$changeover plan good.xlsx" + rest, 3, "good.xlsx:Costs!A2: the formula here results in"},
       {"$changeover plan good.xlsx:Prices" + rest, 3, "there is no sheet 'Prices'"},
       {"$changeover plan parts.csv:Costs" + rest, 3, "parts.csv: not a workbook"},
       {"$changeover plan none.xlsx:Costs" + rest, 4, "none.xlsx:Costs"},
       {"$changeover plan old.xls" + rest, 3, "old.xls: an old workbook (.xls)"},
       {"$changeover plan cut.xlsx" + rest, 3, "cut.xlsx: looks like a zip archive"},
       {"$changeover plan - < old.xls" + rest, 3, "<stdin>: an old workbook"},
       {"$changeover plan good.xlsx:Costs -o good.xlsx" + rest, 2, "is the same file as the parts"},
       {"$changeover plan parts.csv --what-if -o w.xlsx" + rest, 2,
        "--what-if has no meaning with a file named .xlsx"},
       {"$changeover plan parts.csv --format xlsx -o /dev/full" + rest, 4, "/dev/full"},
       {"TMPDIR=/nowhere $changeover plan parts.csv -o a.csv" + rest + " && head -c 4 a.csv", 0,
        "step"}},
      folder);
  EXPECT_EQ(run("ls *.tmp *.changeover* 2>/dev/null | wc -l", folder.path()).out, "0\n");
}

}  // namespace
}  // namespace changeover::test::plan_workbook_test
