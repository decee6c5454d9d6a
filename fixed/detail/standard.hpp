/// @file
/// Ends the compilation at once, with one message, if the compiler has no C++20. After an #error,
/// compilers go on, and then complain about every line of the type. Each header begins with one
/// that includes this one.
#pragma once

// The feature, because clang-cl has an old __cplusplus, and g++ 10 one that C++20 does not.
#if !defined(__cpp_concepts) || __cpp_concepts < 201907L
#include <fixproof needs C++20, as with -std=c++20>
#endif
