# SPDX-License-Identifier: BSD-3-Clause
# Installs latchwork, builds a plugin against what was installed, and has the installed command
# load it. Run with -D BINARY_DIR, SOURCE_DIR (of the plugin), AGENT (a file to check), WORK_DIR,
# COMPILER, FLAGS.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output
                  RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: ${result}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(prefix ${WORK_DIR}/prefix)
set(plugin_build ${WORK_DIR}/build)
file(REMOVE_RECURSE ${prefix} ${plugin_build})

run(${CMAKE_COMMAND} --install ${BINARY_DIR} --prefix ${prefix})
run(${CMAKE_COMMAND} -G Ninja -S ${SOURCE_DIR} -B ${plugin_build} -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${plugin_build})
run(${CMAKE_COMMAND} --install ${plugin_build} --prefix ${prefix})
foreach(file IN ITEMS corridor.so corridor/corridor.p)
  if(NOT EXISTS ${prefix}/lib/latchwork/plugins/${file})
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()

run(${prefix}/bin/latchwork check ${AGENT})
run(${prefix}/bin/latchwork plugin show corridor)
if(NOT output MATCHES "keeps its distance from the walls")
  message(FATAL_ERROR "the plugin does not introduce itself:\n${output}")
endif()
