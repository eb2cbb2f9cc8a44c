// The journal of a job, from any bytes, as they are and with the checksums of its lines made right:
// what counts was a step of the job, reading changes nothing, and what is recorded afterwards is
// read.
#include "loadorder/run/journal.hpp"

#include "support/chain.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::journal_fuzz {
namespace {

constexpr std::uint64_t steps = 20;

bool same(const JournalRecord& a, const JournalRecord& b) {
  return a.step == b.step && a.results == b.results;
}

void open(const Scratch& scratch, const std::string& bytes) {
  const std::vector<JournalField> job{{"job", "sums"}, {"items", "10"}};
  scratch.empty();
  scratch.put("journal", bytes);
  const std::string path = scratch.file("journal");
  std::vector<JournalRecord> records;
  const JournalRecord more{.step = 7, .results = sha256("x")};
  const bool accepted = accepts([&] {
    Journal journal(path, job, steps);
    must(scratch.bytes("journal") == bytes, "reading a journal changes nothing in it");
    records = journal.records();
    for (const JournalRecord& record : records) {
      must(record.step >= 1 && record.step <= steps, "only steps of the job are recorded");
    }
    must(journal.note().empty() || is_one_plain_line(journal.note()), "a note is one line");
    journal.begin();
    journal.record(more);
  });
  if (!accepted) {
    must(scratch.bytes("journal") == bytes, "what is refused is not touched");
    return;
  }
  records.push_back(more);
  const Journal again(path, job, steps);
  must(again.note().empty() && std::ranges::equal(again.records(), records, same),
       "what was recorded is read");
}

const Target target("journal", [](const std::string& bytes) {
  static const Scratch scratch;
  open(scratch, bytes);
  open(scratch, with_right_chain(bytes));
});

}  // namespace
}  // namespace changeover::fuzz::journal_fuzz
