#include <fmt/format.h>

#include <algorithm>

#include "answer/dossier/dossier.hpp"
#include "changeover/core/version.hpp"
#include "changeover/io/tables.hpp"
#include "construct/references.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "io/table/table.hpp"
#include "io/write/latex_prose.hpp"

namespace changeover::cli {
namespace {

/// What every form says, in this order; each form says how.
class Form {
 public:
  virtual ~Form() = default;
  virtual void heading(const std::string& words) = 0;
  virtual void paragraph(const std::string& words) = 0;
  /// `depth` is that of a list within lists.
  virtual void item(std::size_t depth, const std::string& words) = 0;
  virtual void end_of_items() = 0;
  virtual void code(const std::string& lines) = 0;
  virtual void blocks(const Dossier& dossier) = 0;
  virtual void picture(const Dossier& dossier) = 0;
  virtual void references(const Dossier& dossier) = 0;
};

std::string title_of(const Dossier& dossier) {
  return fmt::format("{} with {}", name(dossier.parameters), count_of(dossier.b, "block"));
}

std::string lines_of(const Design& design) {
  std::string text;
  for (std::uint64_t i = 0; i < design.block_count(); ++i) {
    const std::string line =
        joined(design.block(i), " ", [&](const Element x) { return design.label(x); });
    text += line + "\n";
  }
  return text;
}

// What the name of the design says, for readers of papers that do not.
std::string definition_of(const Dossier& dossier) {
  const Parameters& p = dossier.parameters;
  const std::string every = p.strength == 2 ? "two" : std::to_string(p.strength);
  const std::string step =
      dossier.b == 1
          ? ""
          : fmt::format(", and each block has exactly {} that are not in the block before it{}",
                        count_of(p.change, "element"),
                        p.kind == Kind::circular ? "; the first block follows the last" : "");
  return fmt::format(
      "Each block has {} of the {} elements, every {} elements are together in some block{}.", p.k,
      p.v, every, step);
}

bool mentions(const Dossier& dossier, std::string_view words) {
  const auto in = [words](const std::string& text) { return text.find(words) != text.npos; };
  return std::ranges::any_of(dossier.known.bounds,
                             [&](const Bound& bound) { return in(bound.reason); }) ||
         std::ranges::any_of(dossier.steps, [&](const RecipeStep& step) {
           return in(step.how) || in(step.citation);
         });
}

void say_bounds(const Dossier& dossier, Form& form) {
  form.heading("Lower bounds");
  const std::uint64_t least = dossier.known.bounds.front().blocks;
  form.paragraph(
      dossier.b == least
          ? fmt::format("No {} has fewer than {}; the first line proves it.",
                        name(dossier.parameters), count_of(least, "block"))
          : fmt::format("No {} has fewer than {}; whether one has fewer than {} is open.",
                        name(dossier.parameters), count_of(least, "block"), dossier.b));
  for (const Bound& bound : dossier.known.bounds) {
    form.item(0, fmt::format("b >= {} ({}): {}", bound.blocks, bound.name, bound.reason));
  }
  form.end_of_items();
  if (mentions(dossier, "i_x")) {
    form.paragraph(
        "Here i_x is the number of blocks that introduce x, r_x the number of blocks that contain "
        "x, and e_x how many pairs with x are newly covered beyond v-1, counted with repetition. A "
        "pair is newly covered in a block if the block before lacks one of the two, or both.");
  }
  if (dossier.known.reported) {
    form.paragraph(fmt::format("A publication reports fewer blocks: {}.",
                               reported_words(*dossier.known.reported)));
  }
}

void say_construction(const Dossier& dossier, Form& form) {
  form.heading("Construction");
  for (const RecipeStep& step : dossier.steps) {
    const bool cites = step.citation != "[elementary]";
    form.item(step.depth,
              fmt::format("{}. {}{}", step.design, step.how, cites ? " " + step.citation : ""));
  }
  form.end_of_items();
  if (!dossier.label.empty()) {
    form.paragraph(fmt::format("Catalog label {}. {}", dossier.label,
                               dossier.found.empty() ? "" : dossier.found + "."));
  }
  for (const std::string& key : reporters_of(dossier.parameters, dossier.b)) {
    form.paragraph(fmt::format("A design with as few blocks was reported before, in [{}].", key));
  }
  form.paragraph("SHA-256 of the blocks, one block per line:");
  form.code(to_hex(dossier.checksum) + "\n");
}

void say_how_to_check(const Dossier& dossier, Form& form) {
  form.heading("How to check it");
  form.paragraph(
      "checkdesign is a C program of one file that shares no code with the program that made the "
      "design. It prints the word valid, the parameters and the number of blocks.");
  form.code(dossier.write_command + "\ncheckdesign design.txt\n" +
            (dossier.names_elements ? "" : "grep -v \"^#\" design.txt | sha256sum\n"));
  if (!dossier.proof_commands.empty()) {
    form.paragraph(
        "That no design has fewer blocks rests on proofs by a SAT solver. The first command makes "
        "formulas and proofs in DIMACS and DRAT, and ends with exit code 10, for a design was found "
        "too. Any DRAT checker reads them; drat-trim prints s VERIFIED for each.");
    const std::string commands = joined(dossier.proof_commands, "",
                                        [&](const std::string& command) { return command + "\n"; });
    form.code(commands);
  }
  if (mentions(dossier, "docs/theorems.md")) {
    form.paragraph(
        "The theorems of docs/theorems.md have their proofs there; the file is part of the "
        "program's source.");
  }
}

void write(const Dossier& dossier, Form& form) {
  form.paragraph(dossier.statement + " " + definition_of(dossier) + " Quality: " + dossier.quality +
                 ".");
  form.paragraph("Verified by changeover " + std::string(version) + ": " + dossier.certificate +
                 ".");
  say_bounds(dossier, form);
  say_construction(dossier, form);
  form.heading("Blocks");
  if (dossier.design) {
    form.blocks(dossier);
  } else {
    form.paragraph(fmt::format("The {} are too many for a page. This command writes them:",
                               count_of(dossier.b, "block")));
    form.code(dossier.write_command + "\n");
  }
  if (dossier.picture) {
    form.picture(dossier);
  }
  say_how_to_check(dossier, form);
  form.references(dossier);
}

// ---------------------------------------------------------------------------------------- LaTeX

class Latex final : public Form {
 public:
  explicit Latex(const Dossier& dossier) : keys_(dossier.keys) {}

