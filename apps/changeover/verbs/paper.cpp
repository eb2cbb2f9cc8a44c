// changeover paper: every table, theorem and corollary of the source paper, rebuilt and compared.
#include <fmt/format.h>

#include <filesystem>

#include "changeover/core/error.hpp"
#include "paper/figures.hpp"
#include "paper/report.hpp"
#include "request/request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct PaperRequest {
  OutputRequest output;
  std::string figures;
};

void write_figures(const std::string& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) {
    throw MissingResource(fmt::format("cannot make the folder {}: {}", folder, failure.message()));
  }
  for (const auto& [name, content] : paper_figures()) {
    deliver(content, std::filesystem::path(folder) / name);
  }
}

int run(const PaperRequest& request) {
  const PaperReport report = run_paper_report(Registry::standard());
  const std::string format = request.output.chosen();
  if (!request.figures.empty()) {
    write_figures(request.figures);
  }
  deliver(format == "json"       ? render_json(report)
          : format == "markdown" ? render_markdown(report)
                                 : render_text(report),
          request.output);
  return exit_code::done;
}

}  // namespace

void add_paper(Program& program) {
  auto request = std::make_shared<PaperRequest>();
  Verb& verb = program.add("paper", "the source paper, rebuilt and compared cell by cell");
  verb.option("--figures", request->figures, "DIR", "write its figures there too, as SVG and TikZ");
  request->output.add_to(verb, {"text", "markdown", "json"});
  verb.examples({"changeover paper", "changeover paper --format markdown -o paper.md",
                 "changeover paper --figures figures"});
  verb.run([request] { return run(*request); });
}

}  // namespace changeover::cli
