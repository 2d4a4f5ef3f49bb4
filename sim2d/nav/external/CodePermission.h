#pragma once

namespace sim2d {

/// A scenario file alone never runs code: whoever starts the run must have said so (--allow-code,
/// or a question in the window).
struct CodePermission {
  bool allowed = false;
};

}  // namespace sim2d
