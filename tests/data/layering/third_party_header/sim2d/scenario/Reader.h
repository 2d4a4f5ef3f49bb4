#pragma once

#include "sim2d/scenario/Node.h"