  void heading(const std::string& words) override {
    text += fmt::format("\n\\section*{{{}}}\n", latex_prose(words));
  }
  void paragraph(const std::string& words) override { text += latex_prose(words, keys_) + "\n\n"; }
  void item(std::size_t depth, const std::string& words) override {
    constexpr std::size_t deepest = 3;  // lists within lists of LaTeX end at four
    open_to(std::min(depth, deepest) + 1);
    text += fmt::format("\\item {}\n", latex_prose(words, keys_));
  }
  void end_of_items() override { open_to(0); }
  void code(const std::string& lines) override {
    text += fmt::format("\\begin{{verbatim}}\n{}\\end{{verbatim}}\n", folded(lines));
  }
  void blocks(const Dossier& dossier) override {
    constexpr std::uint64_t most_in_a_table = 60;
    if (dossier.b <= most_in_a_table) {
      LatexOptions options{.positions = dossier.positions};
      options.names.base_blocks = dossier.base_blocks;
      options.caption =
          latex_prose("A " + title_of(dossier) + "; a star marks an introduced element");
      StringSink sink;
      write_latex(*dossier.design, sink, options);
      text += sink.text();
      return;
    }
    // Letters of a line, and columns that fit; lines of more than that are set smaller.
    constexpr std::size_t line = 108;
    const std::string lines = lines_of(*dossier.design);
    std::size_t longest = 0;
    for (std::size_t start = 0; start < lines.size();) {
      const std::size_t end = lines.find('\n', start);
      longest = std::max(longest, end - start);
      start = end + 1;
    }
    const std::size_t columns = std::clamp<std::size_t>(line / (longest + 3), 1, 6);
    const std::string size = longest > line ? "\\tiny" : "\\scriptsize";
    const std::string verbatim = "\\begin{verbatim}\n" + lines + "\\end{verbatim}\n";
    text += columns == 1 ? fmt::format("{{{}\n{}}}\n", size, verbatim)
                         : fmt::format("\\begin{{multicols}}{{{}}}{}\n{}\\end{{multicols}}\n",
                                       columns, size, verbatim);
  }
  void picture(const Dossier& dossier) override {
    text += fmt::format(
        "\\begin{{figure}}[ht!]\n\\centering\n\\resizebox{{0.8\\linewidth}}{{!}}{{%\n{}}}\n"
        "\\caption{{{}}}\n\\end{{figure}}\n",
        tikz(*dossier.picture), latex_prose(dossier.picture_says, keys_));
  }
  void references(const Dossier& dossier) override {
    text += fmt::format("\\nocite{{*}}\n\\bibliographystyle{{plain}}\n\\bibliography{{{}}}\n",
                        bibliography(dossier));
  }

