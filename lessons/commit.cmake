# cmake -Dsource=FOLDER -Dout=FILE -P commit.cmake: writes the source of byhand::course::commit().
execute_process(COMMAND git --no-optional-locks -C ${source} describe --always --dirty --abbrev=40 --exclude=*
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit unknown)
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E env TZ=UTC git -C ${source} log -1 --date=format-local:%Y-%m-%dT%H:%M:%SZ --format=%cd
  OUTPUT_VARIABLE time OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(time 1970-01-01T00:00:00Z)
endif()
file(CONFIGURE OUTPUT ${out} CONTENT [[
#include "lessons/files/commit.hpp"

const char* byhand::course::commit() { return "@commit@"; }
const char* byhand::course::commit_time() { return "@time@"; }
]] @ONLY)
