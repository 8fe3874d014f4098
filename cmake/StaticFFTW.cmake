# SPDX-License-Identifier: GPL-3.0-or-later
# Links FFTW from its static library where there is one that a shared object can take in: a plugin then runs on machines
# without FFTW, and shares no planner with a host that has its own.
option(II_STATIC_FFTW "Link FFTW statically where possible" ON)
if(NOT II_STATIC_FFTW)
  return()
endif()

find_library(FFTW_STATIC_LIBRARY libfftw3f.a HINTS ${FFTW_LIBRARY_DIRS})
if(FFTW_STATIC_LIBRARY AND NOT DEFINED FFTW_STATIC_IS_PIC)
  file(WRITE ${CMAKE_BINARY_DIR}/CMakeFiles/fftw_pic/shared.c
       "void fftwf_cleanup(void);\nvoid probe(void) { fftwf_cleanup(); }\n")
  execute_process(
    COMMAND ${CMAKE_CXX_COMPILER} -x c -fPIC -shared ${CMAKE_BINARY_DIR}/CMakeFiles/fftw_pic/shared.c
            -x none ${FFTW_STATIC_LIBRARY} -Wl,-z,text -lm -o ${CMAKE_BINARY_DIR}/CMakeFiles/fftw_pic/probe.so
    RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(failed)
    set(FFTW_STATIC_IS_PIC OFF CACHE INTERNAL "")
  else()
    set(FFTW_STATIC_IS_PIC ON CACHE INTERNAL "")
  endif()
endif()
if(FFTW_STATIC_LIBRARY AND FFTW_STATIC_IS_PIC)
  set_target_properties(PkgConfig::FFTW PROPERTIES INTERFACE_LINK_LIBRARIES "${FFTW_STATIC_LIBRARY};m")
  message(STATUS "FFTW: static (${FFTW_STATIC_LIBRARY})")
else()
  message(STATUS "FFTW: shared")
endif()
