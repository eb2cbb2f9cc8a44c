// Fields of lists whose meaning is certain although they are not written as the manual does, and
// those that only look so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "changeover/io/input.hpp"
#include "changeover/plan/job.hpp"
#include "core/spelling.hpp"
#include "message_of.hpp"
#include "plan/job/bench_list.hpp"

namespace changeover::meant_fields_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> parts{"H100", "CX-7", "PSU 800", "PSU 1600", "DIMM A"};

std::vector<Bench> benches(const std::string& text, std::vector<std::string>* notes = nullptr,
                           std::vector<std::string>* gone = nullptr) {
  return read_benches(*input_from_text(text, "b.csv"), parts, gone, notes);
}

TEST(MeantFields, OfBenches) {
  std::vector<std::string> notes;
  const std::vector<Bench> read =
      benches("bench,Location,hours,without\nNorth,R1,8 h,H100; CX-7\nSouth,R2,7.5 hrs,\n", &notes);
  EXPECT_EQ(read[0].without, (Block{0, 1}));
  EXPECT_EQ(read[0].hours, parse_amount("8"));
  EXPECT_EQ(read[1].hours, parse_amount("7.5"));
  EXPECT_THAT(notes, ElementsAre("b.csv: not used of the benches: 'Location'"));
  const auto refused = [](const std::string& text) {
    return message_of([&] { (void)benches(text); });
  };
  EXPECT_EQ(refused("bench,withuot\nNorth,H100\n"),
            "b.csv:1:7: there is no column 'withuot' of benches; did you mean without?");
  EXPECT_THAT(refused("bench,without\nNorth,H100; CX-8\n"), HasSubstr("there is no part"));
  EXPECT_EQ(refused("bench,own\nNorth,DIMM A x4\n"),
            "b.csv:2:7: there is no part 'DIMM A x4'; did you mean 'DIMM A'?");
  EXPECT_THAT(refused("bench,hours\nNorth,8 min\n"), HasSubstr("is not a number of hours"));
  // In a list that may be older, with its place.
  std::vector<std::string> gone;
  EXPECT_THAT(benches("bench,without\nNorth,A100\n", nullptr, &gone)[0].without, IsEmpty());
  EXPECT_THAT(gone, ElementsAre("A100 (b.csv:2:7)"));
}

TEST(MeantFields, OfPairs) {
  const auto refused = [](const std::string& text) {
    return message_of([&] { (void)read_pairs(*input_from_text(text, "n.csv"), parts); });
  };
  EXPECT_EQ(refused("H-100,PSU 800\n"),
            "n.csv:1:1: there is no part 'H-100'; did you mean 'H100'?");
  EXPECT_EQ(refused("H100,\"PSU 800, PSU 1600\"\n"),
            "n.csv:1:6: 'PSU 800, PSU 1600' is several parts; write one part per field");
  EXPECT_EQ(refused("H100,9\n"),
            "n.csv:1:6: there is no part '9'; give a name of the parts list or a number from 1 to "
            "5");
  // Another kind of blank is the same name.
  const std::vector<std::string> pasted{
      "PSU\xc2\xa0"
      "800",
      "H100"};
  EXPECT_TRUE(read_pairs(*input_from_text("H100,PSU 800\n"), pasted).contains(0, 1));
}

