#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/trace/Frame.h"

namespace sim2d {

using FramePtr = std::shared_ptr<const Frame>;

/// States that follow one another as bytes, and back bit by bit: columns of bodies, forces, paths
/// and doors; no events, inputs, tree changes, senses, scans. A number is kept as its difference to
/// what the state before lets one expect, without leading zeros (as FPC does: Burtscher,
/// Ratanaworabhan, "FPC: A High-Speed Compressor for Double-Precision Floating-Point Data", IEEE
/// Trans. Computers 58, 2009; the motion of the bodies takes the place of its tables).
/// `interval`: usual time between two of them [s]; another one costs room only. For this process
/// alone: no format of files. Any thread.
std::string packFrames(const std::vector<FramePtr>& frames, double interval);
/// What packFrames() has made; of nobody where the bytes end early.
std::vector<FramePtr> unpackFrames(std::string_view bytes);
/// Bytes that a state takes unpacked.
std::size_t memoryOf(const Frame& frame);

}  // namespace sim2d
