// What this process asks of the system before it does anything else.
#pragma once

namespace changeover::cli {

/// Call it first. A closed standard stream gets a descriptor that cannot be used, so that no file
/// takes its number; a write to a pipe without a reader, or beyond the limit on the size of files,
/// fails instead of ending the process.
void prepare_process();

/// The reader of standard output left: ends the process as it would have ended without
/// prepare_process(), by SIGPIPE. Returns only if that is ignored by the parent's wish.
void leave_with_the_reader();

}  // namespace changeover::cli
