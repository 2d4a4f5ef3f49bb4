#include "sim2d/scenario/Reader.h"
