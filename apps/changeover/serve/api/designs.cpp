// Designs: to look at, to take away, to cite.
#include <fmt/format.h>

#include <map>

#include "answer/catalog/entry_words.hpp"
#include "answer/dossier/dossier.hpp"
#include "changeover/catalog/entry.hpp"
#include "serve/api/request/query.hpp"
#include "serve/api/request/selection.hpp"
#include "serve/api/routes.hpp"

namespace changeover::serve {
namespace {

const std::vector<std::string>& download_formats() {
  static const std::vector<std::string> formats = [] {
    std::vector<std::string> all = cli::design_formats();
    std::erase(all, "table");
    return all;
  }();
  return formats;
}

std::string type_of(const std::string& format) {
  static const std::map<std::string, std::string> types{
      {"json", "application/json; charset=utf-8"},
      {"csv", "text/csv; charset=utf-8"},
      {"svg", "image/svg+xml"},
      {"designtheory", "application/xml; charset=utf-8"}};
  const auto found = types.find(format);
  return found == types.end() ? "text/plain; charset=utf-8" : found->second;
}

Response download(Explorer& explorer, const Request& request) {
  const std::string format = word_of(request, "format", download_formats());
  const Selection selection = selected(explorer, request);
  const cli::ChosenDesign& chosen = selection.chosen;
  const Parameters& p = chosen.source->parameters();
  if (const auto defect = cli::format_defect(p, chosen.offer.b, format)) {
    throw Refusal{413, *defect};
  }
  StringSink sink;
  cli::write_design(*chosen.source, chosen.exhibit, format, sink);
  Response response = text_response(sink.take(), type_of(format));
  response.headers.emplace_back(
      "Content-Disposition",
      fmt::format("attachment; filename=\"{}.{}.{}\"", cell_label(p), chosen.offer.b, format));
  return response;
}

// One design for a paper. Files and searches have no dossier: what is said rests on the catalog and
// on constructions.
Response dossier(Explorer& explorer, const Request& request) {
  static const std::map<std::string, std::string> types{
      {"html", "text/html; charset=utf-8"},
      {"json", "application/json; charset=utf-8"},
      {"latex", "application/x-tex; charset=utf-8"},
      {"markdown", "text/markdown; charset=utf-8"}};
  const std::string format = word_of(request, "format", {"html", "json", "latex", "markdown"});
  Selection selection = selected(explorer, request);
  const Parameters p = selection.chosen.source->parameters();
  const std::uint64_t b = selection.chosen.offer.b;
  const auto entry =
      selection.label.empty() ? std::nullopt : explorer.catalog.find(selection.label);
  const cli::Dossier made = cli::dossier_of(entry ? cli::built(*entry) : selection.chosen, entry);
  Response response = text_response(format == "html"    ? cli::dossier_html(made, "../")
                                    : format == "json"  ? cli::dossier_json(made) + "\n"
                                    : format == "latex" ? cli::dossier_latex(made)
                                                        : cli::dossier_markdown(made),
                                    types.at(format));
  if (format == "html") {
    response.headers.emplace_back("Content-Security-Policy",
                                  content_policy(*response.body) + "; frame-ancestors 'none'");
  }
  if (format == "latex" || format == "markdown") {
    response.headers.emplace_back("Content-Disposition",
                                  fmt::format("attachment; filename=\"dossier.{}.{}.{}\"",
                                              cell_label(p), b, format == "latex" ? "tex" : "md"));
  }
  return response;
}

Response cite(const Explorer& explorer, const Request& request) {
  constexpr const char* text = "text/plain; charset=utf-8";
  const auto label = request.parameter("label");
  if (!label) {
    return text_response(cli::bibtex_of(explorer.catalog), text);
  }
  return text_response(cli::bibtex_of(entry_of(explorer, *label)), text);
}

}  // namespace

void add_designs(Router& router, Explorer& explorer) {
  const auto lane = [](const Request& request) {
    return is_quick(request) ? Lane::quick : Lane::slow;
  };
  // A search can find something better meanwhile, so answers made from jobs are made again.
  const auto add = [&](const std::string& path, std::vector<std::string> parameters,
                       std::function<Response(const Request&)> answer) {
    Route route;
    route.path = path;
    route.parameters = std::move(parameters);
    route.lane = lane;
    route.answer = [&explorer, answer = std::move(answer)](const Request& request) {
      const Again again = request.parameter("job") ? Again::made_anew : Again::while_unchanged;
      return answered(explorer, request, again, [&] { return answer(request); });
    };
    router.add(std::move(route));
  };
  add("api/design", selectors(), [&explorer](const Request& request) {
    return json_response(design_json(selected(explorer, request)));
  });
  std::vector<std::string> with_format = selectors();
  with_format.emplace_back("format");
  add("api/download", with_format,
      [&explorer](const Request& request) { return download(explorer, request); });
  add("api/dossier", {"v", "k", "change", "kind", "strength", "label", "format"},
      [&explorer](const Request& request) { return dossier(explorer, request); });
  Route cites = question(explorer, "api/cite", {"label"}, Again::while_unchanged,
                         [&explorer](const Request& request) { return cite(explorer, request); });
  cites.lane = [](const Request& request) {
    return request.parameter("label") ? Lane::quick : Lane::slow;
  };
  router.add(std::move(cites));
}

}  // namespace changeover::serve
