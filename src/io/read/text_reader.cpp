#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/formats.hpp"
#include "core/printable.hpp"
#include "io/read/declared.hpp"
#include "io/scan/json_events.hpp"
#include "io/scan/text_scanner.hpp"

namespace changeover {
namespace {

constexpr std::size_t recipe_bytes = std::size_t{64} << 20;
constexpr std::size_t kept_bytes = std::size_t{4} << 30;

// Makes an input rewindable by keeping the bytes that were read.
class KeptInput final : public Input {
 public:
  explicit KeptInput(std::unique_ptr<Input> inner)
      : Input(inner->name()), inner_(std::move(inner)) {}

  std::size_t read(std::span<char> buffer) override {
    if (position_ < text_.size()) {
      const std::size_t count = std::min(buffer.size(), text_.size() - position_);
      std::copy_n(text_.data() + position_, count, buffer.data());
      position_ += count;
      return count;
    }
    const std::size_t count = inner_->read(buffer);
    if (!keeping_) {
      return count;
    }
    text_.append(buffer.data(), count);
    position_ += count;
    if (text_.size() > kept_bytes) {
      throw MissingResource(
          fmt::format("{}: more than {} MiB without a declared v; begin with a line "
                      "'# changeover design v=…', or read a file",
                      name(), kept_bytes >> 20));
    }
    return count;
  }

  bool rewind() override {
    if (keeping_) {
      position_ = 0;
    }
    return keeping_;
  }

  // There will be no rewind: all bytes so far were read, and later ones need not be kept.
  void stop_keeping() {
    keeping_ = false;
    text_ = std::string();
    position_ = 0;
  }

 private:
  std::unique_ptr<Input> inner_;
  bool keeping_ = true;
  std::string text_;
  std::size_t position_ = 0;
};

class TextSource final : public BlockByBlock<TextSource, DesignInput> {
 public:
  // `kept` is `input` if that keeps its bytes.
  TextSource(std::unique_ptr<Input> input, KeptInput* kept, const ReadOptions& options)
      : input_(std::move(input)), scanner_(*input_) {
    if (const auto defect = table_defect(scanner_.beginning())) {
      scanner_.fail({}, *defect);
    }
    const bool numbers = only_numbers(scanner_.beginning());
    read_header();
    declared_ = merged(input_->name(), options, file_);
    choose_rule(numbers);
    if (rule_ == Rule::survey) {
      survey();
    } else {
      if (kept != nullptr) {
        kept->stop_keeping();
      }
      read_front();
    }
  }

  const Parameters& parameters() const override { return parameters_; }
  std::optional<std::uint64_t> block_count() const override { return block_count_; }
  const std::vector<std::string>& labels() const override { return labels_; }
  const std::optional<Recipe>& recipe() const override { return recipe_; }

  bool make(std::span<Element> block) {
    if (given_ < front_.size()) {
      std::ranges::copy(front_[given_], block.begin());
      ++given_;
      return true;
    }
    if (ended_) {
      return false;
    }
    if (read_block(block.data(), k_) == 0) {
      finish();
      return false;
    }
    return true;
  }

  bool rewind() override {
    if (!input_->rewind()) {
      return false;
    }
    restart();
    return true;
  }

 private:
  enum class Rule : std::uint8_t {
    numbers,  // v is declared: elements are numbers below it
    listed,   // labels are listed
    named,    // v is declared: names as they occur
    survey,   // v is not declared: everything is read once to see which elements occur
    surveyed  // … and all is known
  };

  // ---- the header ----

  void read_header() {
    for (;;) {
      const TextScanner::Item item = scanner_.next();
      if (item == TextScanner::Item::comment) {
        read_header_comment();
      } else if (item == TextScanner::Item::word) {
        pending_word_ = true;
        first_block_place_ = scanner_.word_place();
        return;
      } else if (item == TextScanner::Item::end) {
        scanner_.fail(scanner_.here(), no_blocks);
      }
    }
  }

  void read_header_comment() {
    TextScanner::CommentWord word;
    if (!scanner_.comment_word(word)) {
      return;
    }
    if (word.text == "labels:") {
      read_labels(word.place);
    } else if (word.text == "recipe:") {
      read_recipe();
    } else if (word.text == "changeover" && scanner_.comment_word(word) && word.text == "design") {
      header_place_ = word.place;
      while (scanner_.comment_word(word)) {
        const std::size_t equals = word.text.find('=');
        if (equals != std::string::npos) {
          if (const auto defect =
                  declare(file_, word.text.substr(0, equals), word.text.substr(equals + 1))) {
            scanner_.fail(word.place, *defect);
          }
        }
      }
    }
    scanner_.skip_comment();
  }

