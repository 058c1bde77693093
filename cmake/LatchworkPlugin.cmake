# SPDX-License-Identifier: BSD-3-Clause

# latchwork_add_plugin(NAME <name>
#                      SOURCES <file>...
#                      [DATA <file or directory>...]
#                      [LINK <target>...]
#                      [OUTPUT_DIRECTORY <directory>]
#                      [NO_INSTALL])
#
# Builds the plugin <name>.so and lays its data beside it in <name>/, under the names that they
# have relative to the calling directory. OUTPUT_DIRECTORY is ${CMAKE_BINARY_DIR}/plugins unless
# given. Installs into lib/latchwork/plugins below the prefix. Works inside the latchwork tree and,
# after find_package(Latchwork), outside of it.
function(latchwork_add_plugin)
  cmake_parse_arguments(PARSE_ARGV 0 arg "NO_INSTALL" "NAME;OUTPUT_DIRECTORY" "SOURCES;DATA;LINK")
  if(NOT arg_NAME OR NOT arg_SOURCES OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "latchwork_add_plugin: NAME and SOURCES are needed; "
                        "not understood: '${arg_UNPARSED_ARGUMENTS}'")
  endif()
  if(NOT arg_OUTPUT_DIRECTORY)
    set(arg_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/plugins)
  endif()

  set(target latchwork_plugin_${arg_NAME})
  add_library(${target} MODULE ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE Latchwork::sdk ${arg_LINK})
  target_link_options(${target} PRIVATE -Wl,-z,nodelete)
  # With clang the sanitizer runtime is part of the executable only.
  if(NOT (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND LATCHWORK_SANITIZE))
    target_link_options(${target} PRIVATE -Wl,-z,defs)
  endif()
  set_target_properties(${target} PROPERTIES
    PREFIX ""
    OUTPUT_NAME ${arg_NAME}
    LIBRARY_OUTPUT_DIRECTORY ${arg_OUTPUT_DIRECTORY}
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON
    INSTALL_RPATH "$ORIGIN/../..")
  if(COMMAND latchwork_warnings)
    latchwork_warnings(${target})
  endif()

  _latchwork_plugin_data(${target} ${arg_NAME} ${arg_OUTPUT_DIRECTORY} "${arg_NO_INSTALL}"
                         "${arg_DATA}")
  if(NOT arg_NO_INSTALL)
    install(TARGETS ${target} LIBRARY DESTINATION lib/latchwork/plugins COMPONENT plugins)
    if(TARGET latchwork_plugins)
      add_dependencies(latchwork_plugins ${target})
    endif()
  endif()
endfunction()

# Copies each file of `data` when it changes, and makes `target` wait for the copies.
function(_latchwork_plugin_data target name output_directory no_install data)
  set(copies "")
  foreach(entry IN LISTS data)
    set(files ${CMAKE_CURRENT_SOURCE_DIR}/${entry})
    if(IS_DIRECTORY ${files})
      file(GLOB_RECURSE files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${entry}/*)
    endif()
    foreach(file IN LISTS files)
      cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
                 OUTPUT_VARIABLE relative)
      cmake_path(GET relative PARENT_PATH folder)
      set(copy ${output_directory}/${name}/${relative})
      add_custom_command(
        OUTPUT ${copy}
        COMMAND ${CMAKE_COMMAND} -E copy ${file} ${copy}
        DEPENDS ${file}
        COMMENT "Copying ${name}/${relative}"
        VERBATIM)
      list(APPEND copies ${copy})
      if(NOT no_install)
        install(FILES ${file} DESTINATION lib/latchwork/plugins/${name}/${folder}
                COMPONENT plugins)
      endif()
    endforeach()
  endforeach()
  if(copies)
    add_custom_target(${target}_data DEPENDS ${copies})
    add_dependencies(${target} ${target}_data)
  endif()
endfunction()
