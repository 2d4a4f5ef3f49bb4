#pragma once

#include "sim2d/world/World.h"
