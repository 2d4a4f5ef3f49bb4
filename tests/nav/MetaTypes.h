#pragma once

#include <vector>

#include <QMetaType>

#include "sim2d/base/Types.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

/// Types of columns in the tables of these tests: a declaration has to stand outside of any
/// namespace.
Q_DECLARE_METATYPE(base::Vec2)
Q_DECLARE_METATYPE(std::vector<base::Vec2>)
Q_DECLARE_METATYPE(sim2d::Kinematics)
Q_DECLARE_METATYPE(sim2d::nav2::Distro)
Q_DECLARE_METATYPE(base::Pose2)
