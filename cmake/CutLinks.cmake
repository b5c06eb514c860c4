# SPDX-License-Identifier: BSD-2-Clause
# In the installed pages below `pages`, replaces links to files of the source that are not installed by plain text.
file(GLOB_RECURSE files "${pages}/*.md")
set(left_out "(docs/dev|dev|tests|src|bench|web|bindings|packaging|editors|scenarios|media|cmake|CONTRIBUTING\\.md|\\.github)")
foreach(file ${files})
  file(READ "${file}" before)
  # A `[` or `;` in a page is harmless here: the text is never used as a list.
  string(REGEX REPLACE "\\[([^][]*)\\]\\((\\.\\./)*${left_out}(/[^)]*|#[^)]*)?\\)" "\\1 (in the source)" after "${before}")
  if(NOT after STREQUAL before)
    file(WRITE "${file}" "${after}")
  endif()
endforeach()
