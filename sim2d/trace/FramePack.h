#pragma once

#include <string>
#include <string_view>

#include "sim2d/trace/Frame.h"

namespace sim2d {

/// The state of a frame (no events, inputs and tree changes) as bytes: its columns, those left out
/// that equal the key's bit by bit. For this process only: no format of files.
std::string packFrame(const Frame& frame, const Frame& key);
Frame unpackFrame(std::string_view bytes, const Frame& key);

}  // namespace sim2d
