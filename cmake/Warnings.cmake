# SPDX-License-Identifier: BSD-3-Clause

set(CMAKE_COMPILE_WARNING_AS_ERROR ON CACHE BOOL "Treat warnings as errors")

# Warnings for the targets of this tree. Plugins built elsewhere choose their own.
# Designated initializers leave the other members at their defaults; that is what they are for.
function(latchwork_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wno-missing-field-initializers)
endfunction()
