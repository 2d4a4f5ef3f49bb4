#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/studies/ContactReport.h"

namespace app {

/// The contacts of all completed runs of a batch, which are simulated again in worker processes,
/// `options.jobs` at a time; by run. When `wantsStop` returns true, those that are finished.
/// Errors: there is no batch in the folder or it is running; its experiment has an error; an input
/// file has changed since.
base::Result<std::vector<ContactReport>> reportBatchContacts(
    const std::string& folder, const ContactReportOptions& options,
    const sim2d::ImageLoader& loader, const std::function<bool()>& wantsStop,
    const std::function<void(std::size_t done, std::size_t all)>& showProgress);

}  // namespace app
