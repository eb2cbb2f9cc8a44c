// changeover paper: every table, theorem and corollary of the source paper, rebuilt and compared.

#include <filesystem>

#include "answer/answer.hpp"
#include "io/file/remedies.hpp"
#include "paper/report.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct PaperRequest {
  OutputRequest output;
  std::string figures;
};

void write_figures(const std::string& folder) {
  make_folder(folder);
  for (const auto& [name, content] : paper_figures()) {
    write_file(std::filesystem::path(folder) / name,
               [&text = content](OutputFile& out) { out.write(text); });
  }
}

Answer run(const PaperRequest& request) {
  const PaperReport report = run_paper_report(Registry::standard());
  if (!request.figures.empty()) {
    write_figures(request.figures);
  }
  return text_answer(request.output.json()                   ? render_json(report)
                     : request.output.format() == "markdown" ? render_markdown(report)
                                                             : render_text(report),
                     request.output);
}

}  // namespace

void add_paper(Program& program) {
  auto [verb, request] = program.add<PaperRequest>(
      "paper", "rebuild the source paper and compare it cell by cell", run);
  verb.option("--figures", request.figures, "DIR", "write its figures there too, as SVG and TikZ");
  request.output.add_to(verb, {"text", "markdown", "json"});
  verb.examples({"changeover paper", "changeover paper --format markdown -o paper.md",
                 "changeover paper --figures figures"});
}

}  // namespace changeover::cli