  void read_labels(Place place) {
    if (labels_place_) {
      scanner_.fail(place, "labels are listed twice; list them once");
    }
    labels_place_ = place;
    TextScanner::CommentWord word;
    while (scanner_.comment_word(word, max_token_bytes + 1)) {
      if (const auto defect = add_label(table_, word.text)) {
        scanner_.fail(word.place, *defect);
      }
    }
  }

  void read_recipe() {
    const Place place = scanner_.here();
    const std::string text = scanner_.rest_of_comment(recipe_bytes);
    if (recipe_) {
      scanner_.fail(place, "a second recipe; remove one");
    }
    recipe_ = recipe_at(text, input_->name(), place);
  }

  void choose_rule(bool only_numbers) {
    if (labels_place_) {
      if (const auto defect = label_count_defect(table_.size(), declared_)) {
        scanner_.fail(*labels_place_, *defect);
      }
      rule_ = Rule::listed;
      v_ = table_.size();
      set_labels(table_.words());
    } else if (!declared_.v) {
      rule_ = Rule::survey;
      v_ = max_elements_in_memory;
    } else {
      v_ = *declared_.v;
      rule_ = only_numbers ? Rule::numbers : Rule::named;
      if (only_numbers) {
        table_.add_numbers(v_);
      }
    }
    seen_.assign(static_cast<std::size_t>(v_), 0);
  }

  void set_labels(std::vector<std::string> labels) {
    // Labels that are the elements' own numbers are dropped.
    const ElementSet set = element_set(labels);
    const bool plain = set.labels.empty() && std::ranges::is_sorted(set.element_of);
    labels_ = plain ? std::vector<std::string>() : std::move(labels);
  }

  // ---- the blocks ----

  // Reads a block into `out`, which has room for `room` elements, and returns their number; 0 at
  // the end. Once k is known the block has k elements.
  std::size_t read_block(Element* out, std::size_t room) {
    if (++stamp_ == 0) {  // after 2³² blocks old marks could be taken for new ones
      std::ranges::fill(seen_, 0);
      stamp_ = 1;
    }
    std::size_t size = 0;
    for (;;) {
      const TextScanner::Item item = pending_word_ ? TextScanner::Item::word : scanner_.next();
      pending_word_ = false;
      if (item == TextScanner::Item::word) {
        Element element = table_.number(scanner_.number());
        if (element == TokenTable::none) {
          element = look_up(size == 0);
        }
        if (size == room) {
          scanner_.fail(scanner_.word_place(),
                        surplus_defect(blocks_ + 1, room, declared_.k.has_value()));
        }
        if (seen_[element] == stamp_) {
          scanner_.fail(scanner_.word_place(), repeat_defect(blocks_ + 1, scanner_.word()));
        }
        seen_[element] = stamp_;
        out[size++] = element;
      } else if (item == TextScanner::Item::comment) {
        read_late_comment(size == 0);
      } else if (size > 0) {
        if (k_ != 0 && size != k_) {
          const Place place =
              item == TextScanner::Item::end ? scanner_.here() : scanner_.line_end_place();
          scanner_.fail(place, size_defect(blocks_ + 1, size, k_, declared_.k.has_value()));
        }
        ++blocks_;
        return size;
      } else if (item == TextScanner::Item::end) {
        return 0;
      }
    }
  }

  Element look_up(bool is_first) {
    const std::string_view word = scanner_.word();
    const Element known = table_.find(word);
    if (known != TokenTable::none) {
      return known;
    }
    const auto fail = [&](std::string_view what) { scanner_.fail(scanner_.word_place(), what); };
    if (rule_ == Rule::listed) {
      fail(unknown_label_defect(word));
    } else if (rule_ == Rule::numbers) {
      fail(plain_number(word)
               ? above_v_defect(word, v_)
               : fmt::format("element {} is not a number, but those before are; list all names "
                             "in a line '# labels: …'",
                             shown(word)));
    } else if (rule_ == Rule::surveyed) {
      fail("the file changes while it is read; try again");
    } else if (table_.size() == v_) {
      fail(too_many_defect(word, declared_.v));
    } else if (const auto defect = word_defect(word)) {
      fail(*defect);
    } else if (!header_place_) {
      if (const auto loose = loose_word_defect(word, is_first)) {
        fail(*loose);
      }
    }
    return table_.add(word);
  }

