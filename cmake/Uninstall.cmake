# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DMANIFEST=install_manifest_plugin.txt -P Uninstall.cmake: removes the files that an installation listed.
if(NOT EXISTS ${MANIFEST})
  message(FATAL_ERROR "Nothing to uninstall: ${MANIFEST} does not exist. Install with `cmake --install BUILD --component plugin`.")
endif()
file(STRINGS ${MANIFEST} files)
foreach(file IN LISTS files)
  if(EXISTS $ENV{DESTDIR}${file})
    file(REMOVE $ENV{DESTDIR}${file})
    message(STATUS "Removed $ENV{DESTDIR}${file}")
  else()
    message(STATUS "Not there any more: $ENV{DESTDIR}${file}")
  endif()
endforeach()
