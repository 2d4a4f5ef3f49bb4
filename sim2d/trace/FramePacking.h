#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/trace/Frame.h"

namespace sim2d {

using FramePtr = std::shared_ptr<const Frame>;

/// Lossless compression of consecutive states: columns of bodies, forces, paths and doors; no
/// events, inputs, tree changes, senses, scans. Numbers are stored as the difference to a
/// prediction from the previous state, without leading zeros (as in FPC: Burtscher, Ratanaworabhan,
/// "FPC: A High-Speed Compressor for Double-Precision Floating-Point Data", IEEE Trans. Computers
/// 58, 2009, with body motion as the predictor). `interval`: usual time between states [s]; other
/// intervals only need more space. The format is private to the process. Thread-safe.
std::string packFrames(const std::vector<FramePtr>& frames, double interval);
/// Restores the states; truncated input gives empty states.
std::vector<FramePtr> unpackFrames(std::string_view bytes);
/// Unpacked size [bytes].
std::size_t unpackedSize(const Frame& frame);

}  // namespace sim2d
