// Checksums made right, which would stop a fuzzer at the door.
#pragma once

#include <string>

namespace changeover::fuzz {

/// A journal whose lines "step N RESULTS …" end with the checksum that all lines before ask for.
[[nodiscard]] std::string with_right_chain(const std::string& journal);

/// A checkpoint whose last line is the checksum of all before it.
[[nodiscard]] std::string with_right_check(const std::string& checkpoint);

}  // namespace changeover::fuzz
