#include "tests/data/layering_std/own.h"
std::vector<int> numbers;  // std::map is a word here
