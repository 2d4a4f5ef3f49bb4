#pragma once

#include <string>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/BagTrace.h"

namespace bridge {

/// Makes a record of another program's recording, from its messages alone. Private to the folder
/// (`readBagTrace`).
base::Result<sim2d::Trace> readForeignBag(Bag& bag, const std::string& path, const BagUse& use,
                                          const sim2d::TrackOptions& options,
                                          sim2d::RecordedPoints* points);

}  // namespace bridge
