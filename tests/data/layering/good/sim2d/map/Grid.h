#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim2d/base/Types.h"
