#pragma once

#include <functional>
#include <string>

#include "sim2d/nav/nav2/params/Nav2Parameters.h"

/// Masks of costmap filters, as Nav2's nodes publish them. A filter subscribes to a
/// `filter_info_topic`; a costmap_filter_info_server publishes there how the mask counts and the
/// topic of the mask; a map_server (`filter_mask_server`) publishes the mask of `yaml_filename`
/// there. Private to this folder.
namespace sim2d::nav2 {

/// Gives the filters of both costmaps the masks that nodes of the file publish on their topics.
/// A filter with a `mask_file` of its own keeps it. `reader` begins to read a node of the file.
void readMasks(Nav2Parameters& to, const std::function<NodeReader(const std::string&)>& reader,
               const ParameterFile& file);

}  // namespace sim2d::nav2
