#include <fmt/format.h>

#include <algorithm>

#include "answer/dossier/dossier_form.hpp"
#include "answer/dossier/dossier_math.hpp"
#include "answer/dossier/dossier_setting.hpp"
#include "changeover/core/version.hpp"
#include "construct/references.hpp"
#include "core/words.hpp"
#include "io/table/table.hpp"
#include "io/write/latex_prose.hpp"

namespace changeover::cli {
namespace {

constexpr std::string_view style = R"(
  @page { margin: 18mm 16mm; }
  body { margin: 2rem auto; max-width: 48rem; padding: 0 1rem; color: #111; background: #fff;
         font: 16px/1.5 "Helvetica Neue", Helvetica, Arial, "Liberation Sans", sans-serif; }
  h1 { font-size: 1.7rem; margin: 0 0 .5rem; }
  h2 { font-size: 1.2rem; margin: 2rem 0 .5rem; }
  h3 { font-size: 1rem; margin: 1.2rem 0 .3rem; }
  pre { overflow-x: auto; padding: .6rem .8rem; background: #f3f4f5; font-size: .85rem;
        white-space: pre-wrap; overflow-wrap: anywhere; }
  code { font-size: .88em; background: #f3f4f5; padding: .05em .25em; border-radius: .2em; }
  nav { font-size: .9rem; margin: .5rem 0 1rem; }
  nav a { margin-right: 1em; white-space: nowrap; }
  .facts { display: grid; grid-template-columns: repeat(auto-fill, minmax(10.5rem, 1fr));
           gap: .5rem 1.2rem; margin: 1rem 0; padding: .7rem .9rem; border: 1px solid #ccd0d4;
           border-radius: .3rem; }
  .facts .wide { grid-column: 1 / -1; }
  @media (min-width: 34rem) { .facts .double { grid-column: span 2; } }
  .facts dt { font-size: .85rem; color: #555; }
  .facts dd { margin: 0; overflow-wrap: anywhere; }
  .blocks { white-space: pre; counter-reset: block; line-height: 1.45; }
  .blocks span { display: block; counter-increment: block; break-inside: avoid; }
  .blocks span::before { content: counter(block); display: inline-block; width: 3.5ch;
                         margin-right: 2ch; text-align: right; color: #777; }
  .formula { padding-left: 2rem; }
  .theorem { border-left: 3px solid #ccd0d4; padding-left: 1rem; break-inside: avoid; }
  a { color: #0b57a4; }
  :is(p, li, dd, code) > span { white-space: nowrap; }
  li { margin: .25rem 0; overflow-wrap: break-word; }
  figure { margin: 1.5rem 0; text-align: center; break-inside: avoid; }
  figure svg { max-width: 100%; height: auto; }
  .picture.dark { display: none; }
  math { font-family: "Cambria Math", "STIX Two Math", "Latin Modern Math",
                      "DejaVu Math TeX Gyre", math; line-height: normal; }
  figcaption { font-size: .9rem; }
  @media print {
    body { margin: 0; max-width: none; font-size: 10pt; } nav { display: none; }
    h2, h3 { break-after: avoid; } pre, code { background: none; } pre { padding: 0; }
    .facts { grid-template-columns: repeat(4, 1fr); margin: .5rem 0; } pre { font-size: .8em; }
    .facts .double { grid-column: span 2; } h2 { margin-top: 1rem; }
    .blocks { display: grid; columns: auto; } }
  @media (prefers-color-scheme: dark) { @media screen {
    body { color: #e8e8e8; background: #16181a; } pre, code { background: #24272a; }
    .facts, .theorem { border-color: #444a50; } .facts dt { color: #a9b0b6; }
    .blocks span::before { color: #8b939a; }
    a { color: #8ec1ff; }
    .picture { display: none; } .picture.dark { display: block; } } }
)";

class Html final : public Form {
 public:
  Html(const Dossier& dossier, std::string_view explorer)
      : keys_(dossier.keys), explorer_(explorer) {}

  void heading(const std::string& words) override {
    std::string id = words;
    std::ranges::transform(id, id.begin(), [](char c) { return c == ' ' ? '-' : c; });
    text += fmt::format("<h2 id=\"{}\">{}</h2>\n", html_text(id), html_text(words));
    contents_ += fmt::format("<a href=\"#{}\">{}</a> ", html_text(id), html_text(words));
  }
  void paragraph(const std::string& words) override {
    text += fmt::format("<p>{}</p>\n", prose(words));
  }
  void facts(const std::vector<DossierFact>& rows) override {
    constexpr std::size_t short_value = 30;
    facts_at_ = text.size();
    text += "<dl class=\"facts\">\n";
    for (const DossierFact& row : rows) {
      const bool is_label = row.name == "catalog label";
      text += fmt::format("<div{}><dt>{}</dt><dd>{}</dd></div>\n",
                          row.value.size() > short_value ? " class=\"wide\""
                          : is_label                     ? " class=\"double\""
                                                         : "",
                          html_prose(row.name), prose(row.value));
    }
    text += "</dl>\n";
  }
  void item(std::size_t depth, const std::string& words) override {
    open_to(depth + 1);
    text += fmt::format("<li>{}\n", prose(words));
  }
  void end_of_items() override { open_to(0); }
  void code(const std::string& lines) override {
    text += fmt::format("<pre>{}</pre>\n", html_text(lines));
  }
  // Numbers are beside the text: who copies the blocks has the blocks.
  void blocks(const Dossier& dossier) override {
    const Design& design = *dossier.design;
    std::size_t width = 1;
    for (std::uint64_t x = 0; x < design.parameters().v; ++x) {
      width = std::max(width, display_width(design.label(static_cast<Element>(x))));
    }
    const bool circular = design.parameters().kind == Kind::circular && design.block_count() > 1;
    text += "<p>What a block introduces is bold.</p>\n<pre class=\"blocks\">";
    for (std::uint64_t i = 0; i < design.block_count(); ++i) {
      const auto before = i > 0      ? design.block(i - 1)
                          : circular ? design.block(design.block_count() - 1)
                                     : design.block(i);
      std::string line;
      for (const Element x : design.block(i)) {
        const std::string label = design.label(x);
        const std::string padding(width - display_width(label), ' ');
        const bool introduced = std::ranges::find(before, x) == before.end();
        line += (line.empty() ? "" : " ") + padding +
                fmt::format(fmt::runtime(introduced ? "<b>{}</b>" : "{}"), html_text(label));
      }
      text += fmt::format("<span>{}\n</span>", line);
    }
    text += "</pre>\n";
    columns_ = fmt::format(
        "  .blocks {{ column-width: {0}ch; }}\n"
        "  @media print {{ .blocks {{ grid-template-columns: "
        "repeat(auto-fill, minmax({0}ch, 1fr)); }} }}\n",
        design.parameters().k * (width + 1) + 8);
  }
  void picture(const Dossier& dossier) override {
    text += fmt::format(
        "<figure>\n<div class=\"picture\">{}</div>\n<div class=\"picture dark\">{}</div>\n"
        "<figcaption>{}</figcaption>\n</figure>\n",
        svg(*dossier.picture, Theme::light), svg(*dossier.picture, Theme::dark),
        html_text(dossier.picture_says));
  }
  void theorems(const Dossier& dossier) override {
    heading("Theorems used");
    paragraph(
        fmt::format("As Changeover {} has them. Their proofs, and what the signs mean, are on the "
                    "page Theorems of its explorer, which `changeover serve` opens.",
                    version));
    for (const QuotedTheorem& theorem : dossier.theorems) {
      const std::string name = "Theorem " + theorem.number;
      const std::string linked = explorer_.empty()
                                     ? name
                                     : fmt::format("<a href=\"{}#/theorems?theorem={}\">{}</a>",
                                                   explorer_, theorem.number, name);
      text += fmt::format(
          "<section class=\"theorem\" id=\"theorem-{}\">\n<h3>{}: {}</h3>\n{}"
          "</section>\n",
          theorem.number, linked, prose(theorem.title),
          statement_html(theorem.statement,
                         [&](std::string_view words) { return with_indices(words); }));
    }
  }
  void references(const Dossier& dossier) override {
    const bool works = !keys_.empty() || !dossier.theorems.empty();
    heading(works ? "References" : "Citation");
    text += works ? "<ul>\n" : "";
    for (const std::string& key : keys_) {
      const Work& work = *find_work(key);
      text += fmt::format("<li id=\"{}\">{}", html_text(key), html_text(work.text));
      if (!work.url.empty()) {
        text += fmt::format(". <a href=\"{0}\">{0}</a>", html_text(work.url));
      }
      text += "\n";
    }
    if (!dossier.theorems.empty()) {
      text += fmt::format(
          "<li>The Changeover developers. Theorems of Changeover {}, with proofs: the page "
          "Theorems of its explorer, <code>changeover serve</code>\n",
          version);
    }
    text += works ? "</ul>\n" : "";
    text += fmt::format("<h3>BibTeX of this design{}</h3>\n", works ? " and of these works" : "");
    code(dossier.bibtex);
  }

  /// What is known elsewhere, the contents, and all that was said.
  [[nodiscard]] std::string page(const std::string& back) const {
    return back + text.substr(0, facts_at_) + "<nav>" + contents_ + "</nav>\n" +
           text.substr(facts_at_);
  }
  [[nodiscard]] std::string columns() const { return columns_; }

  std::string text;

 private:
  // Works by their authors, linked to the references; theorems of the program, linked to what they
  // say; commands as code; formulas not broken.
  [[nodiscard]] std::string prose(std::string_view words) const {
    std::string html;
    for (const auto& [piece, code] : pieces_of(words)) {
      html +=
          code ? fmt::format("<code>{}</code>", unbroken_code(html_text(piece))) : sentence(piece);
    }
    return html;
  }

  // Statements have formulas as indices, "U_{i−1}".
  [[nodiscard]] std::string with_indices(std::string_view words) const {
    const std::size_t open = words.find("_{");
    const std::size_t close = open == std::string_view::npos ? open : words.find('}', open);
    return close == std::string_view::npos
               ? prose(words)
               : prose(words.substr(0, open)) + "<sub>" +
                     html_prose(words.substr(open + 2, close - open - 2)) + "</sub>" +
                     with_indices(words.substr(close + 1));
  }

  [[nodiscard]] std::string sentence(std::string_view words) const {
    std::string html;
    std::size_t done = 0;
    const auto put = [&](std::size_t at, std::size_t length, const std::string& instead) {
      html += with_mathml(unbroken(html_prose(words.substr(done, at - done)))) + instead;
      done = at + length;
    };
    for (std::size_t at = words.find('['); at < words.size(); at = words.find('[', at + 1)) {
      const std::size_t end = std::min(words.find_first_of(",]", at), words.size());
      const std::string key(words.substr(at + 1, end - at - 1));
      if (std::ranges::find(keys_, key) != keys_.end()) {
        put(at + 1, key.size(), fmt::format("<a href=\"#{}\">{}</a>", key, shown_work(key)));
      } else if (key == own_key) {
        const std::size_t close = std::min(words.find(']', at), words.size());
        put(at + 1, close - at - 1, own_theorem(words.substr(at + 1, close - at - 1)));
      }
    }
    put(words.size(), 0, "");
    return html;
  }

  // "ChangeoverTheorems, Theorem 5", or without a number.
  static std::string own_theorem(std::string_view place) {
    const std::size_t digit = place.find_first_of("0123456789");
    return digit == std::string_view::npos
               ? "Theorems of Changeover"
               : fmt::format("<a href=\"#theorem-{0}\">Theorem {0} of Changeover</a>",
                             place.substr(digit));
  }

  static std::string shown_work(const std::string& key) {
    const Work* const work = find_work(key);
    return html_text(work == nullptr ? key : work->name);
  }

  void open_to(std::size_t depth) {
    for (; open_ < depth; ++open_) {
      text += "<ul>\n";
    }
    for (; open_ > depth; --open_) {
      text += "</ul>\n";
    }
  }

  std::vector<std::string> keys_;
  std::string_view explorer_;
  std::string contents_;
  std::string columns_;
  std::size_t facts_at_ = 0;
  std::size_t open_ = 0;
};

}  // namespace

std::string dossier_html(const Dossier& dossier, std::string_view explorer) {
  Html form(dossier, explorer);
  write(dossier, form);
  std::string back;
  if (!explorer.empty()) {
    const Parameters& cell = dossier.parameters;
    back = fmt::format(
        "<p><a href=\"{}#/cell?v={}&amp;k={}&amp;change={}&amp;kind={}{}\">What else is known of "
        "these parameters</a></p>\n",
        explorer, cell.v, cell.k, cell.change, to_string(cell.kind),
        cell.strength == 2 ? "" : fmt::format("&amp;strength={}", cell.strength));
  }
  return html_page("A " + title_of(dossier), std::string(style) + form.columns(), form.page(back));
}

}  // namespace changeover::cli
