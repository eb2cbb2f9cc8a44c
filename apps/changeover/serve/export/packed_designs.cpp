#include "serve/export/packed_designs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "io/write/json_writer.hpp"

namespace changeover::serve {
namespace {

class Bytes {
 public:
  explicit Bytes(std::uint64_t v) : wide_(v > 256) {}

  void add(std::uint64_t value) {
    text_ += static_cast<char>(value & 0xffU);
    if (wide_) {
      text_ += static_cast<char>(value >> 8U);
    }
  }
  void add(const Bytes& other) { text_ += other.text_; }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  bool wide_;
  std::string text_;
};

// Nothing if it cannot be told by steps: blocks out of order, or steps of another size.
std::optional<std::string> by_steps(const Design& design) {
  const Parameters& p = design.parameters();
  const auto m = static_cast<std::size_t>(p.change);
  const std::size_t b = design.block_count();
  Bytes all(p.v);
  std::vector<Bytes> places(m, Bytes(p.v));
  std::vector<Bytes> elements(m, Bytes(p.v));
  std::vector<std::uint64_t> before(m, 0);
  Block memory;
  for (std::size_t i = 0; i < b; ++i) {
    const auto block = design.block(i);
    if (!std::ranges::is_sorted(block)) {
      return std::nullopt;
    }
    if (i == 0) {
      memory.assign(block.begin(), block.end());
      for (const Element x : block) {
        all.add(x);
      }
      continue;
    }
    Block entering;
    Block sorted = memory;
    std::ranges::sort(sorted);
    std::ranges::set_difference(block, sorted, std::back_inserter(entering));
    if (entering.size() != m) {
      return std::nullopt;
    }
    std::size_t j = 0;
    for (std::size_t place = 0; place < memory.size(); ++place) {
      if (!std::ranges::binary_search(block, memory[place])) {
        places[j].add(place);
        elements[j].add((entering[j] + p.v - before[j]) % p.v);
        before[j] = entering[j];
        memory[place] = entering[j];
        ++j;
      }
    }
  }
  for (std::size_t j = 0; j < m; ++j) {
    all.add(places[j]);
    all.add(elements[j]);
  }
  return all.take();
}

std::string by_blocks(const Design& design) {
  const Parameters& p = design.parameters();
  Bytes all(p.v);
  std::vector<std::uint64_t> before(static_cast<std::size_t>(p.k), 0);
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    const auto block = design.block(i);
    for (std::size_t j = 0; j < block.size(); ++j) {
      all.add((block[j] + p.v - before[j]) % p.v);
      before[j] = block[j];
    }
  }
  return all.take();
}

}  // namespace

void PackedDesigns::add(const std::string& label, const Design& design,
                        const DesignVerdict& verdict) {
  const Parameters& p = design.parameters();
  JsonWriter json;
  json.begin_object().key("label").value(label).key("format").value("changeover-design/1");
  json.parameters(p);
  if (!design.labels().empty()) {
    json.key("labels").value(design.labels());
  }
  json.key("verdict").raw(verdict_to_json(verdict));
  std::string head = json.end_object().take();
  head.pop_back();
  auto steps = by_steps(design);
  Packed packed{.label = label,
                .head = std::move(head),
                .way = steps ? "steps" : "blocks",
                .bytes = steps ? *std::move(steps) : by_blocks(design)};
  const std::scoped_lock lock(mutex_);
  designs_.push_back(std::move(packed));
}

std::string PackedDesigns::take() {
  const std::scoped_lock lock(mutex_);
  std::ranges::sort(designs_, {}, &Packed::label);
  std::string index = "[";
  std::string bytes;
  for (const Packed& each : designs_) {
    index += fmt::format("{}{},\"way\":\"{}\",\"at\":{}}}", index.size() > 1 ? "," : "", each.head,
                         each.way, bytes.size());
    bytes += each.bytes;
  }
  designs_.clear();
  return index + "]\n" + bytes;
}

}  // namespace changeover::serve
