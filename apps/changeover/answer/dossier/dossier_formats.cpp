#include <fmt/format.h>

#include <algorithm>

#include "answer/dossier/dossier_form.hpp"
#include "answer/dossier/dossier_setting.hpp"
#include "changeover/core/version.hpp"
#include "changeover/io/tables.hpp"
#include "construct/references.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "io/table/table.hpp"
#include "io/write/latex_prose.hpp"

namespace changeover::cli {

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

std::vector<std::string> all_keys(const Dossier& dossier) {
  std::vector<std::string> keys = dossier.keys;
  if (!dossier.theorems.empty()) {
    keys.emplace_back(own_key);
  }
  return keys;
}

namespace {

// What the name of the design says, for readers of papers that do not.
std::string definition_of(const Dossier& dossier) {
  const Parameters& p = dossier.parameters;
  const std::string every = p.strength == 2 ? "two" : std::to_string(p.strength);
  const std::string step =
      dossier.b == 1
          ? ""
          : fmt::format(", and each block has exactly {} that {} not in the block before it{}",
                        count_of(p.change, "element"), p.change == 1 ? "is" : "are",
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
    form.item(0,
              for_paper(fmt::format("b >= {} ({}): {}", bound.blocks, bound.name, bound.reason)));
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
    form.item(step.depth, for_paper(fmt::format("{}. {}{}", step.design, step.how,
                                                cites ? " " + step.citation : "")));
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
  const Parameters& p = dossier.parameters;
  form.heading("How to check it");
  form.paragraph(
      "`checkdesign` is a C program of one file that shares no code with the program that made the "
      "design.");
  form.code(dossier.write_command + "\ncheckdesign design.txt\n" +
            (dossier.names_elements ? "" : "grep -v \"^#\" design.txt | sha256sum\n"));
  if (dossier.design) {
    form.paragraph(
        "Without the program, save the blocks above as `design.txt`, one block a line; the file "
        "has no header then, so the parameters are given:");
    form.code(fmt::format("checkdesign -v {} -k {} -m {} -t {} {} design.txt\n", p.v, p.k, p.change,
                          p.strength, p.kind == Kind::circular ? "-c" : "-l"));
  }
  form.paragraph("It prints the following first, and then what it counted besides:");
  form.code(
      fmt::format("valid\nv {}\nk {}\nchange {}\nkind {}\nstrength {}\nblocks {}\n"
                  "uncovered 0\nbad-steps 0\n",
                  p.v, p.k, p.change, to_string(p.kind), p.strength, dossier.b));
  if (!dossier.names_elements) {
    form.paragraph("`sha256sum` prints the checksum that stands under Construction.");
  }
  if (!dossier.proof_commands.empty()) {
    form.paragraph(
        "That no design has fewer blocks rests on proofs by a SAT solver. The first command makes "
        "formulas and proofs in DIMACS and DRAT, and ends with exit code 10, for a design was "
        "found too. Any DRAT checker reads them; `drat-trim` prints `s VERIFIED` for each.");
    const std::string commands = joined(dossier.proof_commands, "",
                                        [&](const std::string& command) { return command + "\n"; });
    form.code(commands);
  }
}

}  // namespace

void write(const Dossier& dossier, Form& form) {
  form.paragraph(dossier.statement + " " + definition_of(dossier));
  form.facts(dossier.facts);
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
  if (!dossier.theorems.empty()) {
    form.theorems(dossier);
  }
  form.references(dossier);
}

namespace {

// ---------------------------------------------------------------------------------------- LaTeX

class Latex final : public Form {
 public:
  explicit Latex(const Dossier& dossier) : keys_(all_keys(dossier)) {}

  void heading(const std::string& words) override {
    text += fmt::format("\n\\section*{{{}}}\n", latex_prose(words));
  }
  void paragraph(const std::string& words) override { text += prose(words) + "\n\n"; }
  void item(std::size_t depth, const std::string& words) override {
    constexpr std::size_t deepest = 3;  // lists within lists of LaTeX end at four
    open_to(std::min(depth, deepest) + 1);
    text += fmt::format("\\item {}\n", prose(words));
  }
  void end_of_items() override { open_to(0); }
  void facts(const std::vector<DossierFact>& rows) override {
    text += "\\begin{center}\n\\begin{tabular}{ll}\n";
    for (const DossierFact& row : rows) {
      const std::size_t letter = row.name.size() > 1 && row.name[1] == ',' ? 1 : 0;
      text += fmt::format("{}{} & {} \\\\\n",
                          letter == 0 ? "" : fmt::format("${}$", row.name.substr(0, 1)),
                          latex_prose(row.name.substr(letter)), prose(row.value));
    }
    text += "\\end{tabular}\n\\end{center}\n\n";
  }
  // They are cited.
  void theorems(const Dossier&) override {}
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
  // Commands as code, with places to break them at their blanks.
  [[nodiscard]] std::string prose(const std::string& words) const {
    std::string latex;
    for (const auto& [piece, code] : pieces_of(words)) {
      latex += code ? fmt::format("\\texttt{{{}}}", latex_prose(piece))
                    : with_letters_set(latex_prose(piece, keys_));
    }
    return latex;
  }

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
  void paragraph(const std::string& words) override { text += prose(words) + "\n\n"; }
  void item(std::size_t depth, const std::string& words) override {
    text += std::string(2 * depth, ' ') + "- " + prose(words) + "\n";
  }
  void end_of_items() override { text += "\n"; }
  void facts(const std::vector<DossierFact>& rows) override {
    text += "| | |\n|---|---|\n";
    for (const DossierFact& row : rows) {
      text += fmt::format("| {} | {} |\n", markdown_text(row.name), prose(row.value));
    }
    text += "\n";
  }
  void theorems(const Dossier& dossier) override {
    heading("Theorems used");
    paragraph(fmt::format("As Changeover {} has them, with their proofs.", version));
    for (const QuotedTheorem& theorem : dossier.theorems) {
      text += "> ";
      for (const char c : theorem.statement) {
        text += c == '\n' ? std::string("\n> ") : std::string(1, c);
      }
      text += "\n\n";
    }
  }
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

 private:
  static std::string prose(const std::string& words) {
    std::string markdown;
    for (const auto& [piece, code] : pieces_of(words)) {
      markdown += code ? "`" + piece + "`" : markdown_prose(piece);
    }
    // Who reads it as it stands reads places to break lines, too.
    constexpr std::string_view place = "<wbr>";
    for (std::size_t at = markdown.find(place); at != std::string::npos;
         at = markdown.find(place, at)) {
      markdown.erase(at, place.size());
    }
    return markdown;
  }
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

}  // namespace changeover::cli
