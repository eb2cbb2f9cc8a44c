// What every reader of designs must do with any bytes: refuse them in one line, or make a design that
// survives being written and read again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"

namespace changeover::fuzz {

/// `read` makes a design of a string, `write` writes one to a sink. Aborts if they do not keep to that.
template <typename Read, typename Write>
int read_write_read(const std::uint8_t* data, std::size_t size, Read&& read, Write&& write) {
  const auto written = [&](const Design& design) {
    StringSink sink;
    write(design, sink);
    return sink.take();
  };
  std::string once;
  try {
    once = written(read(std::string(data, data + size)));
  } catch (const BadInput& fault) {
    if (std::string_view(fault.what()).find('\n') != std::string_view::npos) {
      std::abort();
    }
    return 0;
  }
  if (written(read(once)) != once) {
    std::abort();
  }
  return 0;
}

}  // namespace changeover::fuzz
