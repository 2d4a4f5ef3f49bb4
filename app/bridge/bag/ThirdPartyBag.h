#pragma once

#include <string>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/BagTrace.h"

namespace bridge {

/// Creates a trace from a third-party recording, using only its messages. Private to this folder
/// (`readBagTrace`).
base::Result<sim2d::Trace> readThirdPartyBag(Bag& bag, const std::string& path,
                                             const BagTopicOptions& use,
                                             const sim2d::TrackOptions& options,
                                             sim2d::RecordedPoints* points);

}  // namespace bridge
