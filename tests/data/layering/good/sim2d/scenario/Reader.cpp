#include "sim2d/scenario/Node.h"
