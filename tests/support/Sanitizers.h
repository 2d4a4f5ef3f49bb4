#pragma once

// gcc says it with a macro, clang with a feature.
#if !defined(__has_feature)
#define __has_feature(x) 0
#endif

/// Crowds that a sanitizer slows down too much are left out there.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || \
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif
