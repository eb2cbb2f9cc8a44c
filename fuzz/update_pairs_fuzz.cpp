// A job that changes its items and finds the journal and the second file of items of another
// program:
// journal, data, second file. A journal names the data's path, which is DATA here. What is refused
// has changed nothing; a job that ends well from the beginning has done what it does on good days.
#include <cstring>
#include <optional>

#include "changeover/loadorder/all_pairs.hpp"
#include "support/chain.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::update_pairs_fuzz {
namespace {

constexpr std::uint64_t items = 12;
constexpr std::uint64_t item_bytes = 8;

UpdateReport run(const Scratch& scratch) {
  static const LoadOrder order = plan_disjoint_order(items, 4, 2);
  UpdateOptions options{
      .data = scratch.file("data"), .item_bytes = item_bytes, .journal = scratch.file("journal")};
  options.checkpoint_every = 1;
  return update_pairs(
      order,
      [](const PairUpdate& pair) {
        for (std::size_t i = 0; i < item_bytes; ++i) {
          auto& a = pair.first.bytes[i];
          auto& b = pair.second.bytes[i];
          const auto sum = static_cast<unsigned>(a) * 3U + static_cast<unsigned>(b);
          a = static_cast<std::byte>(sum & 0xffU);
          b = static_cast<std::byte>((static_cast<unsigned>(b) + sum) & 0xffU);
        }
      },
      options);
}

// What comes of data without anything of an earlier run.
std::optional<std::string> done_anew(const std::string& data) {
  static const Scratch scratch;
  scratch.empty();
  scratch.put("data", data);
  return accepts([&] { (void)run(scratch); }) ? scratch.bytes("data") : std::nullopt;
}

const Scratch& scratch() {
  static const Scratch folder;
  return folder;
}

void go_on(const std::string& journal, const std::string& data, const std::string& beside) {
  scratch().empty();
  scratch().put("data", data);
  if (!journal.empty()) {
    scratch().put("journal", journal);
  }
  if (!beside.empty()) {
    scratch().put("data.versions", beside);
  }
  UpdateReport report;
  if (!accepts([&] { report = run(scratch()); })) {
    must(scratch().bytes("data") == data, "what is refused is not touched");
    must(journal.empty() || scratch().bytes("journal") == journal, "its journal neither");
    must(beside.empty() || scratch().bytes("data.versions") == beside, "its second file neither");
    return;
  }
  must(report.finished && !scratch().bytes("data.versions"),
       "a job that ended leaves its data alone");
  must(report.note.empty() || is_one_plain_line(report.note), "a note is one line");
  must(report.steps_resumed > 0 || scratch().bytes("data") == done_anew(data),
       "a job from the beginning does what it does on good days");
}

const Target target("update_pairs", [](const std::string& bytes) {
  const std::vector<std::string> parts = parts_of(bytes, 3);
  // Data of the right size, so that what comes behind the size is tried.
  std::string data = parts[1];
  data.resize(items * item_bytes, 'x');
  std::string journal = parts[0];
  if (const std::size_t at = journal.find("'DATA'"); at != std::string::npos) {
    journal.replace(at + 1, 4, scratch().file("data"));
  }
  go_on(journal, parts[1], parts[2]);
  go_on(with_right_chain(journal), data, parts[2]);
});

}  // namespace
}  // namespace changeover::fuzz::update_pairs_fuzz
