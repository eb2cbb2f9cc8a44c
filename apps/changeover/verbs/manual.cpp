// changeover manual [VERB]: manual pages.
#include "shell/manual.hpp"
#include "core/each.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "answer/answer.hpp"
#include "cli/spelling.hpp"
#include "core/words.hpp"
#include "io/file/remedies.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct ManualRequest {
  const Program* program = nullptr;
  std::vector<std::string> verb;  // none: the program's own page
  std::string into;
  OutputRequest output;
};

Answer written_into(const std::string& folder, const std::vector<ManualPage>& pages) {
  make_folder(folder);
  for (const ManualPage& page : pages) {
    write_file((std::filesystem::path(folder) / (page.name + ".1")).string(),
               [&page](OutputFile& out) { out.write(page.text); });
  }
  return text_answer(fmt::format("{} are in {}\n", count_of(pages.size(), "page"), folder), {});
}

Answer run(const ManualRequest& request) {
  const std::vector<ManualPage> pages = manual_pages(*request.program);
  if (!request.into.empty()) {
    return written_into(request.into, pages);
  }
  std::string name = "changeover";
  for (const std::string& word : request.verb) {
    name += "-" + word;
  }
  const auto found = std::ranges::find(pages, name, &ManualPage::name);
  if (found == pages.end()) {
    const std::vector<std::string> known = each_of<std::string>(pages, &ManualPage::name);
    throw UsageError{"there is no page " + name + did_you_mean(name, known)};
  }
  return text_answer(found->text, request.output);
}

}  // namespace

void add_manual(Program& program) {
  auto [verb, request] =
      program.add<ManualRequest>("manual", "print the manual page of a verb, for man", run);
  request.program = &program;
  verb.positional("VERB", request.verb,
                  "name of the verb, such as design or catalog show (default: the program's page)",
                  false);
  verb.option("--into", request.into, "DIR", "write every page into DIR");
  request.output.add_file_to(verb, {".1", ".man", ".txt"});
  verb.exclude({"--into", "--output"});
  verb.exclude({"--into", "VERB"});
  verb.examples({"changeover manual design | man -l -", "changeover manual catalog show -o show.1",
                 "changeover manual --into share/man/man1"});
}

}  // namespace changeover::cli
