#include "tests/data/layering_std/own.h"
std::vector<int> numbers = {std::min(1, 2)};
