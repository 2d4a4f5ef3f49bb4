#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/map/Outlines.h"

/// Geometry of pedestrian recordings; private to the folder.
namespace sim2d {

struct ForeignInput;
struct TrackFile;

/// Borders of the polygons in a text of WKT ("POLYGON ((0 0, 4 0, 4 3), (1 1, 2 1, 2 2))", also
/// MULTIPOLYGON and collections), in which people walk: the outside and the holes are solid. Other
/// shapes are left out. Errors: the text is not WKT, or has no polygon.
base::Result<std::vector<Outline>> walkableOutlines(const std::string& wkt);

/// Adds the borders, scaled by `unit` [m], as the walls of the file. Text that is not WKT gives a
/// warning; an empty text is ignored.
void addWalkableArea(const std::string& wkt, double unit, const ForeignInput& input,
                     TrackFile& file);

}  // namespace sim2d