  /// The file that BibTeX reads, without its ending.
  static std::string bibliography(const Dossier& dossier) {
    std::string file = "changeover-" + cell_label(dossier.parameters);
    std::ranges::replace(file, '.', '-');
    return file;
  }

  std::string text;

 private:
  // Lines that are too long for a page go on below, after a backslash as shells have it.
  static std::string folded(const std::string& lines) {
    constexpr std::size_t width = 80;
    std::string text;
    std::size_t column = 0;
    for (const std::string& word : words_of(lines)) {
      if (column + word.size() > width && column > 0) {
        text += "\\\n  ";
        column = 2;
      }
      text += word;
      column = word.ends_with('\n') ? 0 : column + word.size();
    }
    return text;
  }

  // Pieces that end in a blank or a line feed.
  static std::vector<std::string> words_of(const std::string& lines) {
    std::vector<std::string> words(1);
    for (const char c : lines) {
      words.back() += c;
      if (c == ' ' || c == '\n') {
        words.emplace_back();
      }
    }
    words.pop_back();
    return words;
  }

  void open_to(std::size_t depth) {
    for (; open_ < depth; ++open_) {
      text += "\\begin{itemize}\n";
    }
    for (; open_ > depth; --open_) {
      text += "\\end{itemize}\n";
    }
  }

  std::vector<std::string> keys_;
  std::size_t open_ = 0;
};

// ------------------------------------------------------------------------------------- Markdown

class Markdown final : public Form {
 public:
  void heading(const std::string& words) override {
    text += fmt::format("## {}\n\n", markdown_text(words));
  }
  void paragraph(const std::string& words) override { text += markdown_prose(words) + "\n\n"; }
  void item(std::size_t depth, const std::string& words) override {
    text += std::string(2 * depth, ' ') + "- " + markdown_prose(words) + "\n";
  }
  void end_of_items() override { text += "\n"; }
  void code(const std::string& lines) override { text += fmt::format("```\n{}```\n\n", lines); }
  void blocks(const Dossier& dossier) override { code(lines_of(*dossier.design)); }
  void picture(const Dossier& dossier) override {
    paragraph(dossier.picture_says + " This command draws it:");
    code(dossier.draw_command + "\n");
  }
  void references(const Dossier& dossier) override {
    heading("References");
    text += fmt::format("```bibtex\n{}```\n", dossier.bibtex);
  }

