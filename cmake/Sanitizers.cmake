# SPDX-License-Identifier: BSD-3-Clause

# LATCHWORK_SANITIZE and LATCHWORK_FUZZ apply to every target: a sanitizer that sees only half of
# a process reports nonsense.
if(LATCHWORK_SANITIZE)
  if(LATCHWORK_SANITIZE MATCHES thread AND LATCHWORK_SANITIZE MATCHES "address|leak")
    message(FATAL_ERROR "LATCHWORK_SANITIZE=${LATCHWORK_SANITIZE}: thread excludes address and leak")
  endif()
  add_compile_options(-fsanitize=${LATCHWORK_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${LATCHWORK_SANITIZE})
endif()

if(LATCHWORK_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "LATCHWORK_FUZZ needs clang (CMAKE_CXX_COMPILER=clang++)")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
  add_link_options(-fsanitize=fuzzer-no-link)
endif()