  void read_late_comment(bool alone) {
    TextScanner::CommentWord word;
    if (alone && blocks_ > 0 && scanner_.comment_word(word)) {
      const Place place = word.place;
      if (word.text == "labels:" ||
          (word.text == "changeover" && scanner_.comment_word(word) && word.text == "design")) {
        scanner_.fail(place, fmt::format("{} after the first block; move it to the top, one design "
                                         "per file",
                                         word.text == "labels:" ? "labels" : "a header"));
      }
    }
    scanner_.skip_comment();
  }

  // Reads as many blocks as it takes to know k and change; at least one.
  void read_front() {
    k_ = declared_.k.value_or(0);
    read_front_block();
    k_ = front_[0].size();
    if (!declared_.change || rule_ == Rule::survey) {
      read_front_block();
    }
    const std::uint64_t change = front_.size() < 2 ? 0 : difference(front_[0], front_[1]).size();
    if (rule_ != Rule::survey) {
      complete(change);
    } else {
      first_change_ = change;
    }
  }

  void read_front_block() {
    Block block(k_ != 0 ? k_ : max_elements_in_memory);
    block.resize(read_block(block.data(), block.size()));
    if (block.empty()) {
      finish();
    } else {
      front_.push_back(std::move(block));
    }
  }

  void complete(std::uint64_t first_change) {
    if (k_ == 1 && v_ > 1 && !declared_.k && declared_.strength.value_or(2) == 2) {
      scanner_.fail(first_block_place_,
                    "each block has one element; separate the elements of a block by blanks");
    }
    parameters_ = completed(input_->name(), header_place_.value_or(first_block_place_), declared_,
                            v_, k_, first_change);
  }

  // Reads everything to find the elements, and starts over.
  void survey() {
    read_front();
    std::vector<Element> block(k_);
    while (!ended_ && read_block(block.data(), k_) != 0) {
    }
    const ElementSet set = element_set(table_.words());
    v_ = set.element_of.size();
    table_.renumber(set.element_of);
    labels_ = set.labels;
    rule_ = Rule::surveyed;
    block_count_ = blocks_;
    complete(first_change_);
    if (!input_->rewind()) {
      scanner_.fail(scanner_.here(),
                    "the input cannot be read again; declare v in a first line "
                    "'# changeover design v=…'");
    }
    front_.clear();
    restart();
  }

  void finish() {
    ended_ = true;
    block_count_ = blocks_;
    if (rule_ == Rule::named) {
      std::vector<std::string> labels = table_.words();
      fill_labels(labels, v_);
      labels_ = std::move(labels);
    }
  }

  void restart() {
    scanner_.restart();
    front_.clear();
    given_ = 0;
    blocks_ = 0;
    ended_ = false;
    pending_word_ = false;
    std::ranges::fill(seen_, 0);
    stamp_ = 0;
  }

  std::unique_ptr<Input> input_;
  TextScanner scanner_;
  TokenTable table_;
  ReadOptions file_;
  Declared declared_;
  std::optional<Place> header_place_, labels_place_;
  Place first_block_place_;
  Rule rule_ = Rule::numbers;
  std::uint64_t v_ = 0;
  std::size_t k_ = 0;  // 0 until it is known
  std::uint64_t first_change_ = 0;
  Parameters parameters_;
  std::vector<std::string> labels_;
  std::optional<Recipe> recipe_;
  std::optional<std::uint64_t> block_count_;

  std::vector<Block> front_;   // blocks that were read to learn parameters
  std::size_t given_ = 0;      // how many of them make() has handed out
  bool pending_word_ = false;  // the scanner has taken the first block's first word already
  bool ended_ = false;
  std::uint64_t blocks_ = 0;         // finished blocks
  std::uint32_t stamp_ = 0;          // number of the block being read, modulo 2³²
  std::vector<std::uint32_t> seen_;  // by element: the last block that holds it
};

}  // namespace

std::unique_ptr<DesignInput> open_text(std::unique_ptr<Input> input, const ReadOptions& options) {
  KeptInput* kept = nullptr;
  if (!input->rewind()) {
    auto keeping = std::make_unique<KeptInput>(std::move(input));
    kept = keeping.get();
    input = std::move(keeping);
  }
  return std::make_unique<TextSource>(std::move(input), kept, options);
}

Design read_text(std::unique_ptr<Input> input, const ReadOptions& options) {
  return read_all(*open_text(std::move(input), options));
}

Design read_all(DesignInput& input) {
  Design design = read_all(static_cast<BlockSource&>(input));
  design.set_labels(input.labels());
  design.recipe = input.recipe();
  return design;
}

}  // namespace changeover
