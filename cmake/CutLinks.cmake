# SPDX-License-Identifier: BSD-2-Clause
# Makes plain text of links in the installed pages below `pages` that lead to files of the source which are not installed.
file(GLOB_RECURSE files "${pages}/*.md")
set(left_out "(docs/dev|dev|tests|src|bench|web|bindings|packaging|editors|scenarios|media|cmake|CONTRIBUTING\\.md|\\.github)")
foreach(file ${files})
  file(READ "${file}" before)
  # A `[` or `;` in a page means nothing here: the text is never used as a list.
  string(REGEX REPLACE "\\[([^][]*)\\]\\((\\.\\./)*${left_out}(/[^)]*|#[^)]*)?\\)" "\\1 (in the source)" after "${before}")
  if(NOT after STREQUAL before)
    file(WRITE "${file}" "${after}")
  endif()
endforeach()
