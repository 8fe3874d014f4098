# SPDX-License-Identifier: GPL-3.0-or-later
# What the MeshLab source tree in MESHLAB_SOURCE_DIR says about the host that the plugin is for.
#
# Sets MESHLAB_API (2020_09 or 2021_05), MESHLAB_VERSION, MESHLAB_VCG_DIR and the targets
#   meshlab_vcg   VCGlib and the scalar type of the host's meshes
#   meshlab_host  MeshLab's headers and Qt; nothing to link, a plugin's undefined symbols are resolved by the host
set(MESHLAB_SCALAR float CACHE STRING "Scalar type of the host's meshes: float (MeshLab), double (PyMeshLab)")
set_property(CACHE MESHLAB_SCALAR PROPERTY STRINGS float double)
if(NOT MESHLAB_SCALAR MATCHES "^(float|double)$")
  message(FATAL_ERROR "MESHLAB_SCALAR is '${MESHLAB_SCALAR}', but must be float or double.")
endif()

if(EXISTS ${MESHLAB_SOURCE_DIR}/src/common/interfaces.h)
  set(MESHLAB_API 2020_09)
  set(MESHLAB_VCG_DIR ${MESHLAB_SOURCE_DIR}/vcglib)
elseif(EXISTS ${MESHLAB_SOURCE_DIR}/src/common/plugins/interfaces/filter_plugin.h)
  set(MESHLAB_API 2021_05)
  set(MESHLAB_VCG_DIR ${MESHLAB_SOURCE_DIR}/src/vcglib)
else()
  message(FATAL_ERROR "MESHLAB_SOURCE_DIR (${MESHLAB_SOURCE_DIR}) is no source tree of MeshLab 2020.09 to 2025.07: it has "
                      "neither src/common/interfaces.h nor src/common/plugins/interfaces/filter_plugin.h.")
endif()
file(READ ${MESHLAB_SOURCE_DIR}/ML_VERSION MESHLAB_VERSION)
string(STRIP ${MESHLAB_VERSION} MESHLAB_VERSION)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${MESHLAB_SOURCE_DIR}/ML_VERSION)
message(STATUS "Plugin for MeshLab ${MESHLAB_VERSION} (interface of ${MESHLAB_API}, meshes of ${MESHLAB_SCALAR})")

find_package(Qt5 REQUIRED COMPONENTS Core Gui Widgets OpenGL Xml)

add_library(meshlab_vcg INTERFACE)
target_include_directories(meshlab_vcg SYSTEM INTERFACE ${MESHLAB_VCG_DIR})
target_compile_definitions(meshlab_vcg INTERFACE MESHLAB_SCALAR=${MESHLAB_SCALAR})
target_link_libraries(meshlab_vcg INTERFACE Eigen3::Eigen)

add_library(meshlab_host INTERFACE)
target_include_directories(meshlab_host SYSTEM INTERFACE ${MESHLAB_SOURCE_DIR}/src)
target_compile_definitions(meshlab_host INTERFACE MESHLAB_VERSION=${MESHLAB_VERSION})
target_link_libraries(meshlab_host INTERFACE meshlab_vcg Qt5::Core Qt5::Gui Qt5::Widgets Qt5::OpenGL Qt5::Xml)
