#pragma once

#include <QImage>
#include <QSize>

#include "sim2d/trace/Trace.h"

namespace app {

/// The picture of a run for a paper: map and obstacles on white, trajectories fading from light to
/// full in time, starts as rings, goals as pins, legend and scale beside the map. Needs a
/// QGuiApplication (fonts).
QImage drawRun(const sim2d::Trace& trace, const QSize& size = {1600, 1000});

}  // namespace app
