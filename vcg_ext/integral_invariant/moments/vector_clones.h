// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One binary for old and new processors: the loader picks the clone, before ThreadSanitizer is ready for it. Elsewhere the
// compiler's default target is used.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define II_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define II_VECTOR_CLONES
#endif