  std::string text;
};

// ----------------------------------------------------------------------------------------- HTML

constexpr std::string_view style = R"(
  body { margin: 2rem auto; max-width: 48rem; padding: 0 1rem; color: #111; background: #fff;
         font: 16px/1.5 "Helvetica Neue", Helvetica, Arial, "Liberation Sans", sans-serif; }
  h1 { font-size: 1.7rem; margin: 0 0 .5rem; }
  h2 { font-size: 1.2rem; margin: 2rem 0 .5rem; }
  pre { overflow-x: auto; padding: .6rem .8rem; background: #f3f4f5; font-size: .85rem;
        white-space: pre-wrap; overflow-wrap: anywhere; }
  .blocks { column-width: 12rem; white-space: pre; }
  a { color: #0b57a4; }
  li { margin: .25rem 0; overflow-wrap: anywhere; }
  summary { cursor: pointer; }
  figure { margin: 1.5rem 0; text-align: center; }
  figure svg { max-width: 100%; height: auto; }
  .picture { overflow-x: auto; border-radius: .3rem; }
  @media screen and (max-width: 40rem) { .picture svg { max-width: none; width: 44rem; } }
  figcaption { font-size: .9rem; }
  @media print {
    body { margin: 0; max-width: none; font-size: 10pt; } .blocks { white-space: pre-wrap; } }
  @media (prefers-color-scheme: dark) { @media screen {
    body { color: #e8e8e8; background: #16181a; } pre { background: #24272a; }
    a { color: #8ec1ff; } figure svg { background: #fff; } } }
)";

class Html final : public Form {
 public:
  Html(const Dossier& dossier, std::string_view explorer)
      : keys_(dossier.keys), explorer_(explorer) {}

  void heading(const std::string& words) override {
    text += fmt::format("<h2>{}</h2>\n", html_text(words));
  }
  void paragraph(const std::string& words) override {
    text += fmt::format("<p>{}</p>\n", prose(words));
  }
  void item(std::size_t depth, const std::string& words) override {
    open_to(depth + 1);
    text += fmt::format("<li>{}\n", prose(words));
  }
  void end_of_items() override { open_to(0); }
  void code(const std::string& lines) override {
    text += fmt::format("<pre>{}</pre>\n", html_text(lines));
  }
  void blocks(const Dossier& dossier) override {
    text += fmt::format("<pre class=\"blocks\">{}</pre>\n", html_text(lines_of(*dossier.design)));
  }
  void picture(const Dossier& dossier) override {
    text += fmt::format(
        "<figure>\n<div class=\"picture\" tabindex=\"0\">{}</div><figcaption>{}</figcaption>\n</figure>\n",
        svg(*dossier.picture, Theme::light), html_text(dossier.picture_says));
  }
  void references(const Dossier& dossier) override {
    heading(keys_.empty() ? "Citation" : "References");
    text += keys_.empty() ? "" : "<ul>\n";
    for (const std::string& key : keys_) {
      const Work& work = *find_work(key);
      text += fmt::format("<li id=\"{}\">{}", html_text(key), html_text(work.text));
      if (!work.url.empty()) {
        text += fmt::format(". <a href=\"{0}\">{0}</a>", html_text(work.url));
      }
      text += "\n";
    }
    text += keys_.empty() ? "" : "</ul>\n";
    text += fmt::format("<details>\n<summary>BibTeX of this design{}</summary>\n",
                        keys_.empty() ? "" : " and of these works");
    code(dossier.bibtex);
    text += "</details>\n";
  }

  std::string text;

 private:
  // Works by their authors, linked to the references; theorems of the program linked to their
  // proofs, if there are pages that have them.
  [[nodiscard]] std::string prose(std::string_view words) const {
    std::string html;
    std::size_t done = 0;
    const auto put = [&](std::size_t at, std::size_t length, const std::string& instead) {
      html += html_prose(words.substr(done, at - done)) + instead;
      done = at + length;
    };
    for (std::size_t at = 0; at < words.size(); ++at) {
      if (words[at] == '[') {
        const std::size_t end = std::min(words.find_first_of(",]", at), words.size());
        const std::string key(words.substr(at + 1, end - at - 1));
        if (std::ranges::find(keys_, key) != keys_.end()) {
          put(at + 1, key.size(), fmt::format("<a href=\"#{}\">{}</a>", key, shown_work(key)));
        }
      } else if (const auto own = own_theorem_at(words.substr(at)); !own.empty()) {
        put(at, own.size(), linked(own));
      }
    }
    put(words.size(), 0, "");
    return html;
  }

  static std::string shown_work(const std::string& key) {
    const Work* const work = find_work(key);
    return html_text(work == nullptr ? key : work->name);
  }

  // "docs/theorems.md, Theorem 5" or without a number, "stays of Theorem 5"; empty if the text does
  // not begin with one.
  [[nodiscard]] static std::string_view own_theorem_at(std::string_view text) {
    constexpr std::string_view numbered = ", Theorem ";
    std::size_t length = 0;
    if (text.starts_with(our_theorems)) {
      length = our_theorems.size();
      if (text.substr(length).starts_with(numbered)) {
        length = std::min(text.find_first_not_of(digits, length + numbered.size()), text.size());
      }
    } else if (text.starts_with(stays_of)) {
      length = std::min(text.find_first_not_of(digits, stays_of.size()), text.size());
    }
    return text.substr(0, length);
  }

  [[nodiscard]] std::string linked(std::string_view own) const {
    if (explorer_.empty()) {
      return html_text(own);
    }
    const std::size_t digit = own.find_first_of(digits);
    if (digit == std::string_view::npos) {
      return fmt::format("<a href=\"{}#/theorems\">{}</a>", explorer_, own);
    }
    return fmt::format("{0}<a href=\"{1}#/theorems?theorem={2}\">Theorem {2} of Changeover</a>",
                       own.starts_with(stays_of) ? "stays of " : "", explorer_, own.substr(digit));
  }

  void open_to(std::size_t depth) {
    for (; open_ < depth; ++open_) {
      text += "<ul>\n";
    }
    for (; open_ > depth; --open_) {
      text += "</ul>\n";
    }
  }

  static constexpr std::string_view our_theorems = "docs/theorems.md";
  static constexpr std::string_view stays_of = "stays of Theorem ";
  static constexpr std::string_view digits = "0123456789";
  std::vector<std::string> keys_;
  std::string_view explorer_;
  std::size_t open_ = 0;
};

}  // namespace

std::string dossier_latex(const Dossier& dossier) {
  // Each table and picture stands below its heading.
  constexpr std::string_view in_place =
      "\\makeatletter\n"
      "\\newenvironment{inplace}[1]{\\par\\medskip\\noindent\\begin{minipage}{\\linewidth}"
      "\\def\\@captype{#1}}{\\end{minipage}\\par\\medskip}\n"
      "\\renewenvironment{table}[1][]{\\inplace{table}}{\\endinplace}\n"
      "\\renewenvironment{figure}[1][]{\\inplace{figure}}{\\endinplace}\n"
      "\\makeatother\n";
  Latex form(dossier);
  write(dossier, form);
  const std::string file = Latex::bibliography(dossier);
  return fmt::format(
      "% pdflatex, bibtex, pdflatex, pdflatex make the document of this file.\n"
      "\\begin{{filecontents*}}[overwrite]{{{}.bib}}\n{}\\end{{filecontents*}}\n"
      "\\documentclass{{article}}\n\\usepackage[utf8]{{inputenc}}\n\\usepackage[T1]{{fontenc}}\n"
      "\\IfFileExists{{lmodern.sty}}{{\\usepackage{{lmodern}}}}{{}}\n\\usepackage{{tikz}}\n"
      "\\usepackage{{longtable}}\n\\usepackage{{multicol}}\n\\usepackage[margin=25mm]{{geometry}}\n"
      "{}"
      "\\title{{{}}}\n\\author{{}}\n\\date{{}}\n\\sloppy\n\\begin{{document}}\n\\maketitle\n\n"
      "{}\n\\end{{document}}\n",
      file, dossier.bibtex, in_place, latex_prose("A " + title_of(dossier)), form.text);
}

std::string dossier_markdown(const Dossier& dossier) {
  Markdown form;
  write(dossier, form);
  return fmt::format("# A {}\n\n{}", markdown_text(title_of(dossier)), form.text);
}

std::string dossier_html(const Dossier& dossier, std::string_view explorer) {
  Html form(dossier, explorer);
  write(dossier, form);
  if (!explorer.empty()) {
    const Parameters& cell = dossier.parameters;
    form.text += fmt::format(
        "<p><a href=\"{}#/cell?v={}&amp;k={}&amp;change={}&amp;kind={}{}\">What else is known of "
        "these parameters</a></p>\n",
        explorer, cell.v, cell.k, cell.change, to_string(cell.kind),
        cell.strength == 2 ? "" : fmt::format("&amp;strength={}", cell.strength));
  }
  return html_page("A " + title_of(dossier), style, form.text);
}

}  // namespace changeover::cli
