# SPDX-License-Identifier: GPL-3.0-or-later
# Sanitizers and fuzzing for everything that is built. A finding ends the program.
#   II_SANITIZE  address (AddressSanitizer and UndefinedBehaviorSanitizer), thread (ThreadSanitizer), or empty
#   II_FUZZ      programs of libFuzzer, needs clang++
set(II_SANITIZE "" CACHE STRING "address: addresses and undefined behaviour; thread: data races; empty: nothing")
set_property(CACHE II_SANITIZE PROPERTY STRINGS "" address thread)
option(II_FUZZ "Build the fuzz targets as programs of libFuzzer (needs clang++)" OFF)

set(sanitizers "")
if(II_SANITIZE STREQUAL "address")
  # Conversions of numbers that an integer cannot hold are undefined too, but not part of "undefined".
  set(sanitizers -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all)
elseif(II_SANITIZE STREQUAL "thread")
  set(sanitizers -fsanitize=thread)
elseif(NOT II_SANITIZE STREQUAL "")
  message(FATAL_ERROR "II_SANITIZE is '${II_SANITIZE}', but must be address, thread or empty.")
endif()
if(II_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "II_FUZZ needs clang++ (-DCMAKE_CXX_COMPILER=clang++-14): libFuzzer is a part of it.")
  endif()
  list(APPEND sanitizers -fsanitize=fuzzer-no-link)
endif()
if(sanitizers)
  add_compile_options(${sanitizers} -fno-omit-frame-pointer)
  add_link_options(${sanitizers})
endif()
