#pragma once

#include <string>
#include <vector>

#include "app/capsule/Archive.h"
#include "app/capsule/StudySource.h"
#include "sim2d/base/Result.h"

namespace capsule {

/// The members of a capsule for readers: README.txt, methods.html (procedures, versions, inputs and
/// seeds) and references.bib.
base::Result<std::vector<ArchiveMember>> textMembers(const StudySource& source);

}  // namespace capsule
