// SPDX-License-Identifier: GPL-3.0-or-later
// By Python's own functions, which the process has or has not: the plugin does not link to Python.
#include "pymeshlab_log.h"

#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

namespace integral_invariant::filter {

namespace {

template <class Function>
Function* find_function(const char* name)
{
#if __has_include(<dlfcn.h>)
  return reinterpret_cast<Function*>(::dlsym(RTLD_DEFAULT, name));
#else
  static_cast<void>(name);
  return nullptr;
#endif
}

/// Leaves no name behind in the user's module.
constexpr const char* run_a_filter_that_ends_well =
    "try: __import__('sys').modules['pymeshlab'].MeshSet().apply_filter('create_cube')\n"
    "except Exception: pass\n";

}  // namespace

void make_pymeshlab_forget_its_log() noexcept
{
  const auto initialized = find_function<int()>("Py_IsInitialized");
  const auto take_lock = find_function<int()>("PyGILState_Ensure");  // its state is an enumeration
  const auto run = find_function<int(const char*, void*)>("PyRun_SimpleStringFlags");
  const auto give_lock_back = find_function<void(int)>("PyGILState_Release");
  if (!initialized || !take_lock || !run || !give_lock_back || !initialized()) return;
  const int state = take_lock();
  run(run_a_filter_that_ends_well, nullptr);
  give_lock_back(state);
}

}  // namespace integral_invariant::filter
