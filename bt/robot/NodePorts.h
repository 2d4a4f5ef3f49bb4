#pragma once

#include <string_view>

namespace bt {

/// In which of Nav2's branches a node has a port, as `sim2d::nav2::isIn` takes it; those of the
/// node where nothing else is known.
unsigned distrosOfPort(std::string_view node, std::string_view port);

}  // namespace bt
