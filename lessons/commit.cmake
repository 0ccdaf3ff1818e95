# cmake -Dsource=FOLDER -Dout=FILE -P commit.cmake: writes the source of byhand::tutor::commit().
execute_process(COMMAND git --no-optional-locks -C ${source} describe --always --dirty --abbrev=40 --exclude=*
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${out} CONTENT [[
#include "lessons/tutor/commit.hpp"

const char* byhand::tutor::commit() { return "@commit@"; }
]] @ONLY)
