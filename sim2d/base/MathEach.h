#pragma once

#include <cstddef>

/// The functions of Math.h of many numbers at once, with the same bits.
namespace base {

/// exp of each number, in its place.
void expEach(double* numbers, std::size_t count);

}  // namespace base
