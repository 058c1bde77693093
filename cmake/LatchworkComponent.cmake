# SPDX-License-Identifier: BSD-3-Clause

# All plugins of the tree; what runs an agent depends on it.
add_custom_target(latchwork_plugins)

# latchwork_add_component(NAME <name> [DATA <file or directory>...] [LINK <target>...])
#
# A reasoner, layer or world of this tree, from the *.cc of the calling directory: the plugin
# <name>.so from <name>_plugin.cc, and the library latchwork_<name> from the others, which the
# plugin and the tests link. A folder without <name>_plugin.cc becomes the library alone, one
# without sources nothing.
function(latchwork_add_component)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME" "DATA;LINK")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cc)
  set(plugin_source ${CMAKE_CURRENT_SOURCE_DIR}/${arg_NAME}_plugin.cc)
  list(REMOVE_ITEM sources ${plugin_source})

  set(libraries ${arg_LINK})
  if(sources)
    add_library(latchwork_${arg_NAME} STATIC ${sources})
    target_include_directories(latchwork_${arg_NAME} PUBLIC ${PROJECT_SOURCE_DIR})
    target_link_libraries(latchwork_${arg_NAME} PUBLIC Latchwork::sdk ${arg_LINK})
    set_target_properties(latchwork_${arg_NAME} PROPERTIES CXX_VISIBILITY_PRESET hidden
                                                           VISIBILITY_INLINES_HIDDEN ON)
    latchwork_warnings(latchwork_${arg_NAME})
    list(PREPEND libraries latchwork_${arg_NAME})
  endif()
  if(EXISTS ${plugin_source})
    latchwork_add_plugin(NAME ${arg_NAME} SOURCES ${plugin_source} DATA ${arg_DATA}
                         LINK ${libraries})
    target_include_directories(latchwork_plugin_${arg_NAME} PRIVATE ${PROJECT_SOURCE_DIR})
  endif()
endfunction()
