// The libraries of workbooks, loaded when the first workbook is read or written: with what they
// bring along (libcrypto) they take as long to load as all others. What the rooms call are these
// functions, of the same names; of a function that is missing here, the program links the library.

#include <xlsxwriter.h>
#include <zip.h>

#include <cstddef>
#include <tuple>

#include "cli/late_library.hpp"

namespace changeover::cli {
namespace {

template <typename Function>
struct Shape;

template <typename Given, typename... Taken>
struct Shape<Given(Taken...)> {
  using Result = Given;
  template <std::size_t i>
  using Argument = std::tuple_element_t<i, std::tuple<Taken...>>;
};

}  // namespace

#define TAKEN(name, i) Shape<decltype(::name)>::Argument<i> a##i
#define LATE(library, name, taken, given)                                 \
  extern "C" Shape<decltype(::name)>::Result name taken {                 \
    static const LateFunction<decltype(::name)> function(library, #name); \
    return function given;                                                \
  }
#define LATE_0(library, name) LATE(library, name, (), ())
#define LATE_1(library, name) LATE(library, name, (TAKEN(name, 0)), (a0))
#define LATE_2(library, name) LATE(library, name, (TAKEN(name, 0), TAKEN(name, 1)), (a0, a1))
#define LATE_3(library, name) \
  LATE(library, name, (TAKEN(name, 0), TAKEN(name, 1), TAKEN(name, 2)), (a0, a1, a2))
#define LATE_4(library, name)                                                           \
  LATE(library, name, (TAKEN(name, 0), TAKEN(name, 1), TAKEN(name, 2), TAKEN(name, 3)), \
       (a0, a1, a2, a3))
#define LATE_5(library, name)                                                            \
  LATE(library, name,                                                                    \
       (TAKEN(name, 0), TAKEN(name, 1), TAKEN(name, 2), TAKEN(name, 3), TAKEN(name, 4)), \
       (a0, a1, a2, a3, a4))
#define LATE_6(library, name)                                                           \
  LATE(library, name,                                                                   \
       (TAKEN(name, 0), TAKEN(name, 1), TAKEN(name, 2), TAKEN(name, 3), TAKEN(name, 4), \
        TAKEN(name, 5)),                                                                \
       (a0, a1, a2, a3, a4, a5))
#define LATE_7(library, name)                                                           \
  LATE(library, name,                                                                   \
       (TAKEN(name, 0), TAKEN(name, 1), TAKEN(name, 2), TAKEN(name, 3), TAKEN(name, 4), \
        TAKEN(name, 5), TAKEN(name, 6)),                                                \
       (a0, a1, a2, a3, a4, a5, a6))

#ifdef CHANGEOVER_LATE_ZIP
#define ZIP(count, name) LATE_##count(CHANGEOVER_LATE_ZIP, name)
ZIP(1, zip_discard)
ZIP(1, zip_error_code_zip)
ZIP(1, zip_error_fini)
ZIP(1, zip_error_init)
ZIP(1, zip_error_strerror)
ZIP(1, zip_fclose)
ZIP(1, zip_file_strerror)
ZIP(3, zip_fopen_index)
ZIP(3, zip_fread)
ZIP(1, zip_get_error)
ZIP(0, zip_libzip_version)
ZIP(3, zip_name_locate)
ZIP(3, zip_open_from_source)
ZIP(4, zip_source_buffer_create)
ZIP(1, zip_source_free)
ZIP(1, zip_strerror)
#endif

#ifdef CHANGEOVER_LATE_XLSXWRITER
#define XLSX(count, name) LATE_##count(CHANGEOVER_LATE_XLSXWRITER, name)
XLSX(2, format_set_align)
XLSX(2, format_set_bg_color)
XLSX(1, format_set_bold)
XLSX(2, format_set_bottom)
XLSX(2, format_set_font_size)
XLSX(2, format_set_left)
XLSX(2, format_set_num_format)
XLSX(1, format_set_text_wrap)
XLSX(1, lxw_strerror)
XLSX(0, lxw_version)
XLSX(1, lxw_workbook_free)
XLSX(1, workbook_add_format)
XLSX(2, workbook_add_worksheet)
XLSX(1, workbook_close)
XLSX(1, workbook_new)
XLSX(2, workbook_set_properties)
XLSX(6, worksheet_data_validation_range)
XLSX(3, worksheet_fit_to_pages)
XLSX(3, worksheet_freeze_panes)
XLSX(2, worksheet_gridlines)
XLSX(1, worksheet_hide)
XLSX(3, worksheet_ignore_errors)
XLSX(7, worksheet_merge_range)
XLSX(3, worksheet_repeat_rows)
XLSX(5, worksheet_set_column)
XLSX(2, worksheet_set_footer)
XLSX(2, worksheet_set_header)
XLSX(1, worksheet_set_landscape)
XLSX(2, worksheet_set_paper)
XLSX(1, worksheet_set_portrait)
XLSX(4, worksheet_set_row)
XLSX(4, worksheet_write_blank)
XLSX(5, worksheet_write_number)
XLSX(5, worksheet_write_string)
#endif

}  // namespace changeover::cli