TEST(MeantFields, OfSlots) {
  const std::vector<Slot> slots =
      read_slots(*input_from_text("slot,quantity\nCPU,1\nDIMM,2-3\nNIC,1..2\nSSD,2..\nGPU,0–1\n"));
  EXPECT_EQ(slots[1].least, 2U);
  EXPECT_EQ(slots[1].most, 3U);
  EXPECT_EQ(slots[2].most, 2U);
  EXPECT_EQ(slots[3].most, Slot{}.most);
  EXPECT_EQ(slots[4].least, 0U);
  EXPECT_EQ(slots[4].most, 1U);
  EXPECT_EQ(
      message_of([] { (void)read_slots(*input_from_text("slot,quantity\nCPU,-1\n", "s.csv")); }),
      "s.csv:2:5: '-1' is not a number of parts; write one as 2, or a range as 2..4");
  EXPECT_THAT(
      message_of([] { (void)read_slots(*input_from_text("slot,quantity\nCPU,3-2\n", "s.csv")); }),
      HasSubstr("write the least first"));
  Job job = make_job(2, 2, parse_amount("1"), parse_amount("1"));
  set_slots(job, {"nic", "NIC"}, {{"NIC", 1, 2}});
  EXPECT_EQ(job.slot_of, (std::vector<std::uint32_t>{0, 0}));
  EXPECT_THAT(message_of([&] {
                set_slots(job, {"Nic", "NIC"}, {{"NIC", 1, 2}, {"nic", 1, 2}});
              }),
              HasSubstr("has no limits"));
  EXPECT_THAT(message_of([&] {
                set_slots(job, {"NICs", ""}, {{"NIC", 1, 2}});
              }),
              HasSubstr("did you mean 'NIC'?"));
}

TEST(MeantFields, OfParts) {
  const auto read = [](const std::string& text, bool costs_may_lack = false) {
    PartListOptions options;
    options.costs_may_lack = costs_may_lack;
    return read_parts(*input_from_text(text, "p.csv"), options);
  };
  const std::string head = "part,slot,cost,qty\n";
  const PartList list = read(head + "A,CPU,1,1 pcs\nB,-,2,4 x\nC,CPU,3,-\n");
  EXPECT_THAT(list.quantities, ElementsAre(1, 4, 1));
  EXPECT_THAT(list.slots, ElementsAre("CPU", "", "CPU"));
  EXPECT_EQ(message_of([&] { (void)read(head + "A,CPU,n/a,1\n"); }),
            "p.csv:2:7: 'n/a' is not a cost; write a number, such as 12 or 12.50");
  EXPECT_EQ(read(head + "A,CPU,n/a,1\n", true).change_costs.front(), std::nullopt);
  EXPECT_THAT(message_of([&] { (void)read(head + "A,CPU,1,4 boxes\n"); }),
              HasSubstr("'4 boxes' is not a number of pieces"));
}

TEST(MeantFields, AFootnoteIsNoPart) {
  const auto refused = [](const std::string& text) {
    return message_of([&] { (void)read_parts(*input_from_text(text, "p.csv")); });
  };
  EXPECT_EQ(refused("part,cost\nA,1\nB,2\n\nStand: 1.3.2025\n"),
            "p.csv:5:1: 'Stand: 1.3.2025' stands alone below an empty line and may be a footnote "
            "or a part; remove it, or the empty line");
  EXPECT_THAT(refused("part,cost\nA,1\nB,2\n,\nStand\nC,3\n"), HasSubstr("stands alone"));
  EXPECT_EQ(refused("part,cost\nA,1\nB,2\nC\n"), "") << "no empty line";
  EXPECT_EQ(refused("part,cost\nA,1\nB,2\n# more\nC\n"), "") << "a comment is no empty line";
  EXPECT_EQ(refused("part,cost\nA,1\nB\n\nC\n"), "") << "others have no cost either";
  EXPECT_EQ(refused("part,cost\nA,1\n\nB,2\n"), "");
}

TEST(MeantFields, TruthIsAResult) {
  for (const char* pass : {"TRUE", "true", "WAHR", "VRAI"}) {
    EXPECT_EQ(result_of(pass), TestResult::pass) << pass;
  }
  for (const char* fail : {"FALSE", "FALSCH", "FAUX"}) {
    EXPECT_EQ(result_of(fail), TestResult::fail) << fail;
  }
  EXPECT_EQ(result_of("true enough"), TestResult::unread);
}

TEST(MeantFields, TheNearestWordIsNear) {
  EXPECT_EQ(nearest_word("H-100", parts), "H100");
  EXPECT_EQ(nearest_word("PSU 8oo", parts), "PSU 800");
  EXPECT_EQ(nearest_word("Valve", parts), std::nullopt);
  EXPECT_EQ(nearest_word(std::string(41, 'x'), {std::string(41, 'x')}), std::nullopt);
}

}  // namespace
}  // namespace changeover::meant_fields_test
