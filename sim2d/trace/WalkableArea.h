#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/map/Outlines.h"

/// Walkable areas of pedestrian recordings. Private to the folder.
namespace sim2d {

struct TrackInput;
struct TrackFile;

/// Borders of the polygons in a WKT text ("POLYGON ((0 0, 4 0, 4 3), (1 1, 2 1, 2 2))", also
/// MULTIPOLYGON and collections), in which people walk: outside and holes are solid. Other shapes
/// are ignored. Errors: not WKT, or no polygon.
base::Result<std::vector<Outline>> walkableOutlines(const std::string& wkt);

/// Adds the borders, scaled by `unit` [m], as walls of the file. Invalid WKT causes a warning; an
/// empty text is ignored.
void addWalkableArea(const std::string& wkt, double unit, const TrackInput& input, TrackFile& file);

}  // namespace sim2d
