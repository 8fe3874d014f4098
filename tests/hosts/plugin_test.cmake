# SPDX-License-Identifier: GPL-3.0-or-later
# Loads the plugin that was built into MeshLab's own library, where this machine has that of the same release.
if(NOT MESHLAB_API STREQUAL 2020_09)
  message(STATUS "plugin_test: not built; it is written for MeshLab 2020.09, and this plugin is for ${MESHLAB_VERSION}")
  return()
endif()
find_library(MESHLAB_COMMON_LIBRARY meshlab-common PATH_SUFFIXES meshlab)
if(NOT MESHLAB_COMMON_LIBRARY)
  message(STATUS "plugin_test: not built; no libmeshlab-common (install meshlab, or set MESHLAB_COMMON_LIBRARY)")
  return()
endif()

get_filename_component(meshlab_library_dir ${MESHLAB_COMMON_LIBRARY} DIRECTORY)
ii_test(hosts plugin_test)
target_link_libraries(plugin_test PRIVATE filter_core meshlab_host ${MESHLAB_COMMON_LIBRARY})
target_compile_definitions(plugin_test PRIVATE PLUGIN_FILE="$<TARGET_FILE:filter_feature_adapted_ii>")
set_target_properties(plugin_test PROPERTIES BUILD_RPATH ${meshlab_library_dir})
add_dependencies(plugin_test filter_feature_adapted_ii)
