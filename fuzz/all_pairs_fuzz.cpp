// A job of all pairs that finds a journal and results of another program: first the journal, then
// the
// bytes of the results. Whatever these are, a job that ends well has the right results.
#include <cstring>
#include <vector>

#include "changeover/loadorder/all_pairs.hpp"
#include "support/chain.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::all_pairs_fuzz {
namespace {

constexpr std::uint64_t items = 6;
constexpr std::uint64_t room = 3;

std::uint64_t result_of(Element x, Element y) { return 1000003U * (x + 1) + 17U * (y + 1); }

// One number a pair, at its place in a square.
class Numbers final : public JobResults {
 public:
  explicit Numbers(std::string path) : file_(std::move(path)) {}

  [[nodiscard]] std::string describe() const override { return "numbers"; }
  void open(const ResultsClaim& claim) override {
    file_.open(items * items * sizeof(std::uint64_t), claim);
  }
  Checksum checksum(const StepPairs& done) override {
    Sha256 hash;
    for (const auto& [x, y] : done.pairs) {
      std::uint64_t number = 0;
      file_.read(&number, sizeof number, place(x, y));
      hash.add(std::to_string(number) + ";");
    }
    return hash.finish();
  }
  void sync() override { file_.sync(); }
  void put(Element x, Element y) const {
    const std::uint64_t number = result_of(x, y);
    file_.write(&number, sizeof number, place(x, y));
  }

 private:
  static std::uint64_t place(Element x, Element y) {
    return (x * items + y) * sizeof(std::uint64_t);
  }
  ResultFile file_;
};

AllPairsReport run(const Scratch& scratch) {
  CallbackItems source(
      items, 8,
      [](Element item, std::span<std::byte> buffer) {
        std::memset(buffer.data(), static_cast<int>(item), buffer.size());
        return buffer.size();
      },
      "items", "1");
  static const LoadOrder order = plan_load_order(items, room);
  Numbers numbers(scratch.file("results"));
  return all_pairs(source, order,
                   [&](const PairWork& pair) { numbers.put(pair.first.item, pair.second.item); },
                   {.journal = scratch.file("journal"), .results = &numbers, .job = "fuzz"});
}

void expect_right(const Scratch& scratch) {
  const std::string bytes = scratch.bytes("results").value_or("");
  must(bytes.size() == items * items * sizeof(std::uint64_t), "results have their size");
  for (Element x = 0; x < items; ++x) {
    for (Element y = x + 1; y < items; ++y) {
      std::uint64_t number = 0;
      std::memcpy(&number, bytes.data() + (x * items + y) * sizeof number, sizeof number);
      must(number == result_of(x, y), "a job that ends well has the right results");
    }
  }
}

void go_on(const std::string& journal, const std::string& results) {
  static const Scratch scratch;
  scratch.empty();
  scratch.put("journal", journal);
  scratch.put("results", results);
  AllPairsReport report;
  if (!accepts([&] { report = run(scratch); })) {
    must(scratch.bytes("journal") == journal && scratch.bytes("results") == results,
         "what is refused is not touched");
    return;
  }
  must(report.finished && report.steps_done == report.steps, "a job ends");
  must(report.note.empty() || is_one_plain_line(report.note), "a note is one line");
  expect_right(scratch);
}

const Target target("all_pairs", [](const std::string& bytes) {
  const std::vector<std::string> parts = parts_of(bytes, 2);
  go_on(parts[0], parts[1]);
  go_on(with_right_chain(parts[0]), parts[1]);
});

}  // namespace
}  // namespace changeover::fuzz::all_pairs_fuzz
