// <microhttpd.h>, whose library is loaded when the first server starts.
#pragma once

#include <microhttpd.h>

#ifdef CHANGEOVER_LATE_MICROHTTPD

#include "cli/late_library.hpp"

namespace changeover::serve {

// These hide the functions of the same names.
#define CHANGEOVER_LATE(name) \
  inline const cli::LateFunction<decltype(::name)> name(CHANGEOVER_LATE_MICROHTTPD, #name)
CHANGEOVER_LATE(MHD_add_response_header);
CHANGEOVER_LATE(MHD_create_response_from_buffer_with_free_callback_cls);
CHANGEOVER_LATE(MHD_create_response_from_callback);
CHANGEOVER_LATE(MHD_destroy_response);
CHANGEOVER_LATE(MHD_get_connection_info);
CHANGEOVER_LATE(MHD_get_connection_values);
CHANGEOVER_LATE(MHD_get_connection_values_n);
CHANGEOVER_LATE(MHD_get_version);
CHANGEOVER_LATE(MHD_lookup_connection_value);
CHANGEOVER_LATE(MHD_queue_response);
CHANGEOVER_LATE(MHD_resume_connection);
CHANGEOVER_LATE(MHD_set_connection_option);
CHANGEOVER_LATE(MHD_start_daemon);
CHANGEOVER_LATE(MHD_stop_daemon);
CHANGEOVER_LATE(MHD_suspend_connection);
#undef CHANGEOVER_LATE

}  // namespace changeover::serve

#else

namespace changeover::serve {
using ::MHD_get_version;
}  // namespace changeover::serve

#endif
