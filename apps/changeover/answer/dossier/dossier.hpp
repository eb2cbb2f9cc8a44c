// A dossier: what a paper, or its referee, needs of one design, on one page.
//
//     const Dossier dossier = dossier_of(built(offer), label);
//     dossier_latex(dossier);                 // a document that LaTeX and BibTeX compile
//
// It says what the design is, its quality, why fewer blocks cannot be (each bound with its reason),
// how the design is made, its blocks if they are few, a picture, how to check it with other
// programs, and whom to cite.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "answer/design/chosen_design.hpp"
#include "answer/design/recipe_tree.hpp"
#include "answer/dossier/dossier_words.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/sha256.hpp"
#include "changeover/draw/picture.hpp"
#include "construct/known_documents.hpp"

namespace changeover::cli {

/// A row of the table at the top.
struct DossierFact {
  std::string name;
  std::string value;
};

struct Dossier {
  Parameters parameters;
  std::uint64_t b = 0;
  std::string statement;    ///< a sentence: what there is
  std::string quality;      ///< "tight, minimum (…)"
  std::string certificate;  ///< how the program verified it
  std::string label;        ///< in the catalog; empty if it is not there
  std::string credit;       ///< of that entry
  std::string found;        ///< the same as a sentence without its end: who found it, and how
  std::vector<DossierFact> facts;
  Checksum checksum = {};  ///< of the blocks, as labels have it
  KnownBounds known;       ///< every lower bound; what publications report
  std::vector<RecipeStep> steps;
  std::string recipe;                        ///< JSON
  std::vector<std::uint64_t> positions;      ///< of an expansion set
  std::optional<std::uint64_t> base_blocks;  ///< to name the blocks B_{i,j}
  std::optional<Design> design;  ///< the blocks; nothing if there are more than a page should have
  std::optional<Picture> picture;
  std::string picture_name;     ///< as `draw --picture` has it
  std::string picture_says;     ///< a sentence below it
  std::string draw_command;     ///< draws the picture
  std::string write_command;    ///< writes the blocks to design.txt
  bool names_elements = false;  ///< that file has names instead of numbers, and so another checksum
  /// Make and check the proof that there are none with fewer; empty if the reason is on paper.
  std::vector<std::string> proof_commands;
  std::vector<QuotedTheorem> theorems;  ///< those of the program that it rests on
  std::vector<std::string> keys;        ///< of docs/references.bib, each once
  std::string bibtex;                   ///< of the design, of all keys and of those theorems
};

/// More blocks, or elements in all blocks together, are not listed.
inline constexpr std::uint64_t most_listed_blocks = 600;
inline constexpr std::uint64_t most_listed_elements = 6'000;

/// @param entry of the catalog, if the design is there.
/// @throws as Registry::build() and judge(). Reads the design three times at most.
[[nodiscard]] Dossier dossier_of(const ChosenDesign& chosen,
                                 const std::optional<CatalogEntry>& entry);

[[nodiscard]] std::string dossier_latex(const Dossier& dossier);
[[nodiscard]] std::string dossier_markdown(const Dossier& dossier);
/// `explorer` is where the pages of the program are, as seen from this one: theorems are linked
/// there.
[[nodiscard]] std::string dossier_html(const Dossier& dossier, std::string_view explorer = {});

/// The document changeover-dossier/1 (docs/schema).
[[nodiscard]] std::string dossier_json(const Dossier& dossier);

}  // namespace changeover::cli
