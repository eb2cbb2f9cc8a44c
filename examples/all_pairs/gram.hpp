// The Gram matrix in a file: n×n doubles, both triangles, filled chunk by chunk against chunk.
//
//     Gram gram("v.f32.gram", vectors, chunk);
//     options.results = &gram;
//     gram.write(rows, columns, [&](std::uint64_t i, std::uint64_t j) { return dot(i, j); });
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "changeover/loadorder/all_pairs.hpp"
#include "files.hpp"

class Gram final : public changeover::JobResults {
 public:
  // At most 2^64 bytes, or changeover::ImpossibleParameters. before_open is called when nothing
  // speaks against writing any more.
  Gram(const std::string& path, std::uint64_t vectors, std::uint64_t chunk,
       std::function<void()> before_open)
      : path_(path),
        file_(path),
        vectors_(vectors),
        chunk_(chunk),
        bytes_(product(product(vectors, vectors), sizeof(double))),
        before_open_(std::move(before_open)) {}

  [[nodiscard]] std::uint64_t vectors() const { return vectors_; }

  [[nodiscard]] std::string describe() const override {
    return path_ + ", " + std::to_string(vectors_) + " rows, by " + std::to_string(chunk_);
  }

  void open(const changeover::ResultsClaim& claim) override {
    before_open_();
    file_.open(bytes_, claim);
  }

  changeover::Checksum checksum(const changeover::StepPairs& done) override {
    changeover::Sha256 hash;
    for (const auto& [x, y] : done.pairs) {
      add(hash, x, y);
      if (x != y) {
        add(hash, y, x);
      }
    }
    return hash.finish();
  }

  void sync() override { file_.sync(); }

  // Entries (i, j) and (j, i) for all i of one chunk and j of another, or of the same. Thread-safe.
  template <typename Entry>
  void write(std::uint64_t first, std::uint64_t second, const Entry& entry) const {
    // A tile at a time, since a whole chunk against a chunk may be more than memory has room for.
    constexpr std::uint64_t side = 64;
    std::array<double, side * side> tile;
    std::array<double, side> column;
    const Range rows = range_of(first);
    const Range columns = range_of(second);
    for (std::uint64_t i0 = rows.begin; i0 < rows.end; i0 += side) {
      const std::uint64_t height = std::min(side, rows.end - i0);
      for (std::uint64_t j0 = columns.begin; j0 < columns.end; j0 += side) {
        const std::uint64_t width = std::min(side, columns.end - j0);
        if (first == second && j0 < i0) {
          continue;
        }
        const bool diagonal = first == second && i0 == j0;
        for (std::uint64_t i = 0; i < height; ++i) {
          for (std::uint64_t j = diagonal ? i : 0; j < width; ++j) {
            tile[i * side + j] = entry(i0 + i, j0 + j);
            if (diagonal) {
              tile[j * side + i] = tile[i * side + j];
            }
          }
        }
        for (std::uint64_t i = 0; i < height; ++i) {
          file_.write(&tile[i * side], width * sizeof(double), offset(i0 + i, j0));
        }
        for (std::uint64_t j = 0; !diagonal && j < width; ++j) {
          for (std::uint64_t i = 0; i < height; ++i) {
            column[i] = tile[i * side + j];
          }
          file_.write(column.data(), height * sizeof(double), offset(j0 + j, i0));
        }
      }
    }
  }

 private:
  struct Range {
    std::uint64_t begin;
    std::uint64_t end;
  };

  [[nodiscard]] Range range_of(std::uint64_t chunk) const {
    const std::uint64_t begin = chunk * chunk_;
    return {begin, begin + std::min(chunk_, vectors_ - begin)};
  }

  [[nodiscard]] std::uint64_t offset(std::uint64_t row, std::uint64_t column) const {
    return (row * vectors_ + column) * sizeof(double);
  }

  void add(changeover::Sha256& hash, std::uint64_t first, std::uint64_t second) {
    const Range rows = range_of(first);
    const Range columns = range_of(second);
    row_.resize(static_cast<std::size_t>(columns.end - columns.begin));
    for (std::uint64_t i = rows.begin; i < rows.end; ++i) {
      file_.read(row_.data(), row_.size() * sizeof(double), offset(i, columns.begin));
      hash.add(row_.data(), row_.size() * sizeof(double));
    }
  }

  std::string path_;
  changeover::ResultFile file_;
  std::uint64_t vectors_;
  std::uint64_t chunk_;
  std::uint64_t bytes_;
  std::function<void()> before_open_;
  std::vector<double> row_;
};
