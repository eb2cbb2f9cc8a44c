// Construction and text output against writing the same bytes, ready-made, to the same place.
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "changeover/construct/registry.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/io/output.hpp"
#include "paired.hpp"

namespace changeover::bench {
namespace {

/// A sink that hands each piece to the system at once, as OutputFile does with its buffer.
class DescriptorSink final : public Sink {
 public:
  explicit DescriptorSink(const std::filesystem::path& path)
      : descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600)) {}
  ~DescriptorSink() override { ::close(descriptor_); }
  DescriptorSink(const DescriptorSink&) = delete;
  DescriptorSink& operator=(const DescriptorSink&) = delete;

  void write(std::string_view bytes) override {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written <= 0) {
        std::abort();
      }
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

 private:
  int descriptor_;
};

void text_against_bytes(benchmark::State& state, bool to_file) {
  const Registry& registry = Registry::standard();
  const Offer offer = registry
                          .best({.v = static_cast<std::uint64_t>(state.range(0)),
                                 .k = static_cast<std::uint64_t>(state.range(1)),
                                 .kind = Kind::circular})
                          .value();
  StringSink ready;
  write_text(*registry.build(offer.recipe), ready);
  const std::filesystem::path path = to_file ? std::filesystem::temp_directory_path() /
                                                   ("changeover-bench-" + std::to_string(getpid()))
                                             : std::filesystem::path("/dev/null");
  constexpr std::size_t piece = 256 * 1024;
  run_paired(
      state,
      [&] {
        DescriptorSink sink(path);
        std::string copy;  // the bytes pass through a buffer once, as anyone's would
        for (std::string_view rest = ready.text(); !rest.empty();) {
          copy.assign(rest.substr(0, piece));
          sink.write(copy);
          rest.remove_prefix(copy.size());
        }
      },
      [&] {
        DescriptorSink sink(path);
        write_text(*registry.build(offer.recipe), sink);
      });
  state.counters["MB"] = static_cast<double>(ready.text().size()) / 1e6;
  if (to_file) {
    std::filesystem::remove(path);
  }
}

void text_to_file(benchmark::State& state) { text_against_bytes(state, true); }
void text_to_null(benchmark::State& state) { text_against_bytes(state, false); }

void sizes(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"v", "k"})
      ->Args({991, 51})  // v ≈ 10³, large and small blocks
      ->Args({1001, 4})
      ->Args({9991, 501})  // v ≈ 10⁴
      ->Args({10001, 4})
      ->Unit(benchmark::kMillisecond);
}

BENCHMARK(text_to_file)->Apply(sizes);
BENCHMARK(text_to_null)->Apply(sizes);

}  // namespace
}  // namespace changeover::bench
