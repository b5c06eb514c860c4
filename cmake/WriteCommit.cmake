# SPDX-License-Identifier: BSD-2-Clause
# Writes the commit of SOURCE into the file TO, for `soarbox --version`. Outside of a repository there is no such file.
# The file changes only if its content does.
execute_process(COMMAND git -C "${SOURCE}" rev-parse HEAD OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE
                ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  file(REMOVE "${TO}")
  return()
endif()
execute_process(COMMAND git -C "${SOURCE}" --no-optional-locks diff-index --quiet HEAD -- ERROR_QUIET RESULT_VARIABLE differs)
if(differs)
  string(APPEND commit " with changes")
endif()
set(known "")
if(EXISTS "${TO}")
  file(STRINGS "${TO}" known)
endif()
if(NOT known STREQUAL commit)
  file(WRITE "${TO}" "${commit}\n")
endif()
