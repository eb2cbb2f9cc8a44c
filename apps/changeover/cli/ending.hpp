// How a signal ends the process: what is unfinished goes away, and one line on stderr says so.
#pragma once

namespace changeover::cli {

/// From now on SIGINT, SIGTERM, SIGHUP and SIGQUIT end the process by end_by_signal(). One that is
/// ignored or handled already is left alone.
void end_on_signals();

/// For signal handlers: removes unfinished outputs, says in one line on stderr which signal came,
/// and ends the process as that signal would have. A second call does nothing.
void end_by_signal(int signal) noexcept;

}  // namespace changeover::cli
