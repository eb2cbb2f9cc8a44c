// The checkpoint of a search, from any bytes, as they are and with the checksum made right. Its
// first line here says which parameters are searched: "v k m kind". What is accepted is written and
// read as it was, and leads to a design that is one.
#include <sstream>

#include "changeover/io/formats.hpp"
#include "changeover/search/local_search.hpp"
#include "changeover/verify/verdict.hpp"
#include "search/local/checkpoint.hpp"
#include "support/chain.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::checkpoint_fuzz {
namespace {

const Scratch& scratch() {
  static const Scratch folder;
  return folder;
}

void go_on(const Parameters& p, const std::string& bytes) {
  const std::string path = scratch().file("state");
  RunControl control({.time = std::chrono::milliseconds(200)});
  ImproveResult result;
  const bool accepted =
      accepts([&] { result = improve(p, {.moves = 300, .checkpoint = path}, control); });
  if (!accepted) {
    must(scratch().bytes("state") == bytes, "a checkpoint that is refused is not touched");
    return;
  }
  if (result.design) {
    must(verify(result.design->design()).valid() && result.design->parameters() == p,
         "a checkpoint leads to a design");
  }
  must(is_plain(result.how) && is_plain(result.checkpoint_fault), "what is said is plain text");
}

void open(const Parameters& p, const std::string& bytes) {
  scratch().empty();
  scratch().put("state", bytes);
  std::optional<Checkpoint> read;
  if (accepts([&] { read = read_checkpoint(scratch().file("state"), p); })) {
    must(read.has_value(), "a file that is there is read");
    write_checkpoint(*read, scratch().file("again"));
    const auto again = read_checkpoint(scratch().file("again"), p);
    must(again && again->seed == read->seed && again->attempts == read->attempts &&
             again->moves == read->moves && again->arms == read->arms && again->how == read->how &&
             again->best.has_value() == read->best.has_value(),
         "a checkpoint is read as it was written");
    must(!read->best || (again->best->blocks() == read->best->blocks() &&
                         verify(read->best->design()).valid()),
         "the best design of a checkpoint is one");
  }
  go_on(p, bytes);
}

const Target target("checkpoint", [](const std::string& bytes) {
  const std::size_t end = bytes.find('\n');
  if (end == std::string::npos) {
    return;
  }
  std::istringstream words(bytes.substr(0, end));
  Parameters p;
  std::string kind;
  words >> p.v >> p.k >> p.change >> kind;
  p.kind = kind_from_string(kind).value_or(Kind::linear);
  if (!words || p.v > 16 || p.k > 6 || !accepts([&] { check(p); })) {
    return;
  }
  open(p, bytes.substr(end + 1));
  open(p, with_right_check(bytes.substr(end + 1)));
});

}  // namespace
}  // namespace changeover::fuzz::checkpoint_fuzz
