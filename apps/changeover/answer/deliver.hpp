// Where answers go: whole to the place that was asked for, or somewhere else if it took long to find them.
//
//     deliver(text, request.output);
//     deliver(request.output, [&](OutputFile& out) { write_text(source, out, header); });
//
// The one place that writes what a verb answers. A file appears whole or not at all. If the answer is
// *precious* (a search made it) and its place cannot be written, then it goes to a new file in the current
// folder, or if that fails too, to standard output; one line on stderr says where it is, and the verb ends with
// exit code 4.
#pragma once

#include <functional>
#include <string>

#include "changeover/io/output.hpp"

namespace changeover::cli {

struct OutputRequest;

/// Writes all of an answer. @throws MissingResource if it is not where it was asked for.
void deliver(const std::string& text, const OutputRequest& output);

/// The same for an answer that is written in pieces. `write` does not commit; it may be called again, for
/// another file, and then begins anew.
void deliver(const OutputRequest& output, const std::function<void(OutputFile&)>& write);

/// A text that is not precious; "" and "-" are standard output.
void deliver(const std::string& text, const std::string& path);

}  // namespace changeover::cli
